// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_wall.hpp"

#include "runtime/contact/law/patch_slots.hpp"
#include "runtime/contact/smooth/mean_place.hpp"
#include "runtime/contact/smooth/smooth_contact.hpp"
#include "runtime/contact/smooth/sr_rod.hpp"
#include "runtime/contact/smooth/sr_tube.hpp"
#include "runtime/contact/smooth/tube_place.hpp"

#include <algorithm>
#include <optional>

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

/// R* where the body was last looked at [m], or none where the frozen one serves.
double radius_at(const SupportSample& s, const SrShape& a, const ContactLaw& law,
                 const ContactHistory& history) {
    return needs_local_radius(law, history) ? contact_radius(law, s, a.equivalent_diameter) : 0.0;
}

/// A cylinder wall, and how a body stands to it.
struct PosedCylinder {
    const CylinderWall& wall;
    const WallPose& pose;
};

/// Where the inside of a cylinder pushes a body whose place runs along one of its lines. `n`: from
/// the wall. None: it stays, or an end of the side is near. (On a rod, whose side bulges, a
/// straight side that crosses the line at a small angle touches where they cross: places do not run
/// so.)
std::optional<Vec3> place_along_line(const SrShape& a, const SrSupport& support,
                                     const SupportSample& now, const Vec3& n,
                                     const PosedCylinder& cylinder,
                                     const Call<PatchHistory, MissCache>& call) {
    const auto& [wall, pose] = cylinder;
    const double z = pose.center.dot(pose.axis);
    if (!wall.reaches(z - a.bounding_radius) || !wall.reaches(z + a.bounding_radius)) return {};
    const Vec3 spin = call.dt * (call.pair.i.angular_velocity - call.pair.j.angular_velocity);
    const PlaneSwing<double> swing =
        along_line<double>(plane_swing<double>(support.axis, n, spin), pose.axis);
    return mean_place(support, now, n, swing, a.bounding_radius);
}

/// A contact that goes on at the one place where the body touches the inside of a cylinder, if
/// there is no need to search.
std::optional<PairContact> followed_contact(const SrShape& a, const SrSupport& support,
                                            const CylinderWall& wall, const WallPose& pose,
                                            const Call<PatchHistory, MissCache>& call) {
    PatchHistory& history = call.memory.history;
    if (!wall.inside || history.used != 1) return {};
    PointHistory point = as_point(history, call.law);
    const TubePoseOf<double> tube{pose.axis, pose.center, wall.radius, a.bounding_radius};
    const TubePlaceOf<double> place = followed_place(support, tube, Vec3(point.normal));
    if (!place.is_only || !wall.reaches(place.z)) return {};
    const double radius = radius_at(place.support, a, call.law, point);
    const Vec3 n = -place.at.n;
    const std::optional<Vec3> mean =
        place_along_line(a, support, place.support, n, {wall, pose}, call);
    const PairContact contact =
        mean ? contact_force({*mean + 0.5 * place.at.f * n, n, place.at.f, 0}, radius, call.pair,
                             call.law, call.dt, point)
             : force_at(place.at, radius, call.pair, call.law, call.dt, point);
    keep_point(point, history.slots[0].feature, history);
    return contact;
}

}  // namespace

PairContact collide(const SrShape& a, const PlaneWall& wall, const SmoothCall& call) {
    const PairState& pair = call.pair;
    PointHistory& history = call.memory.history;
    const Vec3 n = body_axis(pair.j.orientation);
    const double height = -pair.displacement.dot(n);
    if (height > a.bounding_radius) return apart(call, height - a.bounding_radius);
    const SrSupport support{a.support, body_axis(pair.i.orientation)};
    const auto [at, s] = place_at_plane(support, n, height);
    if (!(at.f > 0.0)) return apart(call, -at.f);
    const Vec3 spin = call.dt * (pair.i.angular_velocity - pair.j.angular_velocity);
    const PlaneSwing<double> swing = plane_swing<double>(support.axis, n, spin);
    const std::optional<Vec3> mean = mean_place(support, s, n, swing, a.bounding_radius);
    const PlaneField field{{0.0}, {pair.displacement, n}, wall.radius};
    if (!field.accepts(mean ? *mean : s.point(-n)) || field.lets_pass(Vec3::Zero()))
        return apart(call, 0.0);
    const double radius = radius_at(s, a, call.law, history);
    if (!mean) return force_at(at, radius, pair, call.law, call.dt, history);
    const ContactPoint point{*mean + 0.5 * at.f * n, n, at.f, 0};
    return contact_force(point, radius, pair, call.law, call.dt, history);
}

PairContact collide(const SrShape& a, const CylinderWall& wall,
                    const Call<PatchHistory, MissCache>& call) {
    const PairState& pair = call.pair;
    const ContactLaw& law = call.law;
    PatchHistory& history = call.memory.history;
    const SrSupport support{a.support, body_axis(pair.i.orientation)};
    const WallPose pose{body_axis(pair.j.orientation), -pair.displacement};
    if (const auto contact = followed_contact(a, support, wall, pose, call)) return *contact;
    WallTouch touch = wall.inside ? touch_inside(a, support, wall, pose, history)
                                  : touch_rod(a, support, wall, pose);
    if (touch.count == 0) return apart(call, touch.gap);
    if (wall.inside && touch.count == 1) {
        ContactPoint& at = touch.points[0];
        const Vec3 n = at.gradient;
        const auto mean = place_along_line(a, support, touch.deepest, n, {wall, pose}, call);
        if (mean) at.position = *mean + 0.5 * at.overlap * n;
    }
    give_features(touch, history);
    const double radius = contact_radius(law, touch.deepest, a.equivalent_diameter);
    if (touch.between_count == 0 || law.geometry.multi_contact != ContactLaw::MultiContact::norm)
        return contact_force(std::span(touch.points.data(), touch.count), radius, pair, law,
                             call.dt, history);
    const WallPatch patch(touch);
    return contact_force(patch.points(), radius, pair, law, call.dt, history);
}

}  // namespace dem::runtime
