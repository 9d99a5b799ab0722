// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/mass_properties.hpp"

#include "common/math/quadrature.hpp"

#include <cmath>

namespace dem::shapegen {
namespace {

/// Integrals along a profile, in its order: r^2 dz, z r^2 dz, r^4 dz, z^2 r^2 dz, r ds, r^3 ds,
/// r z^2 ds. The integrand is that of one jet, dz = z' dt and ds = |c'| dt.
using Moments = Integrals<7>;

Moments integrand(const CurveJet& jet, double center_z) {
    const double r = jet.point.x();
    const double z = jet.point.y() - center_z;
    const double dz = jet.first.y();
    const double ds = jet.first.norm();
    Moments m;
    m << r * r * dz, z * r * r * dz, square(r * r) * dz, square(z * r) * dz, r * ds, cube(r) * ds,
        r * z * z * ds;
    return m;
}

Moments segment_moments(const ProfileSegment& segment, double center_z) {
    const auto f = [&](double t) { return integrand(evaluate(segment, t), center_z); };
    // On a line every integrand is a polynomial of degree 4, which one panel integrates exactly.
    if (std::holds_alternative<LineSegment>(segment)) return integrate_panel<7>(f, 0.0, 1.0);
    return integrate<7>(f, 0.0, 1.0);
}

Moments profile_moments(const Profile& profile, double center_z) {
    Moments sum = Moments::Zero();
    for (const ProfileSegment& segment : profile.segments())
        sum += segment_moments(segment, center_z);
    return sum;
}

}  // namespace

RevolutionMass revolution_mass(const Profile& profile) {
    // About the middle first, then about the center of mass: no difference of large moments.
    const double middle = 0.5 * (profile.min_z() + profile.max_z());
    const Moments first = profile_moments(profile, middle);
    const double center_z = middle + first[1] / first[0];
    const Moments m = profile_moments(profile, center_z);

    RevolutionMass result;
    result.mass_properties.volume = pi * m[0];                         // [SR] Eq. 1
    result.mass_properties.center_of_mass = Vec3(0.0, 0.0, center_z);  // [SR] Eq. 2
    const double axial = 0.5 * pi * m[2];                              // [SR] Eq. 3
    const double transverse = 0.5 * axial + pi * m[3];                 // [SR] Eq. 4
    result.mass_properties.principal_moments_per_density = Vec3(transverse, transverse, axial);
    result.surface_area = 2.0 * pi * m[4];
    result.mean_squared_surface_distance = (m[5] + m[6]) / m[4];
    return result;
}

}  // namespace dem::shapegen
