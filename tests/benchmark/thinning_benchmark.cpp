// SPDX-License-Identifier: GPL-3.0-or-later
// Voxels and thinning of a body with lobes, dents and a rough surface, with about as many voxels at
// each resolution as any body has. One CSV line per resolution and number of threads: best of five
// runs [s] and, as the proof that every version computes the same, the hash of the surface
// skeleton.
//   thinning_benchmark
#include "common/state_hash.hpp"
#include "common/threads/thread_team.hpp"
#include "shapegen/thinning/thin.hpp"
#include "shapegen/voxel/voxelize.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace dem::shapegen {
namespace {

/// 131 072 triangles; four lobes three times as far out as the dents between them.
TriangleMesh lobed_body() {
    TriangleMesh mesh = sample::sphere(1.0, 7);
    for (Vec3& p : mesh.vertices) {
        const double lobes = std::abs(p.x() * p.y() * p.z()) * 5.2;
        const double side = p.x() * p.y() * p.z() > 0.0 ? 1.0 : -0.35;
        const double rough = std::sin(31.0 * p.x()) * std::sin(29.0 * p.y() + 23.0 * p.z());
        p *= 0.55 + 0.5 * side * lobes + 0.008 * rough;
    }
    return mesh;
}

template <class Work>
double best_time(Work work) {
    double best = 1e30;
    for (int run = 0; run < 5; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        best = std::min(best, taken.count());
    }
    return best;
}

void measure(const TriangleMesh& mesh, int per_diameter, int threads) {
    ThreadTeam team(threads);
    const ThreadTeam::InForce together(&team);
    const double spacing = voxel_spacing(enclosed_volume(mesh), per_diameter);
    VoxelImage image = voxelize(mesh, spacing);
    VoxelImage surface = image;
    const double to_voxelize = best_time([&] { image = voxelize(mesh, spacing); });
    const double to_surface = best_time([&] { surface = thin(image, Skeleton::surface); });
    const double to_curve = best_time([&] { thin(image, Skeleton::curve); });
    StateHash hash;
    const std::vector<Voxel> skeleton = surface.voxels();
    hash.add(std::span<const Voxel>(skeleton));
    std::printf("lobes,%d,%d,%zu,%zu,%.4f,%.4f,%.4f,%016llx\n", per_diameter, threads,
                image.count(), skeleton.size(), to_voxelize, to_surface, to_curve,
                static_cast<unsigned long long>(hash.value()));
}

}  // namespace
}  // namespace dem::shapegen

int main() {
    const dem::shapegen::TriangleMesh mesh = dem::shapegen::lobed_body();
    std::printf("shape,per_diameter,threads,voxels,skeleton,voxelize,surface,curve,hash\n");
    for (const int per_diameter : {60, 100, 200})
        for (const int threads : {1, 2}) dem::shapegen::measure(mesh, per_diameter, threads);
}
