// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/sr_tube.hpp"

#include "common/math/elementary.hpp"
#include "runtime/contact/smooth/planar_outline.hpp"

#include <algorithm>
#include <numbers>

namespace dem::runtime {

void WallTouch::add(const Vec3& x, const Vec3& n, double overlap, const SupportSample& support) {
    const bool is_deepest =
        std::all_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
                    [&](const ContactPoint& p) { return p.overlap < overlap; });
    if (is_deepest) deepest = support;
    ContactPoint* place = nullptr;
    if (count < points.size()) {
        place = &points[count++];
    } else {
        place = std::min_element(
            points.begin(), points.end(),
            [](const ContactPoint& a, const ContactPoint& b) { return a.overlap < b.overlap; });
        if (place->overlap >= overlap) return;
    }
    *place = {x + 0.5 * overlap * n, n, overlap, 0};
}

namespace {

/// The part of the circle of directions in which a body can reach the wall.
struct Window {
    Vec2 middle;
    Vec2 half;  ///< (cosine, sine) of half its angle, at most 180 degrees

    Vec2 low() const { return planar::sum(middle, {half.x(), -half.y()}); }
    Vec2 high() const { return planar::sum(middle, half); }
    /// planar::turn_measure() of its upper end.
    double end() const { return half.y() > 0.0 ? 1.0 - half.x() : 2.0; }
};

/// Directions that divide the window so that between two neighbors the outline's distance from the
/// axis has at most one maximum that matters: a regular division, and the borders of the flat
/// parts and of what looks flat. Where nothing is flatter than the wall one is enough for less than
/// 180 degrees: two places at the wall would have the outline between them outside of the arc of
/// the wall's radius through both (Blaschke's rolling theorem), so that it is one place.
class OutlineDivision {
  public:
    OutlineDivision(const SupportMap& map, double tilt, double flat_radius, const Window& window)
        : map_(map),
          tilt_(tilt),
          flat_radius_(flat_radius),
          window_(window),
          has_flat_(map.bounds.longest_radius > flat_radius) {
        const std::size_t count = map.pieces.size();
        if (!has_flat_ || count < 3) return;
        add_rim_borders(map.pieces[0], map.pieces[1], -1.0);
        add_rim_borders(map.pieces[count - 1], map.pieces[count - 2], 1.0);
    }

    /// The next dividing direction after the one of this measure, the end of the window at last.
    Vec2 after(double& measure) const {
        Next next{window_.high(), window_.end()};
        const std::size_t stride = has_flat_ ? 1 : 3;
        for (std::size_t k = 0; k < regular.size(); k += stride)
            consider(planar::sum(window_.middle, regular[k]), measure, next);
        if (has_flat_) consider_borders(measure, next);
        for (std::size_t k = 0; k < rim_border_count_; ++k)
            consider(rim_borders_[k], measure, next);
        measure = next.measure;
        return next.u;
    }

  private:
    struct Next {
        Vec2 u;
        double measure;
    };
    static constexpr double least = 1e-9;
    static constexpr double half_sqrt3 = 0.86602540378443864676;
    static inline const std::array<Vec2, 12> regular = {
        Vec2{1.0, 0.0},  Vec2{half_sqrt3, 0.5},   Vec2{0.5, half_sqrt3},
        Vec2{0.0, 1.0},  Vec2{-0.5, half_sqrt3},  Vec2{-half_sqrt3, 0.5},
        Vec2{-1.0, 0.0}, Vec2{-half_sqrt3, -0.5}, Vec2{-0.5, -half_sqrt3},
        Vec2{0.0, -1.0}, Vec2{0.5, -half_sqrt3},  Vec2{half_sqrt3, -0.5}};

    void consider(const Vec2& u, double measure, Next& next) const {
        const double m = planar::turn_measure(window_.middle, u);
        if (m > measure + least && m < next.measure - least) next = {u, m};
    }
    void consider_borders(double measure, Next& next) const {
        bool was_flat = false;
        for (std::size_t k = 0; k < map_.pieces.size(); ++k) {
            const bool is_flat = longest_radius(map_.pieces[k]) > flat_radius_;
            if (k > 0 && is_flat != was_flat) consider_border(map_.piece_end[k - 1], measure, next);
            was_flat = is_flat;
        }
    }
    /// Both directions at which the outline passes the end q of a piece.
    void consider_border(double q, double measure, Next& next) const {
        const double along = 1.0 - std::abs(q);
        const double cosine = q / (std::sqrt(q * q + along * along) * tilt_);
        if (!(std::abs(cosine) < 1.0)) return;
        const double sine = std::sqrt(1.0 - cosine * cosine);
        consider({cosine, sine}, measure, next);
        consider({cosine, -sine}, measure, next);
    }

