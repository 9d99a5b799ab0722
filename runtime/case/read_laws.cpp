// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/case/scene_sections.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/material_use.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace dem::runtime {

namespace {

std::string pair_text(const Scene& scene, std::uint32_t a, std::uint32_t b) {
    return "materials " + in_quotes(scene.materials[a].name) + " and " +
           in_quotes(scene.materials[b].name);
}

/// [contact] with what [contact.A.B] says about the same keys put over it.
CaseSection merged(const CaseSection& base, const CaseSection* pair) {
    if (pair == nullptr) return base;
    CaseSection section = *pair;
    for (const CaseEntry& entry : base.entries) {
        if (pair->find(entry.key) == nullptr) section.entries.push_back(entry);
    }
    return section;
}

ContactLaw options(const Values& values) {
    ContactLaw law;
    law.model = values.choice<ContactLaw::Model>("model");
    // What `automatic` means for convex shapes has a name of its own.
    law.geometry.method = values.word("contact") == "features"
                              ? ContactLaw::Method::automatic
                              : values.choice<ContactLaw::Method>("contact");
    law.tangential = values.choice<ContactLaw::Tangential>("tangential");
    law.damping_mass = values.choice<ContactLaw::DampingMass>("damping_mass");
    law.geometry.multi_contact = values.choice<ContactLaw::MultiContact>("multi_contact");
    law.geometry.radius = values.choice<ContactLaw::Radius>("radius");
    law.geometry.node_normal = values.choice<ContactLaw::NodeNormal>("node_normal");
    law.limit_force = values.yes_no("limit_force");
    law.friction = values.optional_number("friction").value_or(0.0);
    law.stiffness_ratio = values.number("stiffness_ratio");
    law.damping_ratio = values.number("damping_ratio");
    law.rolling = {values.choice<RollingResistance::Model>("rolling_model"),
                   values.number("rolling_friction"), values.number("rolling_damping")};
    return law;
}

void check_method(const Scene& scene, const Values& values, const ContactLaw& law, std::uint32_t a,
                  std::uint32_t b) {
    if (law.geometry.method != ContactLaw::Method::continuous) return;
    for (const BodyKind& kind : scene.kinds) {
        const ParticleTemplate& shape = scene.shapes[kind.shape];
        if ((kind.material != a && kind.material != b) || shape.is_convex) continue;
        throw Error(values.where("contact"), "'continuous' needs convex shapes and " +
                                                 in_quotes(shape.name) +
                                                 " is not convex, expected 'auto' or 'nodes'");
    }
}

/// What a law would have to say to look at a key of [contact]; empty where it does.
std::string_view lacking(std::string_view key, const ContactLaw& law) {
    const bool is_linear = law.model == ContactLaw::Model::linear;
    if (key == "normal_stiffness" || key == "tangential_restitution")
        return is_linear ? "" : "model = linear";
    if (key == "tangential" || key == "damping_ratio" || key == "radius")
        return is_linear ? "model = hertz" : "";
    if (key == "stiffness_ratio") {
        if (is_linear) return "model = hertz";
        return law.tangential == ContactLaw::Tangential::ratio ? "" : "tangential = ratio";
    }
    if (key == "rolling_model" || key == "rolling_damping")
        return law.rolling.friction > 0.0 ? "" : "a rolling_friction above 0";
    return "";
}

/// Throws Error for a key of a section that none of the laws it is for looks at.
void check_meaning(const CaseSection& section, const std::vector<ContactLaw>& laws) {
    for (const CaseEntry& entry : section.entries) {
        const auto looks = [&](const ContactLaw& law) { return lacking(entry.key, law).empty(); };
        if (laws.empty() || std::any_of(laws.begin(), laws.end(), looks)) continue;
        // Scans over rolling_friction may begin at 0.
        const bool is_scanned = section.find("rolling_friction") != nullptr;
        if (is_scanned && entry.key.starts_with("rolling_")) continue;
        throw Error(entry.where, in_quotes(entry.key) + " means nothing here, expected it with " +
                                     std::string(lacking(entry.key, laws.front())));
    }
}

/// Half the thickness of an ellipsoid of the same second moments [m].
double half_thickness(const MassProperties& properties) {
    const Vec3& moments = properties.principal_moments_per_density;
    const double smallest = 0.5 * moments.sum() - moments.maxCoeff();
    return std::sqrt(5.0 * smallest / properties.volume);
}

// Nodes look into a field of distances, whose cells cannot be arbitrarily thin.
void check_field(const Scene& scene, const Values& values, const ContactLaw& law, std::uint32_t a,
                 std::uint32_t b) {
    if (law.geometry.method != ContactLaw::Method::nodes) return;
    for (const BodyKind& kind : scene.kinds) {
        const ParticleTemplate& shape = scene.shapes[kind.shape];
        if (kind.material != a && kind.material != b) continue;
        const auto* sr = std::get_if<SrShape>(&shape.shape);
        if (sr == nullptr) continue;
        const double largest_error = 0.5 * sr->sdf.surface_slack;  // which is twice what was found
        if (largest_error <= 0.1 * half_thickness(shape.mass_properties)) continue;
        throw Error(values.where("contact"), "'nodes' needs the distance field of " +
                                                 in_quotes(shape.name) +
                                                 ", which is coarser than the body is thick, "
                                                 "expected 'continuous'");
    }
}

ContactLaw law_of(const Scene& scene, const CaseSection& section, std::uint32_t a,
                  std::uint32_t b) {
    const Values values(section, *section_kind("contact"));
    for (const char* key : {"restitution", "friction"}) {
        if (values.has(key)) continue;
        throw Error(section.where, "no " + std::string(key) + " for " + pair_text(scene, a, b) +
                                       ", expected it in [contact] or in [contact." +
                                       scene.materials[a].name + "." + scene.materials[b].name +
                                       "]");
    }
    const ContactLaw law_options = options(values);
    check_method(scene, values, law_options, a, b);
    check_field(scene, values, law_options, a, b);
    if (law_options.model == ContactLaw::Model::linear) {
        for (const char* key : {"normal_stiffness", "tangential_restitution"}) {
            if (values.has(key)) continue;
            throw Error(section.where,
                        "no " + std::string(key) + " for " + pair_text(scene, a, b) +
                            ", expected it in the same section: model = linear needs it");
        }
        return linear_law(values.number("normal_stiffness"), values.number("restitution"),
                          values.number("tangential_restitution"), law_options);
    }
    const auto elasticity = [&](std::uint32_t m) {
        return Elasticity{scene.materials[m].youngs_modulus, scene.materials[m].poissons_ratio};
    };
    return pair_law(elasticity(a), elasticity(b), values.number("restitution"), law_options);
}

using PairSections = std::map<std::pair<std::uint32_t, std::uint32_t>, const CaseSection*>;

PairSections pair_sections(const CaseFile& file, const Scene& scene) {
    PairSections pairs;
    for (const CaseSection& section : file.sections) {
        const SectionKind* kind = section_kind(section.name);
        if (kind->pattern != "contact.A.B") continue;
        const auto words = split(section.name, '.');
        const auto a = material_index(scene, std::string(words[1]), section.where);
        const auto b = material_index(scene, std::string(words[2]), section.where);
        options(Values(section, *kind));
        const auto [first, is_new] = pairs.emplace(std::minmax(a, b), &section);
        if (!is_new) {
            throw Error(section.where, "second section for " + pair_text(scene, a, b) +
                                           ", expected one (first at " + first->second->where +
                                           ")");
        }
    }
    return pairs;
}

}  // namespace

