// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "runtime/contact/contact_types.hpp"

#include <algorithm>
#include <concepts>

/// Creases of a distance field: inside a body with edges the distance is that of the nearest face,
/// and where another face becomes the nearest its gradient turns at once. A force that keeps its
/// direction during a step is wrong by up to itself times the way of the step when a point crosses
/// a crease. In such a step each of the two directions acts for its part of the time.
namespace dem::runtime {

/// How the points of a body move relative to a field in one step, in the frame of that field.
struct StepWay {
    Vec3 shift;  ///< of the origin [m]
    Vec3 turn;   ///< [rad]

    /// Way of the point x [m].
    Vec3 at(const Vec3& x) const { return shift + turn.cross(x); }
};

/// The way in a step of the points of i relative to the body j where `sign` is 1, of those of j
/// relative to i where it is -1. `to_world` and `center` place the frame as NodeFrame does.
inline StepWay step_way(const PairState& pair, const Mat3& to_world, const Vec3& center,
                        double sign, double dt) {
    const Vec3 spin = pair.i.angular_velocity - pair.j.angular_velocity;
    const Vec3 velocity = pair.i.velocity - pair.j.velocity +
                          pair.j.angular_velocity.cross(pair.displacement) + spin.cross(center);
    return {sign * dt * (to_world.transpose() * velocity),
            sign * dt * (to_world.transpose() * spin)};
}

/// A field (node_fields.hpp) with creases.
template <class Field>
concept CreasedField = requires(const Field& field, const typename Field::Sample& sample) {
    { field.may_turn_within(sample, 1.0) } -> std::same_as<bool>;
};

/// What a field is to a point during a step.
struct StepMean {
    Vec3 gradient;
    double distance;  ///< [m]
};

/// The means at a point during a step, which it passes on `way` [m], from half a step before x to
/// half a step after. Where there is no crease nearby, what they are at x.
///
/// The mean gradient is that of the gradients at both ends by which the distance changes as it
/// does: of two faces each counts for its part of the time. The signed distance of a convex body is
/// convex, so that both parts are between 0 and 1 however many faces come between.
template <CreasedField Field>
StepMean step_mean(const Field& field, const Vec3& x, const typename Field::Sample& sample,
                   const Vec3& way) {
    StepMean here{field.gradient(x, sample), sample.distance};
    if (!field.may_turn_within(sample, way.norm())) return here;
    const Vec3 start = x - 0.5 * way;
    const Vec3 end = x + 0.5 * way;
    const auto at_start = field.sample(start);
    const auto at_end = field.sample(end);
    const Vec3 first = field.gradient(start, at_start);
    const Vec3 last = field.gradient(end, at_end);
    const double turn = way.dot(last - first);
    if (!(turn > 0.0)) return here;
    const double excess = way.dot(last) - (at_end.distance - at_start.distance);
    const double part = std::clamp(excess / turn, 0.0, 1.0);
    const Vec3 mean = last + part * (first - last);
    // Between opposite faces nothing would be left that a law could take for a direction.
    constexpr double shortest = 0.1;
    if (mean.squaredNorm() < square(shortest)) return here;
    const double at_crease = at_start.distance + part * way.dot(first);
    return {mean, 0.5 * (at_crease + part * at_start.distance + (1.0 - part) * at_end.distance)};
}

}  // namespace dem::runtime
