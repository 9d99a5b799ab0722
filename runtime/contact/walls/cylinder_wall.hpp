// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/walls/any_wall.hpp"

namespace dem::runtime {

/// Whether a side from z = 0 to `length`, perhaps infinite, is there at a height [m].
template <class Real>
MaskOf<Real> side_reaches(const Real& length, const Real& z) {
    const MaskOf<Real> is_endless = no(length < std::numeric_limits<double>::infinity());
    if (all(is_endless)) return is_endless;
    return either(is_endless, both(z >= 0.0, z <= length));
}

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
    bool reaches(double z) const { return side_reaches(length, z); }

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
template <class Real>
struct TubeFieldOf : ExactField {
    struct Sample {
        Real distance;
    };

    WallFrameOf<Real> frame;
    Real radius, length;  ///< as in CylinderWall [m]

    Sample sample(const Vec3Of<Real>& x) const { return {radius - frame.at(x).r}; }
    Vec3Of<Real> gradient(const Vec3Of<Real>& x, const Sample& /*s*/) const {
        return -frame.at(x).radial;
    }
    MaskOf<Real> accepts(const Vec3Of<Real>& x) const {
        return side_reaches<Real>(length, (x - frame.origin).dot(frame.axis));
    }
    /// None.
    static MaskOf<Real> lets_pass(const Vec3Of<Real>& /*center*/) { return Real{} > 0.0; }
    Real clearance(const Vec3Of<Real>& x) const {
        const AxialPointOf<Real> p = frame.at(x);
        const Real inwards = radius - p.r;
        const Real beyond = CylinderWall{radius, length}.beyond_end(p.z);
        return beyond > 0.0 ? math::hypot(std::max(0.0, inwards), beyond) : inwards;
    }
};
using TubeField = TubeFieldOf<double>;

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
    return inside ? use(TubeField{{slack}, frame, radius, length})
                  : use(RodField{{slack}, frame, *this});
}

}  // namespace dem::runtime