std::uint32_t material_index(const Scene& scene, const std::string& name,
                             const std::string& where) {
    std::vector<std::string> known;
    for (std::uint32_t m = 0; m < scene.materials.size(); ++m) {
        if (scene.materials[m].name == name) return m;
        known.push_back(scene.materials[m].name);
    }
    throw Error(where, "unknown material " + in_quotes(name) + suggestion_or_all(name, known));
}

void read_laws(const CaseFile& file, Scene& scene) {
    const CaseSection nothing{"contact", file.path, {}};
    const CaseSection* given = file.find("contact");
    const CaseSection& base = given != nullptr ? *given : nothing;
    options(Values(base, *section_kind("contact")));
    const PairSections pairs = pair_sections(file, scene);
    const MaterialUse use = material_use(scene);
    const auto count = static_cast<std::uint32_t>(scene.materials.size());
    scene.laws = LawTable(count);
    std::vector<ContactLaw> all;
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a; b < count; ++b) {
            if (!use.can_meet(a, b)) continue;
            const auto pair = pairs.find({a, b});
            const CaseSection* section = pair == pairs.end() ? nullptr : pair->second;
            const ContactLaw law = law_of(scene, merged(base, section), a, b);
            if (section != nullptr) check_meaning(*section, {law});
            all.push_back(law);
            scene.laws.set(a, b, law);
        }
    }
    check_meaning(base, all);
}

}  // namespace dem::runtime
