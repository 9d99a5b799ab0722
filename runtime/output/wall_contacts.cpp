// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/wall_contacts.hpp"

#include "runtime/measure/wall_forces.hpp"

namespace dem::runtime {

namespace {

/// Values over the areas of the triangles and a time [s]; without `before`, of all since time 0.
std::vector<double> per_area(const std::vector<double>& now, const std::vector<double>& before,
                             const std::vector<double>& area, double time) {
    std::vector<double> result(now.size(), 0.0);
    if (!(time > 0.0)) return result;
    for (std::size_t t = 0; t < now.size(); ++t)
        result[t] = (now[t] - (before.empty() ? 0.0 : before[t])) / (area[t] * time);
    return result;
}

}  // namespace

WallTriangles wall_triangles(const Scene& scene) {
    WallTriangles all;
    all.names = face_names(scene);
    std::uint32_t first = 0;
    for (std::uint32_t w = 0; w < scene.walls.size(); ++w) {
        const auto* wall = std::get_if<MeshWall>(&scene.walls[w].shape);
        if (wall == nullptr) continue;
        const WallMesh& mesh = *wall->mesh;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (const std::uint32_t vertex : mesh.triangles[t])
                all.triangles.push_back(first + vertex);
            all.wall.push_back(w);
            const Vec3 a = mesh.corner(t, 1) - mesh.corner(t, 0);
            const Vec3 b = mesh.corner(t, 2) - mesh.corner(t, 0);
            all.area.push_back(0.5 * a.cross(b).norm());
        }
        first += static_cast<std::uint32_t>(mesh.vertices.size());
    }
    return all;
}

WallContactTable wall_contact_table(const Simulation& simulation, const WallTriangles& walls,
                                    LoadsOfLastFrame& last) {
    const WallLoads& loads = simulation.wall_loads();
    WallContactTable table;
    table.time = simulation.time();
    const Scene& scene = simulation.scene();
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const auto* wall = std::get_if<MeshWall>(&scene.walls[w].shape);
        if (wall == nullptr) continue;
        const WallState& state = simulation.walls().state[w];
        for (const Vec3& v : wall->mesh->vertices) {
            const Vec3 x = state.position + state.body.orientation * v;
            for (const double coordinate : x)
                table.points.push_back(static_cast<float>(coordinate));
        }
    }
    const double interval = table.time - last.time;
    table.pressure = per_area(loads.normal(), last.normal, walls.area, interval);
    table.shear = per_area(loads.shear(), last.shear, walls.area, interval);
    table.friction_power =
        per_area(loads.friction_work(), last.friction_work, walls.area, interval);
    table.sliding_work = per_area(loads.sliding_work(), {}, walls.area, 1.0);
    table.impact_energy = per_area(loads.impact_energy(), {}, walls.area, 1.0);
    last = {table.time, loads.normal(), loads.shear(), loads.friction_work()};
    return table;
}

}  // namespace dem::runtime
