// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/overlap.hpp"

#include "common/format.hpp"
#include "common/math/elementary.hpp"
#include "runtime/domain.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dem::runtime {

namespace {

double sphere_radius(const Scene& scene, std::uint32_t kind) {
    return 0.5 * equivalent_diameter(scene.shapes[scene.kinds[kind].shape].mass_properties.volume);
}

const ContactLaw& law_of(const Scene& scene, const Encounter& e) {
    return scene.laws.at(e.material_i, e.material_j);
}

bool is_linear(const Scene& scene, const Encounter& e) {
    return law_of(scene, e).model == ContactLaw::Model::linear;
}

/// With two digits, rounded up: "11 MPa", "1.2 GPa".
std::string rounded_up(double value, const char* unit) {
    value = std::clamp(value, 1e-30, 1e30);  // speeds without sense need no end of stiffness
    double digit = 1.0;
    while (value < 10.0 * digit) digit /= 10.0;
    while (value >= 100.0 * digit) digit *= 10.0;
    const double rounded = digit * std::ceil(value / digit * (1.0 - 1e-9));
    if (unit[0] != 'P' || rounded < 1e3) return format("%.6g %s", rounded, unit);
    const double scale = rounded < 1e6 ? 1e3 : rounded < 1e9 ? 1e6 : 1e9;
    const char* prefix = rounded < 1e6 ? "k" : rounded < 1e9 ? "M" : "G";
    return format("%.6g %s%s", rounded / scale, prefix, unit);
}

/// The stiffness of the scene times `factor`, as the case file would say it.
std::string stiffer(const Scene& scene, const Encounter& e, double factor) {
    if (is_linear(scene, e)) {
        return "normal_stiffness = " +
               rounded_up(factor * law_of(scene, e).normal_stiffness, "N/m");
    }
    std::string text;
    for (const std::uint32_t m : std::set<std::uint32_t>{e.material_i, e.material_j}) {
        const Material& material = scene.materials[m];
        text += (text.empty() ? "" : " and ") + std::string("youngs_modulus = ") +
                rounded_up(factor * material.youngs_modulus, "Pa") + " in [material." +
                material.name + "]";
    }
    return text;
}

/// How much stiffer a contact must be that overlaps so much in an impact, in smaller radii.
double impact_factor(const Scene& scene, const Encounter& e, double overlap) {
    return math::pow(overlap / scene.run.overlap_limit, is_linear(scene, e) ? 2.0 : 2.5);
}

double load_factor(const Scene& scene, const Encounter& e, double overlap) {
    return math::pow(overlap / scene.run.overlap_limit, is_linear(scene, e) ? 1.0 : 1.5);
}

/// The time step of a contact is a twentieth of its duration at least.
constexpr double steps_per_contact = 20.0;

/// Duration of an elastic contact [s].
double contact_time(const Scene& scene, const Encounter& e, double speed) {
    const ContactLaw& law = law_of(scene, e);
    if (is_linear(scene, e)) return law.contact_time * std::sqrt(e.mass / law.normal_stiffness);
    return 2.8683 *
           math::pow(square(e.mass) / (e.radius * square(law.youngs_modulus) * speed), 0.2);
}

struct Foreseen {
    double overlap = 0.0;  ///< in smaller radii
    Encounter between;
    std::uint32_t kind = 0;
};

void keep_larger(Foreseen& largest, double overlap, const Encounter& e, std::uint32_t kind) {
    if (overlap > largest.overlap) largest = {overlap, e, kind};
}

/// Calls `visit` with every kind of bodies that can move and whom it may meet: of every material of
/// bodies the heaviest kind, and the walls.
template <class Visit>
void for_each_encounter(const Scene& scene, const Visit& visit) {
    std::map<std::uint32_t, std::uint32_t> heaviest;  // kind by material
    for (std::uint32_t k = 0; k < scene.kinds.size(); ++k) {
        const auto [entry, is_new] = heaviest.emplace(scene.kinds[k].material, k);
        if (!is_new && scene.kinds[k].mass > scene.kinds[entry->second].mass) entry->second = k;
    }
    std::set<std::uint32_t> walls;
    for (const Wall& wall : scene.walls) walls.insert(wall.material);
    for (std::uint32_t k = 0; k < scene.kinds.size(); ++k) {
        if (scene.kinds[k].inverse_inertia.mass == 0.0) continue;
        for (const auto& [material, other] : heaviest) visit(k, encounter(scene, k, other));
        for (const std::uint32_t wall : walls) visit(k, encounter_with_wall(scene, k, wall));
    }
}

/// All bodies as a bed on the ground that they have.
struct Bed {
    static constexpr double strongest_contact = 12.0;
    double weight = 0.0;  ///< [N]
    double bodies = 0.0;
    double ground = 0.0;  ///< [m^2]

