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
template <class Real>
struct PlaneFieldOf : ExactField {
    struct Sample {
        Real distance;
    };

    WallFrameOf<Real> frame;
    Real radius;  ///< of the disc, or infinite [m]

    MaskOf<Real> is_disc() const { return radius < std::numeric_limits<double>::infinity(); }
    Real distance(const Vec3Of<Real>& x) const { return (x - frame.origin).dot(frame.axis); }
    Sample sample(const Vec3Of<Real>& x) const { return {distance(x)}; }
    Vec3Of<Real> gradient(const Vec3Of<Real>& /*x*/, const Sample& /*s*/) const {
        return frame.axis;
    }
    MaskOf<Real> accepts(const Vec3Of<Real>& x) const {
        const MaskOf<Real> is_plane = no(is_disc());
        if (all(is_plane)) return is_plane;
        const Real distance2 = (x - frame.origin).cross(frame.axis).squaredNorm();
        return either(is_plane, distance2 <= square(radius));
    }
    MaskOf<Real> lets_pass(const Vec3Of<Real>& center) const {
        return both(is_disc(), distance(center) < 0.0);
    }
    /// Bodies behind a disc are let through until their center is in front: both sides count.
    Real clearance(const Vec3Of<Real>& x) const {
        if (!is_disc()) return distance(x);
        const AxialPointOf<Real> p = frame.at(x);
        return math::hypot(std::max(0.0, p.r - radius), p.z);
    }
};
using PlaneField = PlaneFieldOf<double>;

template <class Use>
auto PlaneWall::with_field(const WallFrame& frame, double slack, const Use& use) const {
    return use(PlaneField{{slack}, frame, radius});
}

}  // namespace dem::runtime
