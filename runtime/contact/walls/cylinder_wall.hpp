// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/walls/any_wall.hpp"

namespace dem::runtime {

/// The side of a cylinder about the wall's z axis from z = 0 to z = length (infinite: both ways
/// without end). `inside`: bodies are kept within; otherwise the cylinder is a solid rod with flat
/// ends. An open end of a finite inside cylinder is a rim: bodies whose contact point lies beyond
/// it are not touched by the side. A vessel is closed by discs of more than its radius and a side
/// that reaches beyond them: a body pressed into the corner has contact points a little outside.
struct CylinderWall {
    static constexpr std::string_view name = "cylinder";

    double radius = 0.0;                                      ///< [m]
    double length = std::numeric_limits<double>::infinity();  ///< [m]
    bool inside = true;

    bool is_endless() const { return length == std::numeric_limits<double>::infinity(); }
    /// How far a height is beyond the nearer end, negative between the ends [m].
    double beyond_end(double z) const {
        return is_endless() ? -std::numeric_limits<double>::infinity() : std::max(-z, z - length);
    }
    /// Whether the side is there at a height.
    bool reaches(double z) const { return is_endless() || (z >= 0.0 && z <= length); }

    template <class Use>
    auto with_field(const WallFrame& frame, double slack, const Use& use) const;

    WallExtent extent() const { return {0.0, is_endless() ? 0.0 : length, radius}; }
    /// Rods may stand in a region, and one wholly beyond an open end is another room.
    bool confines(double low, double high) const {
        return inside && (is_endless() || (high > 0.0 && low < length));
    }
    WallOutline outline(double low, double high) const {
        const Vec2 from(radius, is_endless() ? low : 0.0);
        const Vec2 to(radius, is_endless() ? high : length);
        return {{from, to}, {{from, to}}};
    }
    static double surface_turn(const Quat& before, const Quat& after) {
        return axis_tilt(before, after);
    }
};

/// The inside of a tube: distance from its side, positive within.
struct TubeField : ExactField {
    struct Sample {
        double distance;
    };

    WallFrame frame;
    CylinderWall wall;

    Sample sample(const Vec3& x) const { return {wall.radius - frame.at(x).r}; }
    Vec3 gradient(const Vec3& x, const Sample& /*s*/) const { return -frame.at(x).radial; }
    bool accepts(const Vec3& x) const {
        return wall.is_endless() || wall.reaches((x - frame.origin).dot(frame.axis));
    }
    double clearance(const Vec3& x) const {
        const AxialPoint p = frame.at(x);
        const double inwards = wall.radius - p.r;
        const double beyond = wall.beyond_end(p.z);
        return beyond > 0.0 ? math::hypot(std::max(0.0, inwards), beyond) : inwards;
    }
};

/// A solid rod with flat ends: positive outside.
struct RodField : ExactField {
    struct Sample {
        double distance;
        double side, end;  ///< distances from the endless rod and beyond the nearer end [m]
    };

    WallFrame frame;
    CylinderWall wall;

    Sample sample(const Vec3& x) const {
        const AxialPoint p = frame.at(x);
        const double side = p.r - wall.radius;
        const double end = wall.beyond_end(p.z);
        if (side > 0.0 && end > 0.0) return {math::hypot(side, end), side, end};
        return {std::max(side, end), side, end};
    }
    /// In front of the edge away from it, elsewhere away from the nearer of side and end.
    Vec3 gradient(const Vec3& x, const Sample& s) const {
        const AxialPoint p = frame.at(x);
        const double side = p.r - wall.radius;
        const double end = wall.beyond_end(p.z);
        const Vec3 end_normal = p.z > 0.5 * wall.length ? frame.axis : Vec3(-frame.axis);
        if (side > 0.0 && end > 0.0) return (side * p.radial + end * end_normal) / s.distance;
        return side >= end && p.r > 0.0 ? p.radial : end_normal;
    }
    /// At the edges between side and ends, and in the middle of the rod.
    static bool may_turn_within(const Sample& s, double way) {
        return s.distance < way && std::abs(s.side - s.end) < way;
    }
    double clearance(const Vec3& x) const { return sample(x).distance; }
};

template <class Use>
auto CylinderWall::with_field(const WallFrame& frame, double slack, const Use& use) const {
    return inside ? use(TubeField{{slack}, frame, *this}) : use(RodField{{slack}, frame, *this});
}

}  // namespace dem::runtime
