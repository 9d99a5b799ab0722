// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/law_text.hpp"

#include "common/format.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/material_use.hpp"

namespace dem::runtime {

namespace {

std::string tangential_text(const ContactLaw& law) {
    if (law.tangential == ContactLaw::Tangential::mindlin) return "tangential mindlin";
    return format("k_t %.4g k_n", law.stiffness_ratio);
}

std::string elastic_text(const ContactLaw& law) {
    const Restitution e = restitution(law);
    if (law.model == ContactLaw::Model::linear)
        return format("linear, k_n %.4g N/m, e %.4g, tangential %.4g", law.normal_stiffness,
                      e.normal, e.tangential);
    return format("hertz, Y* %.4g Pa, %s, e %.4g", law.youngs_modulus, tangential_text(law).c_str(),
                  e.normal);
}

std::string rolling_text(const RollingResistance& rolling) {
    if (!(rolling.friction > 0.0)) return "";
    const bool is_constant = rolling.model == RollingResistance::Model::constant;
    return format(", mu_r %.4g %s", rolling.friction, is_constant ? "constant" : "elastic_plastic");
}

}  // namespace

std::string law_text(const Scene& scene) {
    const MaterialUse use = material_use(scene);
    const auto count = static_cast<std::uint32_t>(scene.materials.size());
    std::string text;
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a; b < count; ++b) {
            if (!use.can_meet(a, b)) continue;
            const ContactLaw& law = scene.laws.at(a, b);
            text += "  " + scene.materials[a].name + " on " + scene.materials[b].name + ": " +
                    elastic_text(law) + format(", mu %.4g", law.friction) +
                    rolling_text(law.rolling) + "\n";
        }
    }
    return text.empty() ? text : "laws:\n" + text;
}

}  // namespace dem::runtime
