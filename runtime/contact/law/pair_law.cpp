// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/pair_law.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"

#include <cmath>
#include <sstream>

namespace dem::runtime {

namespace {

void require(bool fine, const char* what, double found, const char* expected) {
    if (fine) return;
    std::ostringstream message;
    message << what << ' ' << found << ", expected " << expected;
    throw Error("contact law", message.str());
}

// e of |beta| = |ln e| / sqrt(pi^2 + ln^2 e).
double restitution_of(double beta) {
    return math::exp(-pi * beta / std::sqrt(1.0 - square(beta)));
}

void check(const Elasticity& m) {
    require(m.youngs_modulus > 0.0 && std::isfinite(m.youngs_modulus), "Young's modulus",
            m.youngs_modulus, "a positive number of Pa");
    require(m.poissons_ratio > -1.0 && m.poissons_ratio <= 0.5, "Poisson's ratio", m.poissons_ratio,
            "a number above -1 and up to 0.5");
}

}  // namespace

double shear_modulus(const Elasticity& material) {
    return material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio));
}

double hertz_damping(double restitution) {
    require(restitution > 0.0 && restitution <= 1.0, "restitution", restitution,
            "a number above 0 and up to 1");
    const double log_e = math::log(restitution);
    return std::sqrt(5.0) * std::abs(log_e) / std::sqrt(pi * pi + log_e * log_e);
}

ContactLaw pair_law(const Elasticity& a, const Elasticity& b, double restitution,
                    const ContactLaw& options) {
    check(a);
    check(b);
    require(options.friction >= 0.0 && std::isfinite(options.friction), "friction",
            options.friction, "zero or a positive number");
    ContactLaw law = options;
    law.youngs_modulus = 1.0 / ((1.0 - square(a.poissons_ratio)) / a.youngs_modulus +
                                (1.0 - square(b.poissons_ratio)) / b.youngs_modulus);
    law.shear_modulus = 1.0 / ((2.0 - a.poissons_ratio) / shear_modulus(a) +
                               (2.0 - b.poissons_ratio) / shear_modulus(b));
    law.damping = hertz_damping(restitution);
    return law;
}

ContactLaw linear_law(double normal_stiffness, double restitution, double tangential_restitution,
                      const ContactLaw& options) {
    require(normal_stiffness > 0.0 && std::isfinite(normal_stiffness), "normal stiffness",
            normal_stiffness, "a positive number of N/m");
    require(restitution > 0.0 && restitution <= 1.0, "restitution", restitution,
            "a number above 0 and up to 1");
    require(tangential_restitution > 0.0 && tangential_restitution <= 1.0, "tangential restitution",
            tangential_restitution, "a number above 0 and up to 1");
    require(options.friction >= 0.0 && std::isfinite(options.friction), "friction",
            options.friction, "zero or a positive number");
    const double log_n = math::log(restitution);
    const double log_t = math::log(tangential_restitution);
    const double normal = pi * pi + log_n * log_n;
    ContactLaw law = options;
    law.model = ContactLaw::Model::linear;
    law.normal_stiffness = normal_stiffness;
    law.contact_time = std::sqrt(normal);
    law.damping = -2.0 * log_n / law.contact_time;
    law.tangential_stiffness = (pi * pi + log_t * log_t) / normal;
    law.tangential_damping = -2.0 * log_t / law.contact_time;
    return law;
}

Restitution restitution(const ContactLaw& law) {
    if (law.model == ContactLaw::Model::hertz)
        return {restitution_of(law.damping / std::sqrt(5.0)), 1.0};
    // -2 ln e_t over the same root as that of e_n.
    return {restitution_of(0.5 * law.damping),
            math::exp(-0.5 * law.tangential_damping * law.contact_time)};
}

}  // namespace dem::runtime
