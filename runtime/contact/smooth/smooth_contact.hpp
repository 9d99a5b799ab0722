// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/hertz_mindlin.hpp"
#include "runtime/contact/smooth/support_sample.hpp"

namespace dem {

/// R* where two convex bodies touch (docs/contact.md, "Effective radius") [m]. `d_eq`: diameters of
/// the spheres of equal volume.
inline double contact_radius(const ContactLaw& law, const SupportSample& i, double d_eq_i,
                             const SupportSample& j, double d_eq_j) {
    if (law.radius == ContactLaw::Radius::equivalent)
        return 0.5 * d_eq_i * d_eq_j / (d_eq_i + d_eq_j);
    const double r_i = mean_curvature_radius(i, d_eq_i);
    const double r_j = mean_curvature_radius(j, d_eq_j);
    return r_i * r_j / (r_i + r_j);
}

/// The same against a wall, whose curvature does not count.
inline double contact_radius(const ContactLaw& law, const SupportSample& i, double d_eq_i) {
    return law.radius == ContactLaw::Radius::equivalent ? 0.5 * d_eq_i
                                                        : mean_curvature_radius(i, d_eq_i);
}

/// What a kernel returns for bodies that are apart: the history forgets the contact, the cache
/// remembers the proven gap and, where there is one, the direction that proves it.
template <class History>
PairContact no_contact(const ContactMemory<History>& memory, double gap,
                       const Vec3& axis = Vec3::Zero()) {
    if (memory.history.effective_radius > 0.0) memory.history = {};
    memory.miss.axis = axis;
    memory.miss.gap = gap;
    return {};
}

}  // namespace dem