    /// The rim of a flat end seen edge on is as flat: an ellipse of semi-axes r and b with the
    /// radius of curvature r^2 b^2 / (r^2 sin^2 psi + b^2 cos^2 psi)^(3/2).
    void add_rim_borders(const SupportPiece& end, const SupportPiece& rim, double side) {
        const double r2 = square(rim.center_r);
        const double b2 = r2 * std::max(0.0, 1.0 - square(tilt_));
        if (!(longest_radius(end) > flat_radius_) || longest_radius(rim) > 0.0 || !(r2 > b2))
            return;
        const double sine2 = (math::cbrt(square(r2 * b2 / flat_radius_)) - b2) / (r2 - b2);
        if (!(sine2 > 0.0 && sine2 < 1.0)) return;
        const double cosine = side * std::sqrt(1.0 - sine2);
        for (const double sine : {-std::sqrt(sine2), std::sqrt(sine2)})
            rim_borders_[rim_border_count_++] = {cosine, sine};
    }

    const SupportMap& map_;
    double tilt_, flat_radius_;
    const Window& window_;
    bool has_flat_;
    std::array<Vec2, 4> rim_borders_;
    std::size_t rim_border_count_ = 0;
};

/// One body at the inside of a cylinder.
class InsideSearch {
  public:
    InsideSearch(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                 const Vec3& axis, const Vec3& center)
        : a_(a),
          wall_(wall),
          axis_(axis),
          center_(center),
          off_axis_(center - center.dot(axis) * axis),
          distance_(off_axis_.norm()),
          outline_(support, axis, off_axis_, 1.0) {}

    double gap_of_bounding_sphere() const { return wall_.radius - distance_ - a_.bounding_radius; }

    void search(const PatchHistory& history, WallTouch& touch) const {
        // Outside of the window every point of the bounding sphere stays at least `clear` away from
        // the wall: nothing that is not looked at there can lessen a gap below.
        const double clear = 0.1 * a_.bounding_radius;
        const double inner = wall_.radius - clear;
        const double cosine = distance_ > 0.0 ? (inner - a_.bounding_radius) / distance_ : -1.0;
        const double c = std::clamp(cosine, -1.0, 1.0);
        const Window window{outline_.towards(off_axis_), {c, std::sqrt(1.0 - c * c)}};
        const OutlineDivision division(a_.support, outline_.tilt(), inner, window);

        double largest = inner;
        Valley valley;
        double measure = -window.end();
        Vec2 low = window.low();
        double low_slope = outline_.at(low).slope;
        while (measure < window.end()) {
            const Vec2 high = division.after(measure);
            const double high_slope = outline_.at(high).slope;
            if (low_slope >= 0.0 && high_slope < 0.0) {
                const PlanarOutline::Sample s =
                    outline_.maximum(low, high, start_between(low, high, history));
                largest = std::max(largest, s.value);
                const bool touches = s.value > wall_.radius && add(s, touch);
                if (touches && valley.is_open) add_between(valley, touch);
                valley.follows_a_touch = touches;
                valley.is_open = false;
            } else if (low_slope < 0.0 && high_slope >= 0.0 && valley.follows_a_touch) {
                valley.lowest = outline_.minimum(low, high);
                valley.is_open = valley.lowest.value > wall_.radius;
            }
            low = high;
            low_slope = high_slope;
        }
        touch.gap = largest < wall_.radius ? wall_.radius - largest : 0.0;
    }

  private:
    /// Between two places that touch.
    struct Valley {
        bool follows_a_touch = false;
        bool is_open = false;          ///< found, and beyond the wall as well
        PlanarOutline::Sample lowest;  ///< known where it is open
    };

    bool add(const PlanarOutline::Sample& s, WallTouch& touch) const {
        const Vec3 x = s.support.point(s.e);
        const double z = (center_ + x).dot(axis_);
        if (!wall_.reaches(z)) return false;
        touch.add(x, -s.e, s.value - wall_.radius, s.support);
        return true;
    }
    void add_between(const Valley& valley, WallTouch& touch) const {
        if (touch.between_count == touch.between.size()) return;
        const PlanarOutline::Sample& s = valley.lowest;
        const double overlap = s.value - wall_.radius;
        touch.between[touch.between_count++] = {s.support.point(s.e) - 0.5 * overlap * s.e, -s.e,
                                                overlap, 0};
    }

    /// Where a contact was a step ago, or the middle.
    Vec2 start_between(const Vec2& low, const Vec2& high, const PatchHistory& history) const {
        for (std::size_t k = 0; k < history.used; ++k) {
            Vec2 u = outline_.towards(-Vec3(history.slots[k].normal));
            if (PlanarOutline::is_between(low, u, high)) return u;
        }
        return (low + high).normalized();
    }

    const SrShape& a_;
    const CylinderWall& wall_;
    Vec3 axis_, center_, off_axis_;
    double distance_;
    PlanarOutline outline_;
};

}  // namespace

WallTouch touch_inside(const SrShape& a, const SrSupport& support, const CylinderWall& wall,
                       const WallPose& pose, const PatchHistory& history) {
    WallTouch touch;
    const InsideSearch inside(a, support, wall, pose.axis, pose.center);
    touch.gap = inside.gap_of_bounding_sphere();
    if (!(touch.gap > 0.0)) inside.search(history, touch);
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

}  // namespace dem::runtime
