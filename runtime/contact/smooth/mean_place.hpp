// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/plane_place.hpp"

#include <algorithm>
#include <optional>

namespace dem::runtime {

/// Where a body takes the force of a plane whose place runs along a nearly straight side or over a
/// tip in this step: at the mean of the places half a step before and after, with the parts that
/// make the work of the force what the overlap changes by (crease.hpp). None: where it touches.
template <class Support>
std::optional<Vec3> mean_place(const Support& support, const SupportSample& now, const Vec3& n,
                               const PlaneSwing<double>& swing, double size) {
    if (stays_near(now, swing, size)) return {};
    // Seen from the body the plane turns the other way.
    const Vec3 before = (-n - swing.half).normalized();
    const Vec3 after = (-n + swing.half).normalized();
    const SupportSample first = support(before);
    const SupportSample last = support(after);
    const Vec3 step = last.point(after) - first.point(before);
    if (!(step.squaredNorm() > square(longest_run * size))) return {};
    const Vec3 by_place = 2.0 * swing.half;  // of the overlap, per way of the place
    const double by_step = step.dot(by_place);
    if (!(by_step > 0.0)) return {};
    const double excess = last.point(after).dot(by_place) - (last.h - first.h);
    return last.point(after) - std::clamp(excess / by_step, 0.0, 1.0) * step;
}

}  // namespace dem::runtime
