// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/walls/any_wall.hpp"

namespace dem::runtime {

/// The half space z < 0; the wall's origin lies on the plane. With a finite radius only the disc of
/// that radius about the origin acts, and only on bodies whose center is in front of it.
struct PlaneWall {
    static constexpr std::string_view name = "plane";

    double radius = std::numeric_limits<double>::infinity();  ///< [m]

    bool is_disc() const { return radius < std::numeric_limits<double>::infinity(); }

    template <class Use>
    auto with_field(const WallFrame& frame, double slack, const Use& use) const;

    WallExtent extent() const { return {0.0, 0.0, is_disc() ? radius : 0.0}; }
    /// A region wholly behind a disc is another room.
    bool confines(double /*low*/, double high) const { return !is_disc() || high > 0.0; }
    /// None: discs are the ends of cylinders, whose circles show them, and what is seen of a plane
    /// without end depends on the other walls.
    static WallOutline outline(double /*low*/, double /*high*/) { return {}; }
    static double surface_turn(const Quat& before, const Quat& after) {
        return axis_tilt(before, after);
    }
};

/// A plane or a disc, positive in front of it.
struct PlaneField : ExactField {
    struct Sample {
        double distance;
    };

    WallFrame frame;
    PlaneWall wall;

    double distance(const Vec3& x) const { return (x - frame.origin).dot(frame.axis); }
    Sample sample(const Vec3& x) const { return {distance(x)}; }
    Vec3 gradient(const Vec3& /*x*/, const Sample& /*s*/) const { return frame.axis; }
    bool accepts(const Vec3& x) const {
        return !wall.is_disc() ||
               (x - frame.origin).cross(frame.axis).squaredNorm() <= square(wall.radius);
    }
    bool lets_pass(const Vec3& center) const { return wall.is_disc() && distance(center) < 0.0; }
    /// Bodies behind a disc are let through until their center is in front: both sides count.
    double clearance(const Vec3& x) const {
        if (!wall.is_disc()) return distance(x);
        const AxialPoint p = frame.at(x);
        return math::hypot(std::max(0.0, p.r - wall.radius), p.z);
    }
};

template <class Use>
auto PlaneWall::with_field(const WallFrame& frame, double slack, const Use& use) const {
    return use(PlaneField{{slack}, frame, *this});
}

}  // namespace dem::runtime
