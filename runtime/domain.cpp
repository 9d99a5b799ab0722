// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/domain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dem::runtime {

namespace {

// A body of revolution about `axis` from a to b.
void extend_by_cylinder(Aabb& box, const Vec3& a, const Vec3& b, double radius) {
    const Vec3 half = Vec3::Constant(radius);
    box.extend(Aabb{a.cwiseMin(b) - half, a.cwiseMax(b) + half});
}

void extend_by_wall(Aabb& box, const Wall& wall) {
    if (const auto* mesh = std::get_if<MeshWall>(&wall.shape)) {
        const WallState state = wall_state(wall, 0.0);
        for (const Vec3& v : mesh->mesh->vertices)
            box.extend(state.position + state.body.orientation * v);
        return;
    }
    const WallExtent e = std::visit([](const auto& shape) { return shape.extent(); }, wall.shape);
    const auto [origin, axis] = wall_state(wall, 0.0).frame();
    extend_by_cylinder(box, origin + e.low * axis, origin + e.high * axis, e.radius);
}

/// Where bodies are to get; of a plane it is its point.
void extend_by_outlet(Aabb& box, const Outlet& outlet) {
    if (const auto* plane = std::get_if<HalfSpace>(&outlet.place)) box.extend(plane->point);
    if (const auto* region = std::get_if<BoxRegion>(&outlet.place)) box.extend(region->box);
    if (const auto* region = std::get_if<CylinderRegion>(&outlet.place))
        box.extend(bounds(*region));
}

struct ExtendByRegion {
    Aabb& box;
    void operator()(const BoxRegion& region) const { box.extend(region.box); }
    void operator()(const CylinderRegion& region) const {
        extend_by_cylinder(box, region.from, region.to, region.radius);
    }
};

// Of the wall's origin, of a mesh of its corners [m].
double farthest_from(const Wall& wall, const Vec3& point) {
    double farthest = (wall.position - point).norm();
    if (const auto* mesh = std::get_if<MeshWall>(&wall.shape)) {
        for (const Vec3& v : mesh->mesh->vertices)
            farthest = std::max(farthest, (wall.position + wall.orientation * v - point).norm());
    }
    return farthest;
}

/// How far a wall with one simple piece of motion can get from where it is at time 0 [m].
double displacement_bound(const Wall& wall, const MotionPiece& piece, double end_time) {
    switch (piece.kind) {
        case MotionPiece::Kind::translate:
            return std::max(piece.velocity.norm(), piece.initial_velocity.norm()) *
                   std::max(0.0, std::min(piece.until, end_time) - piece.from);
        case MotionPiece::Kind::rotate:
            return 2.0 * farthest_from(wall, piece.point);
        case MotionPiece::Kind::oscillate:
            return piece.amplitude;
        case MotionPiece::Kind::table:
            break;
    }
    return 0.0;
}

/// How far the wall's origin, or corners of the box around its triangles, are from where they are
/// at time 0 [m].
double displacement(const Wall& wall, const MotionTime& time) {
    const WallState before = wall_state(wall, 0.0);
    const WallState now = wall_state(wall, time);
    double farthest = (now.position - before.position).norm();
    const auto* mesh = std::get_if<MeshWall>(&wall.shape);
    for (int k = 0; mesh != nullptr && k < 8; ++k) {
        const Aabb& box = mesh->mesh->bounds;
        const Vec3 corner((k & 1) != 0 ? box.upper.x() : box.lower.x(),
                          (k & 2) != 0 ? box.upper.y() : box.lower.y(),
                          (k & 4) != 0 ? box.upper.z() : box.lower.z());
        const Vec3 way = now.position + now.body.orientation * corner - before.position -
                         before.body.orientation * corner;
        farthest = std::max(farthest, way.norm());
    }
    return farthest;
}

double displacement_bound(const Wall& wall, double end_time) {
    const Motion& motion = wall.motion;
    if (!motion.moves()) return 0.0;
    const bool is_simple = motion.pieces.size() == 1 && motion.within == nullptr &&
                           std::isinf(motion.period) &&
                           motion.pieces[0].kind != MotionPiece::Kind::table;
    if (is_simple) return displacement_bound(wall, motion.pieces[0], end_time);
    constexpr int looks = 2000;
    double farthest = 0.0;
    for (int k = 0; k <= looks; ++k)
        farthest = std::max(farthest, displacement(wall, {end_time * k / looks, 0.0}));
    return farthest;
}

double initial_speed(const InsertionGroup& group) {
    double speed = group.velocity.norm();
    for (const BodyPlacement& body : group.placements) {
        speed = std::max(speed, body.velocity.norm());
    }
    return speed;
}

double largest_initial_speed(const Scene& scene) {
    double speed = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        speed = std::max(speed, initial_speed(group));
    }
    return speed;
}

Aabb extent_or_origin(const Scene& scene) {
    const Aabb box = scene_extent(scene);
    return box.is_empty() ? Aabb{Vec3::Zero(), Vec3::Zero()} : box;
}

/// Height times g, whatever the direction of gravity [m^2/s^2].
double full_fall(const Scene& scene, const Vec3& edges) {
    return edges.dot(scene.run.gravity.cwiseAbs());
}

double largest_wall_speed(const Scene& scene, double reach) {
    double speed = 0.0;
    for (const Wall& wall : scene.walls) {
        speed = std::max(speed, largest_speed(wall.motion, reach) + wall.surface_velocity.norm());
    }
    return speed;
}

