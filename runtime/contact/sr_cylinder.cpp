// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/sr_cylinder.hpp"

#include "runtime/contact/common_normal.hpp"
#include "runtime/contact/planar_outline.hpp"

#include <algorithm>
#include <numbers>

namespace dem {

namespace {

/// Adds a point of the body where it is `overlap` beyond a wall of the outward normal n; x is
/// relative to the body's centre. A full list keeps the deepest.
void add_point(WallTouch& touch, const Vec3& x, const Vec3& n, double overlap,
               const SupportSample& support) {
    const bool is_deepest = std::all_of(touch.points.begin(), touch.points.begin() + touch.count,
                                        [&](const ContactPoint& p) { return p.overlap < overlap; });
    if (is_deepest) touch.deepest = support;
    ContactPoint* place = nullptr;
    if (touch.count < touch.points.size()) {
        place = &touch.points[touch.count++];
    } else {
        place = std::min_element(
            touch.points.begin(), touch.points.end(),
            [](const ContactPoint& a, const ContactPoint& b) { return a.overlap < b.overlap; });
        if (place->overlap >= overlap) return;
    }
    *place = {x + 0.5 * overlap * n, n, overlap, 0};
}

/// |psi| at which the direction leaves a piece of the support map that ends at q; > pi if it never
/// does.
double border_angle(double q, double tilt) {
    const double along = 1.0 - std::abs(q);
    const double u = q / std::sqrt(q * q + along * along);
    return std::abs(u) < tilt ? std::acos(u / tilt) : 2.0 * pi;
}

/// Angles that divide the outline so that between two neighbours its distance from the axis has at
/// most one maximum that matters: a regular division, and the borders of flat pieces, those whose
/// radius of curvature can reach the cylinder's.
class OutlineDivision {
  public:
    OutlineDivision(const SupportMap& map, double tilt, double wall_radius)
        : map_(map), tilt_(tilt), wall_radius_(wall_radius) {
        has_flat_ = std::any_of(map.pieces.begin(), map.pieces.end(),
                                [&](const SupportPiece& p) { return is_flat(p); });
    }

    /// The first dividing angle after psi.
    double after(double psi) const {
        double next = (std::floor(psi / regular) + 1.0) * regular;
        if (next - psi < least) next += regular;
        if (!has_flat_) return next;
        for (std::size_t k = 0; k < map_.pieces.size(); ++k) {
            if (!is_flat(map_.pieces[k])) continue;
            consider(psi, map_.piece_end[k], next);
            if (k > 0) consider(psi, map_.piece_end[k - 1], next);
        }
        return next;
    }

  private:
    static constexpr double regular = pi / 6.0;
    static constexpr double least = 1e-9;

    bool is_flat(const SupportPiece& p) const {
        const double longer = std::max(p.a, p.b);
        return longer * longer > wall_radius_ * std::min(p.a, p.b) && longer > 0.0;
    }
    void consider(double psi, double q, double& next) const {
        const double border = border_angle(q, tilt_);
        if (border > pi) return;
        for (const double angle : {border, -border}) {
            const double turns = std::ceil((psi + least - angle) / (2.0 * pi));
            next = std::min(next, angle + 2.0 * pi * turns);
        }
    }

