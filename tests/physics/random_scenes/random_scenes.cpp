// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/random_scenes/random_scene.hpp"
#include "tests/physics/random_scenes/scene_report.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

// What was seen of random scenes, as a table:
//
//     random_scenes [COUNT] [--first SEED] [--divisor N] [--steps N] [--resting]

namespace dem::test {

using namespace runtime;

namespace {

struct Wanted {
    std::uint64_t count = 10;
    std::uint64_t first = 0;
    SceneSteps steps{20'000, 20.0};
    bool resting = false;
};

[[noreturn]] void usage() {
    std::fprintf(stderr,
                 "usage: random_scenes [COUNT] [--first SEED] [--divisor N] [--steps N] "
                 "[--resting]\n");
    std::exit(2);
}

Wanted wanted(int argc, char** argv) {
    Wanted w;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        const bool has_value = k + 1 < argc;
        if (word == "--first" && has_value) {
            w.first = std::strtoull(argv[++k], nullptr, 10);
        } else if (word == "--divisor" && has_value) {
            w.steps.divisor = std::atof(argv[++k]);
        } else if (word == "--steps" && has_value) {
            w.steps.count = std::atoi(argv[++k]);
        } else if (word == "--resting") {
            w.resting = true;
        } else if (std::atoll(argv[k]) > 0) {
            w.count = std::strtoull(argv[k], nullptr, 10);
        } else {
            usage();
        }
    }
    return w;
}

void print(std::uint64_t seed, const SceneReport& r) {
    std::printf("%5llu %9.2e %9.2e %9.3e %8.2f %8.4f %9.2e %9.2e %s%s\n",
                static_cast<unsigned long long>(seed), r.residual, r.event, r.moment, r.fastest,
                r.overlap, r.kinetic, r.moving, r.cores_met ? "cores met " : "",
                r.crushed ? "crushed" : "");
    std::fflush(stdout);
}

}  // namespace
}  // namespace dem::test

int main(int argc, char** argv) {
    using namespace dem::test;
    const Wanted w = wanted(argc, argv);
    std::printf(" seed  residual     event    at [s]  fastest  overlap   kinetic    at end\n");
    for (std::uint64_t seed = w.first; seed < w.first + w.count; ++seed)
        print(seed, report_of(w.resting ? resting_scene(seed) : random_scene(seed, true), w.steps));
    return 0;
}
