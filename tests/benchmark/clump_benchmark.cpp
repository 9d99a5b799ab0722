// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of a mesh or a profile: how many inscribed spheres a coverage takes, and how well a given
// number of fitted spheres stands for the body, by the independent judge.
//   clump_benchmark FILE VOXELS_PER_DIAMETER GOAL ...
// GOAL: a coverage below 1 (inscribed) or a number of spheres (fitted, protrusion 0.05 d_eq).
#include "common/math/types.hpp"
#include "formats/profile_file.hpp"
#include "shapegen/clump/build_clump.hpp"
#include "shapegen/import/load_mesh.hpp"
#include "shapegen/revolution/display_mesh.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace dem {
namespace {

constexpr double revolved_tolerance = 2e-5;  // of the length of the major axis

TriangleMesh load(const std::string& path) {
    if (!path.ends_with(".profile")) {
        MeshLoadOptions options;
        options.repair_limit = 0.05;  // the bunny's open base
        return load_mesh(path, options).mesh;
    }
    const Profile profile = read_profile(path).profile;
    const DisplayMesh mesh =
        display_mesh(profile, revolved_tolerance * profile.major_axis_length());
    return {{mesh.vertices.begin(), mesh.vertices.end()},
            {mesh.triangles.begin(), mesh.triangles.end()}};
}

void measure(const TriangleMesh& mesh, double goal, const ClumpOptions& common) {
    ClumpOptions options = common;
    if (goal < 1.0) {
        options.goal.coverage = goal;
        options.is_inscribed = true;
    } else {
        options.goal.count = static_cast<std::size_t>(goal);
    }
    const auto start = std::chrono::steady_clock::now();
    const BuiltClump clump = build_clump(mesh, options);
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
}  // namespace dem

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: clump_benchmark FILE VOXELS_PER_DIAMETER GOAL ...\n", stderr);
        return 2;
    }
    const dem::TriangleMesh mesh = dem::load(argv[1]);
    dem::ClumpOptions options;
    options.per_diameter = std::atof(argv[2]);
    options.protrusion = 0.05;
    std::puts(
        "goal,spheres,coverage %,uncovered + outside %,outside %,volume %,RMS deviation % d_eq,"
        "max in %,max out %,moment x %,moment y %,moment z %,slope RMS deg,ceiling %,s");
    for (int i = 3; i < argc; ++i) dem::measure(mesh, std::atof(argv[i]), options);
}
