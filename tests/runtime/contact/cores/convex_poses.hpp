// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/random.hpp"
#include "runtime/contact/contact_types.hpp"

#include <cmath>

/// Two bodies beside each other, for tests of pairs.
namespace dem::test {

using namespace runtime;

inline Quat turned(const Vec3& axis, double angle) {
    const double s = std::sin(0.5 * angle);
    const Vec3 a = axis.normalized();
    return {std::cos(0.5 * angle), s * a.x(), s * a.y(), s * a.z()};
}

/// Two bodies that look at each other along `direction`, their z axes within `tilt` of it.
struct Poses {
    Quat i, j;
    Vec3 direction, offset;
};
inline Poses random_poses(Random& random, double tilt) {
    Poses p;
    p.direction = random.direction();
    p.offset = random.uniform(0.0, 0.4) * p.direction.unitOrthogonal();
    p.i = random.orientation();
    p.j = random.orientation();
    if (tilt >= pi) return p;
    for (Quat* q : {&p.i, &p.j}) {
        const Quat facing = orientation_towards(p.direction);
        const Quat spun = facing * turned(Vec3::UnitZ(), random.uniform(0.0, 2.0 * pi));
        *q = turned(random.direction(), tilt * random.uniform()) * spun;
    }
    return p;
}

inline BodyState still(const Quat& q) {
    return {q, Vec3::Zero(), Vec3::Zero(), {1.0, Vec3::Ones()}};
}

/// Where along the line the bodies overlap by this much.
template <class Overlap>
double place_of(double overlap, double far, const Overlap& overlap_at) {
    double low = 0.0;
    double high = far;
    for (int k = 0; k < 24; ++k) {
        const double middle = 0.5 * (low + high);
        (overlap_at(middle) > overlap ? low : high) = middle;
    }
    return low;
}

}  // namespace dem::test
