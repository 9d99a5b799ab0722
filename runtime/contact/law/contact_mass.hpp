// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

namespace dem {

/// a . I^-1 a of a body for a world vector a. Bodies of revolution need only their axis.
inline double inverse_inertia_along(const BodyState& body, const Vec3& a) {
    const Vec3& inverse = body.inverse_inertia.moments;
    const Quat& q = body.orientation;
    if (inverse.x() == inverse.y()) {
        if (inverse.x() == inverse.z()) return inverse.x() * a.squaredNorm();
        const double along = a.dot(body_axis(q));
        return inverse.x() * a.squaredNorm() + (inverse.z() - inverse.x()) * (along * along);
    }
    const Vec3 a_body = q.conjugate() * a;
    return inverse.dot(a_body.cwiseProduct(a_body));
}

/// 1/m* of two bodies moving without turning [1/kg].
inline double inverse_reduced_mass(const PairState& pair) {
    return pair.i.inverse_inertia.mass + pair.j.inverse_inertia.mass;
}

/// 1/m_e along a generalised direction: force `g` on i and -g on j with torques `t_i`, -`t_j`
/// (docs/contact.md, "Damping mass").
inline double inverse_contact_mass(const PairState& pair, const Vec3& g, const Vec3& t_i,
                                   const Vec3& t_j) {
    return g.squaredNorm() * inverse_reduced_mass(pair) + inverse_inertia_along(pair.i, t_i) +
           inverse_inertia_along(pair.j, t_j);
}

}  // namespace dem
