// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"

namespace dem::runtime {

struct Elasticity {
    double youngs_modulus = 0.0;  ///< [Pa], > 0
    double poissons_ratio = 0.0;  ///< (-1, 0.5]
};

/// Shear modulus of an isotropic solid [Pa].
double shear_modulus(const Elasticity& material);

/// sqrt(5) |beta| of a coefficient of restitution in (0, 1], [SR] Eqs. 12-13. 1 gives 0.
/// Throws Error outside.
double hertz_damping(double restitution);

/// Contact law of two materials: Y*, G* ([SR] Eq. 13) and the damping of `restitution` derived,
/// everything else taken from `options` (friction, methods, ratios). Throws Error for values out of
/// range.
ContactLaw pair_law(const Elasticity& a, const Elasticity& b, double restitution,
                    const ContactLaw& options = {});

/// Makes a law linear [GC] Sec. 6: normal stiffness [N/m], restitution and tangential restitution
/// in (0, 1]. The other options of the law stay. Throws Error for values out of range.
ContactLaw linear_law(double normal_stiffness, double restitution, double tangential_restitution,
                      const ContactLaw& options = {});

/// The coefficients of restitution that a law was made with; the tangential one of Hertz's is 1.
struct Restitution {
    double normal = 1.0, tangential = 1.0;
};
Restitution restitution(const ContactLaw& law);

}  // namespace dem::runtime
