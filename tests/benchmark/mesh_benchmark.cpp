// SPDX-License-Identifier: GPL-3.0-or-later
// From the file to answers: loading and repair, then nearest points and inside or outside at the
// points of a grid of d_eq/100 over the box of the bunny (the full one where data/fetch-meshes got
// it). One line a figure, the best of three.
//   mesh_benchmark [MESH]
#include "shapegen/import/load_mesh.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <vector>

namespace dem::shapegen {
namespace {

template <class Work>
double best_seconds(const Work& work) {
    double best = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 3; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        best = std::min(best, elapsed.count());
    }
    return best;
}

std::vector<Vec3> grid_points(const TriangleMesh& mesh) {
    const double spacing = equivalent_diameter(enclosed_volume(mesh)) / 100.0;
    const Aabb box = bounding_box(mesh);
    const Eigen::Vector3i cells = ((box.upper - box.lower) / spacing).cast<int>();
    std::vector<Vec3> points;
    for (int i = 0; i <= cells.x(); ++i)
        for (int j = 0; j <= cells.y(); ++j)
            for (int k = 0; k <= cells.z(); ++k)
                points.emplace_back(box.lower + spacing * Vec3(i, j, k));
    return points;
}

void run(const std::filesystem::path& path) {
    LoadedMesh loaded;
    const double load = best_seconds([&] { loaded = load_mesh(path); });
    std::printf("%s: %zu triangles\n", path.c_str(), loaded.mesh.triangles.size());
    std::printf("load and repair    %8.3f s\n", load);
    std::printf("build the tree     %8.3f s\n",
                best_seconds([&] { const SurfaceQuery query(loaded.mesh); }));
    const SurfaceQuery query(loaded.mesh);
    const std::vector<Vec3> points = grid_points(loaded.mesh);
    std::vector<Vec3> inside;
    const double inside_seconds = best_seconds([&] {
        inside.clear();
        std::copy_if(points.begin(), points.end(), std::back_inserter(inside),
                     [&query](const Vec3& p) { return query.is_inside(p); });
    });
    std::printf("inside or outside  %8.3f us a point of the box, %zu of %zu inside\n",
                1e6 * inside_seconds / static_cast<double>(points.size()), inside.size(),
                points.size());
    double sum = 0.0;
    const double distance_seconds = best_seconds([&] {
        sum = 0.0;
        for (const Vec3& p : inside) sum += query.distance(p);
    });
    std::printf("nearest point      %8.3f us a point inside, %.6g m away on average\n",
                1e6 * distance_seconds / static_cast<double>(inside.size()),
                sum / static_cast<double>(inside.size()));
}

}  // namespace
}  // namespace dem::shapegen

int main(int argc, char** argv) {
    try {
        const std::filesystem::path meshes = std::filesystem::path(DEM_SOURCE_DIR) / "data/meshes";
        const std::filesystem::path full = meshes / "full/stl-models/objects/bunny.bin.stl";
        dem::shapegen::run(argc > 1 ? argv[1] : exists(full) ? full : meshes / "bunny.ply");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mesh_benchmark: error: %s\n", error.what());
        return 1;
    }
}