/// The number of the axis along which gravity pulls; none: it pulls aslant or not at all.
std::optional<Eigen::Index> axis_of_gravity(const Scene& scene) {
    Eigen::Index axis = 0;
    const double largest = scene.run.gravity.cwiseAbs().maxCoeff(&axis);
    if (largest > 0.0 && largest == scene.run.gravity.norm()) return axis;
    return std::nullopt;
}

struct Floor {
    double area = 0.0;   ///< of the region, seen along gravity [m^2]
    double cells = 1.0;  ///< of an edge in one layer, no more than there are
};

Floor floor_of(const InsertionGroup& group, Eigen::Index axis, double cell) {
    Vec3 edges;
    double area = 0.0;
    if (const auto* box = std::get_if<BoxRegion>(&group.region)) {
        edges = box->box.upper - box->box.lower;
        area = edges.prod() / edges[axis];
    } else {
        // In the square that the circle holds.
        const double radius = std::get<CylinderRegion>(group.region).radius;
        edges = Vec3::Constant(std::sqrt(2.0) * radius);
        area = pi * square(radius);
    }
    const Vec3 cells = (edges / cell).array().floor().max(1.0);
    return {area, cells.prod() / cells[axis]};
}

/// How far the highest bodies on a lattice come down when it collapses to a dense bed [m]. In
/// tubes of seven diameters they reach the speed of a fall through 0.4 (spheres) to 0.7 (bars twice
/// as long as wide) of it.
double collapse(const Scene& scene, const InsertionGroup& group, Eigen::Index axis) {
    constexpr double densest = 0.64;
    double radius = 0.0;
    double volume = 0.0;
    for (const std::uint32_t kind : group.kinds) {
        const ParticleTemplate& shape = scene.shapes[scene.kinds[kind].shape];
        radius = std::max(radius, shape.bounding_radius);
        volume += shape.mass_properties.volume / static_cast<double>(group.kinds.size());
    }
    // Bodies that are packed from the bottom sink by an eighth of this.
    const double diameter = 2.0 * radius;
    if (group.mode == InsertionGroup::Mode::fill) return diameter;
    const double cell = (1.0 + group.jitter) * diameter;
    const auto count = static_cast<double>(group.count);
    const Floor floor = floor_of(group, axis, cell);
    const double layers = std::ceil(count / floor.cells);
    return std::max(diameter, layers * cell - count * volume / (densest * floor.area));
}

/// How far bodies of a group fall, times g [m^2/s^2].
double fall(const Scene& scene, const InsertionGroup& group, const Aabb& all) {
    const double farthest = full_fall(scene, all.upper - all.lower);
    const bool is_stacked =
        group.mode == InsertionGroup::Mode::lattice || group.mode == InsertionGroup::Mode::fill;
    const auto axis = axis_of_gravity(scene);
    if (!is_stacked || !axis) return farthest;
    const auto* cylinder = std::get_if<CylinderRegion>(&group.region);
    if (cylinder != nullptr) {
        const Vec3 along = cylinder->to - cylinder->from;
        if (std::abs(along[*axis]) < along.norm()) return farthest;
    }
    Aabb region;
    std::visit(ExtendByRegion{region}, group.region);
    const double g = scene.run.gravity[*axis];
    const double ground =
        g < 0.0 ? region.lower[*axis] - all.lower[*axis] : all.upper[*axis] - region.upper[*axis];
    return std::min(farthest, std::abs(g) * (ground + collapse(scene, group, *axis)));
}

/// Whether a wall lifts bodies or makes way for them: all but those that only swing.
bool has_moving_wall(const Scene& scene) {
    const auto swings = [](const MotionPiece& piece) {
        return piece.kind == MotionPiece::Kind::oscillate;
    };
    return std::ranges::any_of(scene.walls, [&](const Wall& wall) {
        return wall.motion.within != nullptr || !wall.surface_velocity.isZero(0.0) ||
               !std::ranges::all_of(wall.motion.pieces, swings);
    });
}

}  // namespace

Aabb scene_extent(const Scene& scene) {
    Aabb box;
    for (const Wall& wall : scene.walls) extend_by_wall(box, wall);
    for (const InsertionGroup& group : scene.insertions) {
        if (group.mode != InsertionGroup::Mode::file) {
            std::visit(ExtendByRegion{box}, group.region);
        }
        for (const BodyPlacement& body : group.placements) box.extend(body.position);
    }
    for (const Outlet& outlet : scene.outlets) extend_by_outlet(box, outlet);
    return box;
}

double largest_expected_speed(const Scene& scene) {
    const Aabb box = extent_or_origin(scene);
    const Vec3 edges = box.upper - box.lower;
    const double fallen = 2.0 * full_fall(scene, edges);
    return std::sqrt(square(largest_initial_speed(scene)) + fallen) +
           largest_wall_speed(scene, edges.norm());
}

double largest_rim_speed(const Scene& scene) {
    double spin = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        spin = std::max(spin, group.angular_velocity.norm());
        for (const BodyPlacement& body : group.placements) {
            spin = std::max(spin, body.angular_velocity.norm());
        }
    }
    double radius = 0.0;
    for (const BodyKind& kind : scene.kinds) {
        radius = std::max(radius, scene.shapes[kind.shape].bounding_radius);
    }
    return spin * radius;
}

double largest_impact_speed(const Scene& scene) {
    const double rim_speed = largest_rim_speed(scene);
    if (has_moving_wall(scene)) return largest_expected_speed(scene) + rim_speed;
    const Aabb box = extent_or_origin(scene);
    double speed = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        speed = std::max(speed,
                         std::sqrt(square(initial_speed(group)) + 2.0 * fall(scene, group, box)));
    }
    return speed + largest_wall_speed(scene, (box.upper - box.lower).norm()) + rim_speed;
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

}  // namespace dem::runtime
