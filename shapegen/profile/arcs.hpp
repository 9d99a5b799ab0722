// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_segment.hpp"

#include <optional>
#include <span>
#include <vector>

/// Arcs and curves by what a drawing says about them. Lengths in meters.
namespace dem::shapegen {

/// How an arc gets from its start to its end.
struct ArcSense {
    bool turns_left = true;  ///< bulges away from the axis on a path that runs upwards
    bool is_large = false;   ///< more than half of the circle
};

/// Arc of an axis-aligned ellipse with semi-axes a (along r) and b (along z) between two points;
/// a circle when a == b. Empty when the points are too far apart for it.
std::optional<EllipseArc> arc_between(const Vec2& from, const Vec2& to, double a, double b,
                                      ArcSense sense);

/// Arc of the circle through three points, from the first by the second to the third. Empty when
/// they lie on a line.
std::optional<EllipseArc> arc_through(const Vec2& from, const Vec2& middle, const Vec2& to);

/// A corner between two lines or circular arcs rounded by an arc tangent to both.
struct Fillet {
    ProfileSegment before, arc, after;
};

/// The fillet of a radius at the joint of two segments; empty when they are not lines or circular
/// arcs, run smoothly into each other, or are too short for the radius.
std::optional<Fillet> fillet(const ProfileSegment& before, const ProfileSegment& after,
                             double radius);

/// Twice continuously differentiable cubic spline through the points, parametrized by chord length,
/// one Bezier segment between each two. `first_tangent` and `last_tangent` fix its directions at
/// the ends (unit vectors); an end without one has no curvature.
std::vector<ProfileSegment> cubic_spline(std::span<const Vec2> points,
                                         const std::optional<Vec2>& first_tangent,
                                         const std::optional<Vec2>& last_tangent);

}  // namespace dem::shapegen
