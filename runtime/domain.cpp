// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/domain.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

// A body of revolution about `axis` from a to b.
void extend_by_cylinder(Aabb& box, const Vec3& a, const Vec3& b, double radius) {
    const Vec3 half = Vec3::Constant(radius);
    box.extend(Aabb{a.cwiseMin(b) - half, a.cwiseMax(b) + half});
}

struct ExtendByWall {
    Aabb& box;
    const WallState& state;

    void operator()(const PlaneWall& plane) const {
        const double radius = std::isinf(plane.radius) ? 0.0 : plane.radius;
        extend_by_cylinder(box, state.position, state.position, radius);
    }
    void operator()(const CylinderWall& cylinder) const {
        const double length = std::isinf(cylinder.length) ? 0.0 : cylinder.length;
        const Vec3 end = state.position + length * (state.body.orientation * Vec3::UnitZ());
        extend_by_cylinder(box, state.position, end, cylinder.radius);
    }
};

struct ExtendByRegion {
    Aabb& box;
    void operator()(const BoxRegion& region) const { box.extend(region.box); }
    void operator()(const CylinderRegion& region) const {
        extend_by_cylinder(box, region.from, region.to, region.radius);
    }
};

double active_time(const WallMotion& motion, double end_time) {
    return std::max(0.0, std::min(motion.until, end_time) - motion.from);
}

// How far the wall's origin can get from where it is at time 0 [m].
double displacement_bound(const Wall& wall, double end_time) {
    const WallMotion& motion = wall.motion;
    switch (motion.kind) {
        case WallMotion::Kind::none:
            return 0.0;
        case WallMotion::Kind::translate:
            return motion.velocity.norm() * active_time(motion, end_time);
        case WallMotion::Kind::rotate:
            return 2.0 * (wall.position - motion.point).norm();
        case WallMotion::Kind::oscillate:
            return motion.amplitude;
    }
    return 0.0;
}

// Of surface points within `reach` [m] of the axis [m/s].
double speed_bound(const WallMotion& motion, double reach) {
    switch (motion.kind) {
        case WallMotion::Kind::none:
            return 0.0;
        case WallMotion::Kind::translate:
            return motion.velocity.norm();
        case WallMotion::Kind::rotate:
            return std::abs(motion.rate) * reach;
        case WallMotion::Kind::oscillate:
            return 2.0 * pi * motion.frequency * motion.amplitude;
    }
    return 0.0;
}

double largest_initial_speed(const Scene& scene) {
    double speed = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        speed = std::max(speed, group.velocity.norm());
        for (const BodyPlacement& body : group.placements) {
            speed = std::max(speed, body.velocity.norm());
        }
    }
    return speed;
}

Aabb extent_or_origin(const Scene& scene) {
    const Aabb box = scene_extent(scene);
    return box.is_empty() ? Aabb{Vec3::Zero(), Vec3::Zero()} : box;
}

}  // namespace

Aabb scene_extent(const Scene& scene) {
    Aabb box;
    for (const Wall& wall : scene.walls) {
        std::visit(ExtendByWall{box, wall_state(wall, 0.0)}, wall.shape);
    }
    for (const InsertionGroup& group : scene.insertions) {
        if (group.mode != InsertionGroup::Mode::file) {
            std::visit(ExtendByRegion{box}, group.region);
        }
        for (const BodyPlacement& body : group.placements) box.extend(body.position);
    }
    return box;
}

double largest_expected_speed(const Scene& scene) {
    const Aabb box = extent_or_origin(scene);
    const Vec3 edges = box.upper - box.lower;
    // Height times g, whatever the direction of gravity.
    const double fall = edges.dot(scene.run.gravity.cwiseAbs());
    double wall_speed = 0.0;
    for (const Wall& wall : scene.walls) {
        wall_speed = std::max(wall_speed, speed_bound(wall.motion, edges.norm()));
    }
    return std::sqrt(square(largest_initial_speed(scene)) + 2.0 * fall) + wall_speed;
}

Aabb domain(const Scene& scene) {
    if (scene.run.domain) return *scene.run.domain;
    const Aabb box = extent_or_origin(scene);
    const double time = scene.run.end_time;

    double room = (box.upper - box.lower).maxCoeff() + largest_initial_speed(scene) * time;
    double largest_radius = 0.0;
    for (const ParticleTemplate& shape : scene.shapes) {
        largest_radius = std::max(largest_radius, shape.bounding_radius);
    }
    double wall_room = 0.0;
    for (const Wall& wall : scene.walls) {
        wall_room = std::max(wall_room, displacement_bound(wall, time));
    }
    room += wall_room + 100.0 * largest_radius;
    if (scene.walls.empty()) room += 0.5 * scene.run.gravity.norm() * square(time);
    return {(box.lower.array() - room).max(-farthest_coordinate),
            (box.upper.array() + room).min(farthest_coordinate)};
}

}  // namespace dem
