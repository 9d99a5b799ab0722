// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/time_step.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"
#include "common/text.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/domain.hpp"
#include "runtime/material_use.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace dem::runtime {

namespace {

double equivalent_radius(const Scene& scene, const BodyKind& kind) {
    return 0.5 * equivalent_diameter(scene.shapes[kind.shape].mass_properties.volume);
}

double rayleigh_time(const Material& material, double radius) {
    const double shear = shear_modulus({material.youngs_modulus, material.poissons_ratio});
    const double K = 0.8766 + 0.1631 * material.poissons_ratio;
    return pi * radius / K * std::sqrt(material.density / shear);
}

// Duration of an elastic contact of reduced mass m, reduced radius R and reduced modulus Y.
double hertz_time(double m, double R, double Y, double speed) {
    return 2.8683 * math::pow(square(m) / (R * square(Y) * speed), 0.2);
}

// Longest step of a body under the linear law, and whether it has another law as well.
struct LinearContacts {
    double longest = infinite;
    bool has_other = false;
};

// The divisor of the critical time holds for k_t up to 1.5 k_n, which no common material exceeds by
// Mindlin's law (AutomaticStep, tests/physics/contact_energy_test.cpp). A stiffer spring swings
// faster.
double tangential_factor(const Scene& scene, const BodyKind& kind, const MaterialUse& used) {
    constexpr double covered = 1.5;
    double stiffest = covered;
    for (const auto* partners : {&used.bodies, &used.walls}) {
        for (const std::uint32_t other : *partners) {
            const ContactLaw& law = scene.laws.at(kind.material, other);
            if (law.tangential != ContactLaw::Tangential::ratio) continue;
            stiffest = std::max(stiffest, law.stiffness_ratio);
        }
    }
    return std::sqrt(covered / stiffest);
}

double motion_time(const Scene& scene, double speed) {
    double time = infinite;
    for (const BodyKind& kind : scene.kinds) {
        if (speed > 0.0) time = std::min(time, equivalent_radius(scene, kind) / speed);
    }
    for (const Wall& wall : scene.walls) {
        time = std::min(time, half_period(wall.motion));
    }
    return time;
}

std::string text(double value, const char* unit = " s") {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g%s", value, unit);
    return buffer;
}

/// A line about the first wall whose motion takes it further than a radius of the smallest body in
/// a step, if there is one.
void check_motions(const Scene& scene, double dt) {
    double radius = infinite;
    for (const BodyKind& kind : scene.kinds)
        radius = std::min(radius, equivalent_radius(scene, kind));
    const Aabb extent = scene_extent(scene);
    const double reach = extent.is_empty() ? 0.0 : (extent.upper - extent.lower).norm();
    for (const Wall& wall : scene.walls) {
        const double way = dt * largest_speed(wall.motion, reach) / radius;
        if (!(way > 1.0)) continue;
        throw Error(wall.motion.where,
                    "wall " + in_quotes(wall.name) + " moves by up to " + text(way, " radii") +
                        " of the smallest body in a time step of " + text(dt) +
                        ", expected less than one: a slower motion or a shorter step");
    }
}

// The shortest contact of a body: with its like of any material, m/2 and R/2, or with a wall. A
// larger partner only lengthens it.
double shortest_contact(const Scene& scene, const BodyKind& kind, const MaterialUse& used,
                        double speed) {
    const double radius = equivalent_radius(scene, kind);
    double shortest = infinite;
    for (const std::uint32_t other : used.bodies) {
        const double Y = scene.laws.at(kind.material, other).youngs_modulus;
        if (!(Y > 0.0)) continue;  // a linear law
        shortest = std::min(shortest, hertz_time(0.5 * kind.mass, 0.5 * radius, Y, speed));
    }
    for (const std::uint32_t other : used.walls) {
        const double Y = scene.laws.at(kind.material, other).youngs_modulus;
        if (!(Y > 0.0)) continue;
        shortest = std::min(shortest, hertz_time(kind.mass, radius, Y, speed));
    }
    return shortest;
}

// The longest step of a linear contact, in units of sqrt(m/k_n): 0.4 of its duration, or less where
// a strong dashpot would make it diverge; zeta is the share of critical damping.
double linear_limit(const ContactLaw& law) {
    const double zeta = 0.5 * law.damping;
    return std::min(0.4 * law.contact_time, 1.6 * (std::sqrt(1.0 + square(zeta)) - zeta));
}

LinearContacts linear_contacts(const Scene& scene, const BodyKind& kind, const MaterialUse& used) {
    LinearContacts contacts;
    const auto look_at = [&](std::uint32_t other, double mass) {
        const ContactLaw& law = scene.laws.at(kind.material, other);
        if (law.model != ContactLaw::Model::linear) {
            contacts.has_other = true;
            return;
        }
        contacts.longest =
            std::min(contacts.longest, linear_limit(law) * std::sqrt(mass / law.normal_stiffness));
    };
    for (const std::uint32_t other : used.bodies) look_at(other, 0.5 * kind.mass);
    for (const std::uint32_t other : used.walls) look_at(other, kind.mass);
    return contacts;
}

/// Steps are counted, and times computed from the count, without rounding up to here.
constexpr double most_steps = 1e15;

}  // namespace

