// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/effective_radius.hpp"
#include "runtime/contact/smooth/support_sample.hpp"

namespace dem::runtime {

/// R* where two convex bodies touch (docs/contact.md, "Effective radius") [m]. `d_eq`: diameters of
/// the spheres of equal volume.
inline double contact_radius(const ContactLaw& law, const SupportSample& i, double d_eq_i,
                             const SupportSample& j, double d_eq_j) {
    if (law.geometry.radius == ContactLaw::Radius::equivalent)
        return 0.5 * d_eq_i * d_eq_j / (d_eq_i + d_eq_j);
    const double r_i = mean_curvature_radius(i, d_eq_i);
    const double r_j = mean_curvature_radius(j, d_eq_j);
    return r_i * r_j / (r_i + r_j);
}

/// R* of a convex body against a wall, whose curvature does not count.
inline double contact_radius(const ContactLaw& law, const SupportSample& i, double d_eq_i) {
    return law.geometry.radius == ContactLaw::Radius::equivalent ? 0.5 * d_eq_i
                                                                 : mean_curvature_radius(i, d_eq_i);
}

}  // namespace dem::runtime