    explicit Bed(const Scene& scene) {
        const double g = scene.run.gravity.norm();
        double mass = 0.0;
        for (const InsertionGroup& group : scene.insertions) {
            for (const BodyPlacement& body : group.placements) mass += scene.kinds[body.kind].mass;
            const auto count = static_cast<double>(
                group.placements.empty() ? group.count : group.placements.size());
            bodies += count;
            if (!group.placements.empty()) continue;
            const double share = count / static_cast<double>(group.kinds.size());
            for (const std::uint32_t k : group.kinds) mass += share * scene.kinds[k].mass;
        }
        weight = mass * g;
        const Aabb extent = scene_extent(scene);
        if (extent.is_empty() || g == 0.0) return;
        const Vec3 e = extent.upper - extent.lower;
        const Vec3 along = scene.run.gravity.cwiseAbs() / g;
        ground = Vec3(e.y() * e.z(), e.z() * e.x(), e.x() * e.y()).dot(along);
    }

    /// What the strongest contact at the bottom carries, as if nothing leaned on the walls: the
    /// pressure, at most that of a heap as wide as high, on a square of d_eq, times what it has
    /// more than the mean (up to ten in a settling bed of 400 spheres) [N].
    double load(double radius) const {
        const double own_square = square(2.0 * radius);
        return std::min(strongest_contact, bodies) * weight * own_square /
               std::max(ground, own_square * math::pow(bodies, 2.0 / 3.0));
    }
};

/// Calls `visit` with every kind and whom it may meet, and how far the two overlap in an impact at
/// a speed and in a bed, in smaller radii.
template <class Visit>
void for_each_foreseen(const Scene& scene, double speed, const Visit& visit) {
    const Bed bed(scene);
    for_each_encounter(scene, [&](std::uint32_t kind, const Encounter& e) {
        visit(kind, e, impact_overlap(scene, e, speed),
              load_overlap(scene, e, bed.load(sphere_radius(scene, kind))));
    });
}

/// Whether what makes one of them stiffer makes the other so.
bool share_a_stiffness(const Scene& scene, const Encounter& a, const Encounter& b) {
    const bool has_first = a.material_i == b.material_i || a.material_i == b.material_j;
    const bool has_second = a.material_j == b.material_i || a.material_j == b.material_j;
    if (is_linear(scene, a) || is_linear(scene, b)) return has_first && has_second;
    return has_first || has_second;
}

/// How much stiffer the materials of an encounter must be for all that is foreseen of them.
double foreseen_factor(const Scene& scene, const Encounter& e) {
    double factor = 0.0;
    for_each_foreseen(
        scene, largest_impact_speed(scene),
        [&](std::uint32_t, const Encounter& other, double impact_depth, double load_depth) {
            if (!share_a_stiffness(scene, e, other)) return;
            factor = std::max({factor, impact_factor(scene, other, impact_depth),
                               load_factor(scene, other, load_depth)});
        });
    return factor;
}

}  // namespace

Encounter encounter(const Scene& scene, std::uint32_t i, std::uint32_t j) {
    const BodyKind& a = scene.kinds[i];
    const BodyKind& b = scene.kinds[j];
    const double r_i = sphere_radius(scene, i);
    const double r_j = sphere_radius(scene, j);
    return {1.0 / (a.inverse_inertia.mass + b.inverse_inertia.mass), 1.0 / (1.0 / r_i + 1.0 / r_j),
            std::min(r_i, r_j), a.material, b.material};
}

