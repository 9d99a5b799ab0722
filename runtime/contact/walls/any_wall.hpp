// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/walls/wall_field.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

#include <array>
#include <concepts>
#include <string_view>
#include <vector>

/// The questions that a wall shape answers: everything that asks walls is written on these, so that
/// a new shape is one file in this folder and its name in wall_shapes.hpp (docs/architecture.md,
/// "How to add a wall shape"). A shape is a plain struct of sizes in the wall's own frame.
namespace dem::runtime {

/// A cylinder about the wall's axis around the part of the wall that has ends; a plane or a side
/// without end adds its origin only.
struct WallExtent {
    double low = 0.0;     ///< along the axis [m]
    double high = 0.0;    ///< [m]
    double radius = 0.0;  ///< [m]
};

/// Lines that show a wall, points as (radius, z) or in space [m].
struct WallOutline {
    std::vector<Vec2> rings;                     ///< circles about the axis
    std::vector<std::array<Vec2, 2>> meridians;  ///< straight, drawn on four sides of the axis
    std::vector<std::array<Vec3, 2>> lines = {};
};

/// Asks a field for its distance: for the concept below.
struct DistanceAtOrigin {
    double operator()(const WallField auto& field) const {
        return field.sample(Vec3::Zero()).distance;
    }
};

template <class Wall>
concept AnyWall = requires(const Wall& wall, const Quat& orientation) {
    /// What checkpoints know its contacts by: never to be given to another.
    requires std::same_as<decltype(Wall::name), const std::string_view>;
    /// What the domain must hold.
    { wall.extent() } -> std::same_as<WallExtent>;
    /// Whether bodies that reach from `low` to `high` along the wall's axis [m] are kept in by it,
    /// so that all of their region must lie in front of it; false for what may stand in a region.
    { wall.confines(0.0, 1.0) } -> std::same_as<bool>;
    /// For pictures; a side without end is drawn from `low` to `high` along the axis [m].
    { wall.outline(0.0, 1.0) } -> std::same_as<WallOutline>;
    /// Bound on the angle by which the wall's surface turns from one orientation to another [rad].
    { wall.surface_turn(orientation, orientation) } -> std::same_as<double>;
};

/// A wall that is a field of distances, which most kernels need no more of. Others have kernels of
/// their own for every kind of body (mesh_wall.hpp).
template <class Wall>
concept FieldWall = AnyWall<Wall> && requires(const Wall& wall, const WallFrame& frame) {
    /// Calls use(field) with the wall as a WallField in a frame and returns what that returns;
    /// `slack`: what rounding may do to distances there [m]. Kernels of contact, distances of walls
    /// and regions ask this.
    { wall.with_field(frame, 0.0, DistanceAtOrigin{}) } -> std::same_as<double>;
};

}  // namespace dem::runtime
