// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of a mesh or a profile: how many inscribed spheres a coverage takes, and how well a given
// number of fitted spheres stands for the body, by the independent judge.
//   clump_benchmark FILE VOXELS_PER_DIAMETER GOAL ...
// GOAL: a coverage below 1 (inscribed) or a number of spheres (fitted, protrusion 0.05 d_eq).
#include "common/math/types.hpp"
#include "shapegen/clump/build_clump.hpp"
#include "shapegen/pipeline/solid.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace dem::shapegen {
namespace {

void measure(const Solid& solid, double goal, const ClumpOptions& common) {
    ClumpOptions options = common;
    CoverGoal cover;
    if (goal < 1.0) {
        cover.coverage = goal;
        options.is_inscribed = true;
    } else {
        cover.count = static_cast<std::size_t>(goal);
    }
    const auto start = std::chrono::steady_clock::now();
    const BuiltClump clump = ClumpMaker(solid.mesh, solid.mass_properties, options).clump(cover);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    const ClumpQuality& q = clump.quality;
    std::printf("%g,%zu,%.4f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.2f,%.4f,%.2f\n", goal,
                clump.balls.size(), 100.0 * q.coverage, 100.0 * (1.0 - q.coverage + q.outside),
                100.0 * q.outside, 100.0 * q.volume_ratio, 100.0 * q.rms_deviation,
                100.0 * q.max_deviation_in, 100.0 * q.max_deviation_out, 100.0 * q.moment_errors[0],
                100.0 * q.moment_errors[1], 100.0 * q.moment_errors[2], q.slope_rms * 180.0 / pi,
                100.0 * clump.ceiling, taken.count());
    std::fflush(stdout);
}

}  // namespace
}  // namespace dem::shapegen

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: clump_benchmark FILE VOXELS_PER_DIAMETER GOAL ...\n", stderr);
        return 2;
    }
    dem::shapegen::MeshLoadOptions loading;
    loading.repair_limit = 0.05;  // the bunny's open base
    const dem::shapegen::Solid solid = dem::shapegen::load_solid(argv[1], loading);
    dem::shapegen::ClumpOptions options;
    options.per_diameter = std::atof(argv[2]);
    options.protrusion = 0.05;
    std::puts(
        "goal,spheres,coverage %,uncovered + outside %,outside %,volume %,RMS deviation % d_eq,"
        "max in %,max out %,moment x %,moment y %,moment z %,slope RMS deg,ceiling %,s");
    for (int i = 3; i < argc; ++i) dem::shapegen::measure(solid, std::atof(argv[i]), options);
}
