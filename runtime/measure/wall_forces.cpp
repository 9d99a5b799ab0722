// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/wall_forces.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace dem::runtime {

namespace {

struct TouchedWall {
    std::uint32_t wall, body;
    const PairResult* result;
    const ForceParts* parts;
};

/// The contacts with walls, by wall and then by body.
std::vector<TouchedWall> touched_walls(const NeighborLists& lists) {
    std::vector<TouchedWall> touched;
    for_each_list(lists.walls, [&](const auto& list) {
        for (std::uint32_t k = 0; k < list.size(); ++k) {
            const std::uint32_t r = list.first_result + k;
            if (lists.touching[r] == 0) continue;
            touched.push_back({list.ids[k].j, list.ids[k].i, &lists.results[r], &list.parts[k]});
        }
    });
    std::sort(touched.begin(), touched.end(), [](const TouchedWall& a, const TouchedWall& b) {
        return a.wall != b.wall ? a.wall < b.wall : a.body < b.body;
    });
    return touched;
}

void add(const WallForce& part, WallForce& sum) {
    sum.force += part.force;
    sum.torque += part.torque;
    sum.normal += part.normal;
    sum.shear += part.shear;
    sum.power += part.power;
}

/// The faces that one [wall.NAME] has become: walls `first` to `last` of the scene.
struct WallSection {
    std::string_view name;
    std::size_t first, last;

    bool has_faces() const { return last > first + 1; }
};

std::string_view section_name(const Wall& wall) {
    return std::string_view(wall.name).substr(0, wall.name.find('.'));
}

std::vector<WallSection> wall_sections(const Scene& scene) {
    std::vector<WallSection> sections;
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const std::string_view name = section_name(scene.walls[w]);
        if (sections.empty() || sections.back().name != name) sections.push_back({name, w, w});
        sections.back().last = w + 1;
    }
    return sections;
}

void add_columns(const std::string& name, std::vector<std::string>& columns) {
    for (const char* quantity : {"_force_x", "_force_y", "_force_z", "_torque_x", "_torque_y",
                                 "_torque_z", "_normal", "_shear", "_power"})
        columns.push_back(name + quantity);
}

void add_values(const WallForce& of, std::vector<double>& values) {
    values.insert(values.end(), of.force.begin(), of.force.end());
    values.insert(values.end(), of.torque.begin(), of.torque.end());
    values.insert(values.end(), {of.normal, of.shear, of.power});
}

}  // namespace

std::vector<WallForce> wall_forces(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    const double step = simulation.steps() > 0 ? simulation.time_step() : 0.0;
    std::vector<WallForce> forces(scene.walls.size());
    for (const TouchedWall& contact : touched_walls(simulation.lists())) {
        const Vec3 force = -Vec3(contact.result->force);
        const Vec3 lever = simulation.walls().state[contact.wall].position -
                           scene.walls[contact.wall].torque_point;
        add({force, Vec3(contact.result->torque_j) + lever.cross(force), contact.parts->normal,
             contact.parts->shear, step > 0.0 ? contact.result->wall_work / step : 0.0},
            forces[contact.wall]);
    }
    return forces;
}

std::vector<std::string> face_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Wall& wall : scene.walls) names.push_back(wall.name);
    for (const WallSection& section : wall_sections(scene)) {
        if (!section.has_faces()) continue;
        for (std::size_t w = section.first; w < section.last; ++w)
            if (names[w].find('.') == std::string::npos) names[w] += ".side";
    }
    return names;
}

std::vector<std::string> wall_force_columns(const Scene& scene) {
    std::vector<std::string> columns;
    if (scene.output.wall_forces == WallForceColumns::none) return columns;
    const std::vector<std::string> names = face_names(scene);
    for (const WallSection& section : wall_sections(scene)) {
        add_columns(std::string(section.name), columns);
        if (scene.output.wall_forces != WallForceColumns::faces || !section.has_faces()) continue;
        for (std::size_t w = section.first; w < section.last; ++w) add_columns(names[w], columns);
    }
    return columns;
}

std::vector<double> wall_force_values(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    std::vector<double> values;
    if (scene.output.wall_forces == WallForceColumns::none) return values;
    const std::vector<WallForce> forces = wall_forces(simulation);
    for (const WallSection& section : wall_sections(scene)) {
        WallForce whole;
        for (std::size_t w = section.first; w < section.last; ++w) add(forces[w], whole);
        add_values(whole, values);
        if (scene.output.wall_forces != WallForceColumns::faces || !section.has_faces()) continue;
        for (std::size_t w = section.first; w < section.last; ++w) add_values(forces[w], values);
    }
    return values;
}

}  // namespace dem::runtime