std::uint64_t step_count(const RunSettings& run, double dt, const std::string& where) {
    const double count = std::ceil(run.end_time / dt - 1e-6);
    if (count <= most_steps) return static_cast<std::uint64_t>(count);
    throw Error(where, "time step " + text(dt) + " makes " + text(count, " steps") +
                           " to end_time " + text(run.end_time) + ", expected at most 1e15");
}

TimeStep time_step(const Scene& scene) {
    const double speed = largest_expected_speed(scene) + largest_rim_speed(scene);
    TimeStep step{infinite, infinite, infinite, motion_time(scene, speed), speed, infinite, 0.0};
    const MaterialUse used = material_use(scene);
    for (const BodyKind& kind : scene.kinds) {
        if (kind.inverse_inertia.mass == 0.0) continue;
        const LinearContacts linear = linear_contacts(scene, kind, used);
        step.linear = std::min(step.linear, linear.longest);
        if (!linear.has_other) continue;
        const double factor = tangential_factor(scene, kind, used);
        const double radius = equivalent_radius(scene, kind);
        const double rayleigh = rayleigh_time(scene.materials[kind.material], radius);
        step.rayleigh = std::min(step.rayleigh, factor * rayleigh);
        if (speed > 0.0) {
            const double shortest = shortest_contact(scene, kind, used, speed);
            step.hertz = std::min(step.hertz, factor * shortest);
        }
    }
    step.critical = std::min({step.rayleigh, step.hertz, step.linear});
    const bool has_contact = !std::isinf(step.critical);
    if (has_contact) step.critical = std::min(step.critical, step.motion);
    if (scene.run.time_step) {
        step.value = *scene.run.time_step;
        if (step.value > step.critical && !scene.run.time_step_force) {
            check_motions(scene, step.value);
            throw Error(scene.case_path,
                        "time step " + text(step.value) + " is above the critical time step " +
                            text(step.critical) +
                            ", expected a tenth of it at most, or time_step_force = yes");
        }
        return step;
    }
    if (!has_contact) {
        throw Error(scene.case_path,
                    "found time_step = auto where no body can move, expected a time_step");
    }
    step.value = step.critical / scene.run.time_step_divisor;
    if (!(step.value > 0.0 && step.value <= scene.run.end_time)) {
        throw Error(
            scene.case_path,
            "time_step = auto gives " + text(step.value) + " for an end_time of " +
                text(scene.run.end_time) +
                ", expected a shorter one; check sizes, speeds, density and Young's modulus");
    }
    return step;
}

}  // namespace dem::runtime
