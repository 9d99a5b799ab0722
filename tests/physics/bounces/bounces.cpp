// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/thread_team.hpp"
#include "tests/physics/bounces/bounce_table.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

// Elastic, frictionless bounces of every pair of kinds, as a table:
//
//     bounces [COUNT [SHARP_COUNT]] [--divisor N] [--linear] [--pair KIND KIND] [--first SEED]
//
// COUNT bounces of each pair, SHARP_COUNT of those in which both bodies have edges, or one has and
// the other is a wall. Without --divisor the time step is the default one.

namespace dem::test {

using namespace runtime;

namespace {

[[noreturn]] void usage() {
    std::fprintf(stderr,
                 "usage: bounces [COUNT [SHARP_COUNT]] [--divisor N] [--linear] "
                 "[--pair KIND KIND] [--first SEED]\n");
    std::exit(2);
}

Kind kind_of(const char* text) {
    for (const Kind kind : kinds)
        if (std::strcmp(name(kind), text) == 0) return kind;
    usage();
}

}  // namespace
}  // namespace dem::test

int main(int argc, char** argv) {
    using namespace dem::test;
    BounceSettings settings;
    std::uint64_t counts[2] = {1000, 1000};
    int given = 0;
    bool one_pair = false;
    std::uint64_t first = 0;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        if (word == "--divisor" && k + 1 < argc) {
            settings.divisor = std::atof(argv[++k]);
        } else if (word == "--first" && k + 1 < argc) {
            first = std::strtoull(argv[++k], nullptr, 10);
        } else if (word == "--linear") {
            settings.model = dem::runtime::ContactLaw::Model::linear;
        } else if (word == "--pair" && k + 2 < argc) {
            settings.i = kind_of(argv[++k]);
            settings.j = kind_of(argv[++k]);
            one_pair = true;
        } else if (given < 2 && std::atoll(argv[k]) > 0) {
            counts[given++] = std::strtoull(argv[k], nullptr, 10);
            if (given == 1) counts[1] = counts[0];
        } else {
            usage();
        }
    }
    dem::ThreadTeam team(0);
    const dem::ThreadTeam::InForce in_force(&team);
    print_header();
    const auto print = [&] {
        const bool is_sharp =
            has_edges(settings.i) && (has_edges(settings.j) || is_wall(settings.j));
        print_row(settings, bounces(settings, first, counts[is_sharp ? 1 : 0]));
    };
    if (one_pair) {
        print();
        return 0;
    }
    for_every_pair([&](Kind i, Kind j) {
        settings.i = i;
        settings.j = j;
        print();
    });
    return 0;
}
