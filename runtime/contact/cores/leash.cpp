// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/leash.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// j as the body i sees it.
struct RelativePose {
    Vec3 center;
    Quat turn;

    explicit RelativePose(const PairState& pair)
        : center(pair.i.orientation.conjugate() * pair.displacement),
          turn(pair.i.orientation.conjugate() * pair.j.orientation) {}
};

}  // namespace

Leash leash_at(const PairState& pair, double room) {
    const RelativePose pose(pair);
    Leash leash;
    leash.room = room;
    leash.center = pose.center;
    leash.turn = Vec3(pose.turn.vec());
    leash.turn_w = pose.turn.w();
    return leash;
}

bool holds(const Leash& leash, const PairState& pair, double size) {
    const RelativePose now(pair);
    const Vec3 vector = leash.turn;
    const double same =
        (now.turn.vec() - vector).squaredNorm() + square(now.turn.w() - leash.turn_w);
    const double other =
        (now.turn.vec() + vector).squaredNorm() + square(now.turn.w() + leash.turn_w);
    // The chord of an angle is at most twice the distance of the quaternions.
    const double way =
        (now.center - Vec3(leash.center)).norm() + 2.0 * size * std::sqrt(std::min(same, other));
    return way < leash.room;
}

}  // namespace dem::runtime
