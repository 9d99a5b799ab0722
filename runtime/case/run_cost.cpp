// SPDX-License-Identifier: BSD-3-Clause
// Twice what docs/benchmarks.md measured on an idle machine of 3 to 3.7 GHz: beds differ.
#include "runtime/case/run_cost.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

struct SecondsPerStep {
    double operator()(const Sphere& /*sphere*/) const { return 0.5e-6; }
    double operator()(const SrShape& sr) const { return sr.is_convex ? 1.4e-6 : 3e-6; }
    double operator()(const Clump& clump) const {
        return 1.5e-6 + 5e-9 * static_cast<double>(clump.spheres.size());
    }
    double operator()(const ConvexShape& shape) const {
        if (shape.core == ConvexShape::Core::ellipsoid) return 2e-6;
        // Flat faces share patches with others; spheres and capsules have none.
        const bool is_round =
            shape.core == ConvexShape::Core::polyhedron && shape.vertices.size() < 3;
        return is_round ? 2.5e-6 : 5e-6;
    }
};

/// What one value of a measure costs, of all bodies [s].
double seconds(const MeasureSettings& measure, double bodies, double triangles) {
    switch (measure.kind) {
        case MeasureSettings::Kind::contacts:
            return 2e-8 * bodies;
        case MeasureSettings::Kind::fill_height:
            return 1e-6 * bodies + 4e-8 * triangles;
        case MeasureSettings::Kind::solid_fraction:
            return 2e-2 + 4e-6 * bodies;  // forty thousand points, each in a body or not
    }
    return 0.0;
}

}  // namespace

double last_insertion(const InsertionGroup& group) {
    if (group.mode != InsertionGroup::Mode::batches) return group.start;
    const std::uint64_t batches = (group.count + group.batch - 1) / group.batch;
    return group.start + static_cast<double>(batches - 1) * group.every;
}

RunCost run_cost(const Scene& scene, double from, double dt) {
    RunCost cost;
    double bodies = 0.0;
    double triangles = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        const double average_start = 0.5 * (group.start + last_insertion(group));
        const double steps = std::max(0.0, scene.run.end_time - std::max(average_start, from)) / dt;
        const auto count = static_cast<double>(group.count);
        const ParticleTemplate& shape = scene.shapes[scene.kinds[group.kinds.front()].shape];
        cost.steps += count * steps * std::visit(SecondsPerStep{}, shape.shape);
        bodies += count;
        triangles += count * static_cast<double>(shape.display_mesh.triangles.size());
    }
    const double history_every = scene.output.history_every.value_or(scene.run.end_time / 1000.0);
    for (const MeasureSettings& measure : scene.measures) {
        const double every = measure.every.value_or(history_every);
        if (!(every > 0.0)) continue;
        const double values = std::max(0.0, scene.run.end_time - from) / std::max(every, dt);
        cost.measures += values * seconds(measure, bodies, triangles);
    }
    return cost;
}

}  // namespace dem::runtime
