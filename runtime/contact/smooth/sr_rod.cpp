// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/sr_rod.hpp"

#include "runtime/contact/smooth/common_normal.hpp"
#include "runtime/contact/smooth/normal_starts.hpp"
#include "runtime/contact/smooth/planar_outline.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// Nearest approach of the body to the axis: like a ball, with one minimum.
PlanarOutline::Sample nearest_to_axis(const PlanarOutline& outline, Vec2 u) {
    constexpr double stride = 0.2;
    PlanarOutline::Sample s = outline.at(u);
    const double direction = s.slope >= 0.0 ? stride : -stride;
    const int round = static_cast<int>(2.0 * pi / stride) + 2;
    for (int k = 0; k < round; ++k) {
        const Vec2 further = planar::turned(u, direction);
        const PlanarOutline::Sample next = outline.at(further);
        const bool between = s.slope >= 0.0 ? next.slope < 0.0 : next.slope >= 0.0;
        if (between && direction > 0.0) return outline.maximum(u, further);
        if (between) return outline.maximum(further, u);
        u = further;
        s = next;
    }
    return s;
}

/// A solid cylinder about its middle.
struct RodSupport {
    double radius, half_length;  ///< [m]
    Vec3 axis;                   ///< unit

    SupportSample operator()(const Vec3& n) const {
        const double u = n.dot(axis);
        const Vec3 to_axis = axis - u * n;
        const double n_r = to_axis.norm();
        const double end = std::copysign(half_length, u);
        const double h = radius * n_r + end * u;
        if (n_r <= pole) return {h, Vec3::Zero(), 0.0, 0.0, 0.0, 0.0};
        const double across = radius / n_r;
        return {h,      to_axis / n_r, end * n_r - radius * u,
                across, -across,       std::min(n_r, std::abs(u))};
    }
};

/// A body near a rod of finite length.
class RodEnd {
  public:
    RodEnd(const SrSupport& support, const CylinderWall& wall, const WallPose& pose)
        : support_(support), wall_(wall), pose_(pose) {
        const double z = pose.center.dot(pose.axis);
        outward_ = z > 0.5 * wall.length ? pose.axis : Vec3(-pose.axis);
        end_ = z > 0.5 * wall.length ? wall.length : 0.0;
    }

    /// `side`: nearest approach to the axis of the endless rod.
    void touch(const PlanarOutline::Sample& side, WallTouch& touch) const {
        const Vec3 side_point = side.support.point(-side.e);
        const double side_overlap = wall_.radius - side.value;
        const double touched_z = (pose_.center + side_point).dot(pose_.axis);
        const double to_ends = std::min(touched_z, wall_.length - touched_z);
        // Any direction turned by theta towards the end sees at least an overlap of
        // d cos theta + to_ends sin theta.
        if (to_ends >= side_overlap) {
            touch.gap = -side_overlap;
            if (side_overlap > 0.0) touch.add(side_point, side.e, side_overlap, side.support);
            return;
        }
        const SupportSample face = support_(-outward_);
        const Vec3 face_point = face.point(-outward_);
        const double face_overlap = face.h - (pose_.center.dot(outward_) - end_height());
        touch.gap = std::max(-side_overlap, -face_overlap);
        if (touch.gap >= 0.0) return;
        touch.gap = 0.0;
        const Vec3 on_face = pose_.center + face_point;
        const double within_face =
            wall_.radius - (on_face - on_face.dot(pose_.axis) * pose_.axis).norm();
        if (within_face >= face_overlap) {
            touch.add(face_point, outward_, face_overlap, face);
            return;
        }
        const NormalProbe edge = lowest_at_edge(side.e);
        const bool on_side = to_ends >= 0.0 && side_overlap <= edge.f;
        const bool on_end = within_face >= 0.0 && face_overlap <= edge.f;
        if (on_side && !(on_end && face_overlap < side_overlap)) {
            touch.add(side_point, side.e, side_overlap, side.support);
        } else if (on_end) {
            touch.add(face_point, outward_, face_overlap, face);
        } else {
            touch.gap = -edge.f;
            if (edge.f > 0.0) touch.add(edge.i.point(edge.n), -edge.n, edge.f, edge.i);
        }
    }

  private:
    double end_height() const { return pose_.axis.dot(outward_) * end_; }

    /// The lowest of the minima that descents reach from the edge of the rod and from the edges
    /// and faces of the body next to it.
    NormalProbe lowest_at_edge(const Vec3& side) const {
        const RodSupport rod{wall_.radius, 0.5 * wall_.length, pose_.axis};
        const Vec3 d = 0.5 * wall_.length * pose_.axis - pose_.center;
        NormalProbe lowest = common_normal(support_, rod, d, Vec3(-(side + outward_).normalized()));
        if (!(lowest.f > 0.0)) return lowest;
        NormalStarts starts(4.0 * lowest.f);
        for (const Vec3& n : {lowest.n, Vec3(-side), Vec3(-outward_)}) {
            starts.add(n);
            starts.add_meridian(support_, n, 1.0);
            starts.add_tip(support_, n, 1.0, pose_.axis);
        }
        for (const Vec3& start : starts) {
            NormalProbe found = common_normal(support_, rod, d, start);
            if (!(found.f < lowest.f)) continue;
            // On its way past the axis of a flat a direction may have lost its unit length.
            found = common_normal(support_, rod, d, Vec3(found.n.normalized()));
            if (found.f < lowest.f) lowest = found;
        }
        return lowest;
    }

    const SrSupport& support_;
    const CylinderWall& wall_;
    const WallPose& pose_;
    Vec3 outward_;  ///< out of the nearer end
    double end_;    ///< where that is [m]
};

}  // namespace

WallTouch touch_rod(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                    const WallPose& pose) {
    WallTouch touch;
    const Vec3& axis = pose.axis;
    const Vec3 off_axis = pose.center - pose.center.dot(axis) * axis;
    touch.gap = off_axis.norm() - wall.radius - a.bounding_radius;
    if (touch.gap > 0.0) return touch;

    const PlanarOutline outline(support, axis, off_axis, -1.0);
    const PlanarOutline::Sample side = nearest_to_axis(outline, outline.towards(off_axis));
    if (std::isfinite(wall.length)) {
        RodEnd(support, wall, pose).touch(side, touch);
        return touch;
    }
    const double overlap = wall.radius - side.value;
    touch.gap = -overlap;
    if (overlap > 0.0) touch.add(side.support.point(-side.e), side.e, overlap, side.support);
    return touch;
}

}  // namespace dem::runtime