    const SupportMap& map_;
    double tilt_, wall_radius_;
    bool has_flat_;
};

}  // namespace

WallTouch touch_inside(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                       const Vec3& axis, const Vec3& center) {
    WallTouch touch;
    const Vec3 off_axis = center - center.dot(axis) * axis;
    const double r = off_axis.norm();
    touch.gap = wall.radius - r - a.bounding_radius;
    if (touch.gap > 0.0) return touch;

    const PlanarOutline outline(support, axis, off_axis, 1.0);
    // Beyond this angle from the centre's direction every point of the bounding sphere stays at
    // least `clear` away from the wall: nothing that is not looked at there can lessen a gap below.
    const double clear = 0.1 * a.bounding_radius;
    const double cosine = r > 0.0 ? (wall.radius - clear - a.bounding_radius) / r : -1.0;
    const double half_window = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double middle = r > 0.0 ? outline.angle_of(off_axis) : 0.0;
    const OutlineDivision division(a.support, outline.tilt(), wall.radius);

    double largest = wall.radius - clear;
    double low = middle - half_window;
    double low_slope = outline.at(low).slope;
    while (low < middle + half_window) {
        const double high = std::min(division.after(low), middle + half_window);
        const double high_slope = outline.at(high).slope;
        if (low_slope >= 0.0 && high_slope < 0.0) {
            const PlanarOutline::Sample s = outline.maximum(low, high);
            largest = std::max(largest, s.value);
            const double overlap = s.value - wall.radius;
            const Vec3 x = s.support.point(s.e);
            const double z = (center + x).dot(axis);
            const bool beyond_rim = std::isfinite(wall.length) && (z < 0.0 || z > wall.length);
            if (overlap > 0.0 && !beyond_rim) add_point(touch, x, -s.e, overlap, s.support);
        }
        low = high;
        low_slope = high_slope;
    }
    touch.gap = largest < wall.radius ? wall.radius - largest : 0.0;
    return touch;
}

namespace {

/// Nearest approach of the body to the axis: like a ball, with one minimum.
PlanarOutline::Sample nearest_to_axis(const PlanarOutline& outline, double psi) {
    constexpr double stride = 0.2;
    PlanarOutline::Sample s = outline.at(psi);
    const double direction = s.slope >= 0.0 ? stride : -stride;
    const int round = static_cast<int>(2.0 * pi / stride) + 1;
    for (int k = 0; k < round; ++k) {
        const PlanarOutline::Sample next = outline.at(psi + direction);
        const bool between = s.slope >= 0.0 ? next.slope < 0.0 : next.slope >= 0.0;
        if (between)
            return outline.maximum(std::min(psi, psi + direction), std::max(psi, psi + direction));
        psi += direction;
        s = next;
    }
    return s;
}

}  // namespace

WallTouch touch_rod(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                    const Vec3& axis, const Vec3& center) {
    WallTouch touch;
    const double z = center.dot(axis);
    const Vec3 off_axis = center - z * axis;
    touch.gap = off_axis.norm() - wall.radius - a.bounding_radius;
    if (touch.gap > 0.0) return touch;

    const PlanarOutline outline(support, axis, off_axis, -1.0);
    const PlanarOutline::Sample side =
        nearest_to_axis(outline, off_axis.norm() > 0.0 ? outline.angle_of(off_axis) : 0.0);
    const double side_overlap = wall.radius - side.value;
    const Vec3 side_point = side.support.point(-side.e);
    if (std::isinf(wall.length)) {
        touch.gap = -side_overlap;
        if (side_overlap > 0.0) add_point(touch, side_point, side.e, side_overlap, side.support);
        return touch;
    }
    const bool upper = z > 0.5 * wall.length;
    const Vec3 outward = upper ? axis : Vec3(-axis);
    const double end_z = upper ? wall.length : 0.0;
    const SupportSample face = support(-outward);
    const double face_overlap = face.h - (center.dot(outward) - end_z);
    touch.gap = std::max(-side_overlap, -face_overlap);
    if (touch.gap >= 0.0) return touch;

    // Overlapping the endless rod and the half space behind the end: the true contact is where one
    // of them is touched within its bounds, else at the edge.
    touch.gap = 0.0;
    const Vec3 face_point = face.point(-outward);
    const Vec3 on_face = center + face_point;
    const double touched_z = (center + side_point).dot(axis);
    const bool on_side = touched_z >= 0.0 && touched_z <= wall.length;
    const bool within_face = (on_face - on_face.dot(axis) * axis).norm() <= wall.radius;
    if (on_side && (!within_face || side_overlap <= face_overlap)) {
        add_point(touch, side_point, side.e, side_overlap, side.support);
    } else if (within_face) {
        add_point(touch, face_point, outward, face_overlap, face);
    } else {
        const Vec3 d = end_z * axis - center;
        const CircleSupport edge{wall.radius, axis};
        const NormalProbe p = common_normal(support, edge, d, Vec3(d.normalized()));
        touch.gap = -p.f;
        if (p.f > 0.0) add_point(touch, p.i.point(p.n), -p.n, p.f, p.i);
    }
    return touch;
}

void give_features(WallTouch& touch, const PatchHistory& history) {
    constexpr std::uint64_t none = ~std::uint64_t{0};
    std::array<bool, 2 * PatchHistory::slot_count> taken{};
    const auto points = std::span(touch.points.data(), touch.count);
    for (ContactPoint& p : points) {
        p.feature = none;
        double nearest = 0.5;  // farther than 60 degrees is another contact
        std::size_t best = history.used;
        for (std::size_t k = 0; k < history.used; ++k) {
            const double cosine = Vec3(history.slots[k].normal).dot(p.gradient);
            if (!taken[history.slots[k].feature] && cosine > nearest) {
                nearest = cosine;
                best = k;
            }
        }
        if (best == history.used) continue;
        p.feature = history.slots[best].feature;
        taken[p.feature] = true;
    }
    // A lost point's number stays unused for a step: its spring must not pass to another.
    for (std::size_t k = 0; k < history.used; ++k) taken[history.slots[k].feature] = true;
    for (ContactPoint& p : points) {
        if (p.feature != none) continue;
        p.feature = static_cast<std::uint64_t>(std::find(taken.begin(), taken.end(), false) -
                                               taken.begin());
        taken[p.feature] = true;
    }
    std::sort(points.begin(), points.end(),
              [](const ContactPoint& a, const ContactPoint& b) { return a.feature < b.feature; });
}

}  // namespace dem