Encounter encounter_with_wall(const Scene& scene, std::uint32_t i, std::uint32_t material) {
    const double r = sphere_radius(scene, i);
    return {1.0 / scene.kinds[i].inverse_inertia.mass, r, r, scene.kinds[i].material, material};
}

// Energy of motion and what is in the spring: (8/15) Y* sqrt(R*) d^(5/2) by Hertz.
double impact_overlap(const Scene& scene, const Encounter& e, double speed, double before) {
    const ContactLaw& law = law_of(scene, e);
    const double energy = 0.5 * e.mass * square(speed);
    if (is_linear(scene, e)) {
        return std::sqrt(2.0 * energy / law.normal_stiffness + square(before)) / e.smaller_radius;
    }
    const double stiffness = 8.0 / 15.0 * law.youngs_modulus * std::sqrt(e.radius);
    return math::pow(energy / stiffness + math::pow(before, 2.5), 0.4) / e.smaller_radius;
}

double load_overlap(const Scene& scene, const Encounter& e, double force) {
    const ContactLaw& law = law_of(scene, e);
    if (is_linear(scene, e)) return force / law.normal_stiffness / e.smaller_radius;
    const double stiffness = 4.0 / 3.0 * law.youngs_modulus * std::sqrt(e.radius);
    return math::pow(force / stiffness, 2.0 / 3.0) / e.smaller_radius;
}

std::string overlap_cause(const Scene& scene, const Encounter& e, double speed, double relative,
                          double dt) {
    const double overlap = relative * e.smaller_radius;
    // In a contact that is resolved the bodies come nearer by a small part of the overlap at a
    // time.
    if (speed * dt > 0.2 * overlap) {
        const double duration = contact_time(scene, e, speed);
        return format(
            "the time step of %.2g s is too long for a contact at %.3g m/s, expected %.2g s or "
            "less",
            dt, speed, duration / steps_per_contact);
    }
    const double impact = impact_overlap(scene, e, speed, overlap);
    // A bed that settles softly has no speed to tell how far it will go.
    const double load = load_overlap(scene, e, Bed(scene).load(e.smaller_radius));
    const double factor = std::max(
        {impact_factor(scene, e, impact), load_factor(scene, e, load), foreseen_factor(scene, e)});
    return "the material is too soft" + format(" (they approach at %.3g m/s), expected ", speed) +
           stiffer(scene, e, factor) + ", or a larger overlap_limit";
}

std::string foreseen_overlap(const Scene& scene) {
    Foreseen impact;
    Foreseen load;
    const double speed = largest_impact_speed(scene);
    for_each_foreseen(
        scene, speed,
        [&](std::uint32_t kind, const Encounter& e, double impact_depth, double load_depth) {
            keep_larger(impact, impact_depth, e, kind);
            keep_larger(load, load_depth, e, kind);
        });
    if (impact.overlap == 0.0 && load.overlap == 0.0) return "";
    std::string text = format(
        "overlap: up to about %.2g %% of the radius in impacts at %.3g m/s, %.2g %% under the "
        "weight "
        "of all bodies; a run stops at %.3g %%\n",
        100.0 * impact.overlap, speed, 100.0 * load.overlap, 100.0 * scene.run.overlap_limit);
    const auto warn = [&](const char* of, const Foreseen& foreseen, const std::string& remedy) {
        text += "warning: the material is too soft for " + std::string(of) + " of '" +
                scene.shapes[scene.kinds[foreseen.kind].shape].name + "', expected " + remedy +
                ", or a larger overlap_limit\n";
    };
    const double limit = scene.run.overlap_limit;
    if (impact.overlap > limit) {
        warn("the fastest impact", impact,
             stiffer(scene, impact.between, impact_factor(scene, impact.between, impact.overlap)));
    }
    if (load.overlap > limit) {
        warn("a bed", load,
             stiffer(scene, load.between, load_factor(scene, load.between, load.overlap)));
    }
    return text;
}

}  // namespace dem::runtime
