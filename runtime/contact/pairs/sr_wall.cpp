// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_wall.hpp"

#include "runtime/contact/smooth/smooth_contact.hpp"
#include "runtime/contact/smooth/sr_rod.hpp"
#include "runtime/contact/smooth/sr_tube.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

/// The places that touch, and after them those between, which count against them.
class WallPatch {
  public:
    explicit WallPatch(const WallTouch& touch) {
        for (std::size_t k = 0; k < touch.count; ++k) points_[count_++] = touch.points[k];
        std::uint64_t feature = none;
        for (std::size_t k = 0; k < touch.between_count; ++k) {
            ContactPoint p = touch.between[k];
            p.overlap = -p.overlap;
            p.feature = ++feature;
            points_[count_++] = p;
        }
    }
    std::span<const ContactPoint> points() const { return {points_.data(), count_}; }

  private:
    /// Beyond every number that give_features() gives.
    static constexpr std::uint64_t none = 2 * PatchHistory::slot_count;
    std::array<ContactPoint, 2 * PatchHistory::slot_count> points_;
    std::size_t count_ = 0;
};

/// Where a body at a plane that it touches at x takes the force: at x, or where the place that
/// touches runs along a nearly straight side or over a tip in this step, at the mean of the places
/// half a step before and after, with the parts that make the work of the force what the overlap
/// changes by (crease.hpp). `n`: out of the plane; `spin`: of the body in a step [rad].
Vec3 mean_place(const SrSupport& support, const SupportSample& now, const Vec3& n, const Vec3& spin,
                double size) {
    // Turned about its axis it stays what it is.
    const Vec3 turn = spin - spin.dot(support.axis) * support.axis;
    // Farther than this in a step it runs [m].
    const double far = 0.05 * size;
    const Vec3 x = now.point(-n);
    const Vec3 swing = 0.5 * turn.cross(n);
    const double angle = 2.0 * swing.norm();
    if (now.room > angle && now.along() * angle < far) return x;
    // Seen from the body the plane turns the other way.
    const Vec3 before = (-n - swing).normalized();
    const Vec3 after = (-n + swing).normalized();
    const SupportSample first = support(before);
    const SupportSample last = support(after);
    const Vec3 step = last.point(after) - first.point(before);
    if (!(step.squaredNorm() > square(far))) return x;
    const Vec3 by_place = 2.0 * swing;  // of the overlap, per way of the place
    const double by_step = step.dot(by_place);
    if (!(by_step > 0.0)) return x;
    const double excess = last.point(after).dot(by_place) - (last.h - first.h);
    return last.point(after) - std::clamp(excess / by_step, 0.0, 1.0) * step;
}

}  // namespace

PairContact collide(const SrShape& a, const PlaneWall& wall, const SmoothCall& call) {
    const PairState& pair = call.pair;
    const Vec3 n = body_axis(pair.j.orientation);
    const double height = -pair.displacement.dot(n);
    if (height > a.bounding_radius) return apart(call, height - a.bounding_radius);
    const SrSupport support{a.support, body_axis(pair.i.orientation)};
    const SupportSample s = support(-n);
    const double overlap = s.h - height;
    if (!(overlap > 0.0)) return apart(call, -overlap);
    const Vec3 spin = call.dt * (pair.i.angular_velocity - pair.j.angular_velocity);
    const Vec3 x = mean_place(support, s, n, spin, a.bounding_radius);
    const PlaneField field{{0.0}, {pair.displacement, n}, wall};
    if (!field.accepts(x) || field.lets_pass(Vec3::Zero())) return apart(call, 0.0);
    const ContactPoint point{x + 0.5 * overlap * n, n, overlap, 0};
    const double radius = contact_radius(call.law, s, a.equivalent_diameter);
    return contact_force(point, radius, pair, call.law, call.dt, call.memory.history);
}

PairContact collide(const SrShape& a, const CylinderWall& wall,
                    const Call<PatchHistory, MissCache>& call) {
    const PairState& pair = call.pair;
    const ContactLaw& law = call.law;
    PatchHistory& history = call.memory.history;
    const SrSupport support{a.support, body_axis(pair.i.orientation)};
    const WallPose pose{body_axis(pair.j.orientation), -pair.displacement};
    WallTouch touch = wall.inside ? touch_inside(a, support, wall, pose, history)
                                  : touch_rod(a, support, wall, pose);
    if (touch.count == 0) return apart(call, touch.gap);
    give_features(touch, history);
    const double radius = contact_radius(law, touch.deepest, a.equivalent_diameter);
    if (touch.between_count == 0 || law.geometry.multi_contact != ContactLaw::MultiContact::norm)
        return contact_force(std::span(touch.points.data(), touch.count), radius, pair, law,
                             call.dt, history);
    const WallPatch patch(touch);
    return contact_force(patch.points(), radius, pair, law, call.dt, history);
}

}  // namespace dem::runtime
