// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/feature_patch.hpp"
#include "runtime/contact/law/contact_mass.hpp"
#include "runtime/contact/law/hertz_mindlin.hpp"
#include "runtime/contact/law/point_force.hpp"

namespace dem {

namespace {

/// The features together, with true weights.
struct Patch {
    double overlap;
    double weight;   ///< sum w_k
    Vec3 normal;     ///< unit
    Vec3 center;     ///< [m]
    double load;     ///< that friction is a share of [N]
    double spread2;  ///< [m^2]
    hertz::Coefficients c;
};

void add_normal(const FeatureSum& features, const ContactLaw& law, double dt, Patch& patch,
                PairContact& contact) {
    const double scale = features.scale();
    const double spring = scale * patch.c.k_n * features.overlap();
    const double share =
        hertz::dashpot_share(law, patch.c, patch.overlap, scale * features.rate(), dt);
    const double dashpot = share * scale * patch.c.gamma_n;
    const double elastic_part = spring * features.weight();
    const double normal_force = elastic_part + dashpot * features.rate();
    patch.load = hertz::friction_load(law, elastic_part, std::max(normal_force, 0.0));
    if (law.limit_force && normal_force < 0.0) {
        contact.dissipated_energy -= spring * features.rate() * dt;
        return;
    }
    PairWrench sum;
    sum.add(spring, features.direction());
    sum.add(spring, features.of_weights());
    sum.add(dashpot, features.rates());
    contact.force = sum.force;
    contact.torque_i = sum.torque_i;
    contact.torque_j = sum.torque_j;
    contact.dissipated_energy += dashpot * features.squared_rate() * dt;
}

/// Twist of the contact against its torsion spring; what the tangential spring is to sliding.
void add_torsion(const Patch& patch, const PairState& pair, const ContactLaw& law, double dt,
                 ConvexHistory& history, PairContact& contact) {
    const double k = patch.c.k_t * patch.weight * patch.spread2;
    const double gamma = patch.c.gamma_t * patch.weight * patch.spread2;
    const double limit = law.friction * patch.load * std::sqrt(patch.spread2);
    const double rate = (pair.i.angular_velocity - pair.j.angular_velocity).dot(patch.normal);
    // Friction that is new to the patch starts without stretch: the torque stays, a part of the
    // twist goes. What leaves the patch takes its energy along.
    const double before = history.twist_stiffness;
    const double kept = k > before ? before / k : 1.0;
    contact.dissipated_energy += 0.5 * (before - k * square(kept)) * square(history.twist);
    history.twist_stiffness = k;
    Vec3 lead(0.0, 0.0, kept * history.twist);
    const hertz::TangentialForce t =
        hertz::tangential_force(k, gamma, limit, Vec3(0.0, 0.0, rate), dt, lead);
    history.twist = k > 0.0 ? lead.z() : 0.0;
    const Vec3 torque = t.force.z() * patch.normal;
    contact.torque_i += torque;
    contact.torque_j -= torque;
    contact.elastic_energy += t.elastic;
    contact.dissipated_energy += t.dissipated;
}

/// How many overlaps long the spring of a contact without slip may be before it lets go: no less
/// than a force of no_slip normal ones stretches it, and than it has been in the loaded contact.
/// `stretch`: its length now [m].
double held_ratio(const Patch& patch, double stretch, double dt, ConvexHistory& history) {
    // A contact that stays forgets how it began.
    if (history.phase > hertz::settled_phase)
        history.deepest *= 1.0 - std::min(1.0, patch.c.frequency * dt / hertz::drift_phase);
    history.deepest = std::max(history.deepest, patch.overlap);
    if (patch.overlap >= 0.5 * history.deepest)
        history.held = std::max(history.held, stretch / patch.overlap);
    return std::max(hertz::no_slip * patch.c.k_n / patch.c.k_t, 1.05 * history.held);
}

/// A spring longer than this many overlaps would push so hard that a step cannot follow: the push
/// is as stiff as 2 ratio^2 k_t / k_n normal springs.
double longest_ratio(const Patch& patch, double dt) {
    return std::sqrt(0.5 * patch.c.k_n / patch.c.k_t) / (patch.c.frequency * dt);
}

struct SpringForce {
    hertz::TangentialForce along;
    double push = 0.0;  ///< along the gradient of the overlap [N]
};

/// The spring and dashpot along the surface; in a contact without slip that ends while the spring
/// is stretched, the spring gives its energy back as a push.
SpringForce spring_force(const Patch& patch, const ContactLaw& law, const Vec3& u_t, double dt,
                         ConvexHistory& history, Vec3& lead) {
    const double k_t = patch.c.k_t * patch.weight;
    const double gamma_t = patch.c.gamma_t * patch.weight;
    const double limit = law.friction * patch.load;
    if (!hertz::gives_back(law) || !(k_t > 0.0))
        return {hertz::tangential_force(k_t, gamma_t, limit, u_t, dt, lead)};
    const Vec3 half_way = 0.5 * dt * u_t;
    const Vec3 spring = lead + half_way;
    const double length = spring.norm();
    const double ratio = held_ratio(patch, length, dt, history);
    if (ratio > longest_ratio(patch, dt) || !(length > ratio * patch.overlap))
        return {hertz::tangential_force(k_t, gamma_t, limit, u_t, dt, lead)};
    const hertz::LettingGo go = hertz::letting_go(k_t, length, ratio, patch.overlap);
    lead = spring + half_way;
    return {{(-go.force / length) * spring - gamma_t * u_t, go.energy,
             gamma_t * u_t.squaredNorm() * dt},
            go.push};
}

void add_push(const FeatureSum& features, double push, PairContact& contact) {
    PairWrench sum;
    sum.add(push * features.scale(), features.direction());
    sum.add(push * features.scale(), features.of_weights());
    contact.force += sum.force;
    contact.torque_i += sum.torque_i;
    contact.torque_j += sum.torque_j;
}

void add_friction(const Patch& patch, const FeatureSum& features, const ContactLaw& law, double dt,
                  ConvexHistory& history, PairContact& contact) {
    const PairState& pair = features.pair();
    const Vec3& n = patch.normal;
    const Vec3 u = relative_velocity(pair, patch.center);
    const Vec3 u_t = u - u.dot(n) * n;
    Vec3 spring = Vec3::Zero();
    double before = history.stiffness;
    if (history.effective_radius > 0.0) {
        const double spin = 0.5 * n.dot(pair.i.angular_velocity + pair.j.angular_velocity);
        spring = hertz::carried(history.spring, history.normal, n, spin * dt);
        // As the twist below.
        const double kept = std::min(history.weight / patch.weight, 1.0);
        contact.dissipated_energy += 0.5 * before * (1.0 - kept) * spring.squaredNorm();
        before /= kept;
        spring *= kept;
    } else {
        history.twist = 0.0;
    }
    const double k_t = patch.c.k_t * patch.weight;
    contact.dissipated_energy +=
        hertz::restiffen(before, k_t, history.dissipated + contact.dissipated_energy, spring);
    const SpringForce force = spring_force(patch, law, u_t, dt, history, spring);
    if (force.push > 0.0) add_push(features, force.push, contact);
    const hertz::TangentialForce& t = force.along;
    history.spring = spring;
    history.stiffness = k_t;
    history.weight = patch.weight;
    contact.force += t.force;
    contact.torque_i += patch.center.cross(t.force);
    contact.torque_j -= (patch.center - pair.displacement).cross(t.force);
    contact.elastic_energy += t.elastic;
    contact.dissipated_energy += t.dissipated;
    add_torsion(patch, pair, law, dt, history, contact);
}

}  // namespace

PairContact contact_force(const FeatureSum& features, double local_radius, const ContactLaw& law,
                          double dt, ConvexHistory& history) {
    const PairState& pair = features.pair();
    const double radius = hertz::effective_radius(law, local_radius, history);
    const PairWrench& g = features.direction();
    // Of one point and of many coinciding ones the mass is the same.
    const double inverse_mass = law.damping_mass == ContactLaw::DampingMass::contact
                                    ? inverse_contact_mass(pair, g.force, g.torque_i, g.torque_j) /
                                          square(features.weight())
                                    : inverse_reduced_mass(pair);
    Patch patch{};
    patch.overlap = features.overlap();
    patch.weight = features.scale() * features.weight();
    const double length = g.force.norm();
    patch.normal = length > 0.0 ? Vec3(g.force / length) : Vec3::UnitZ();
    patch.center = features.center();
    patch.spread2 = features.squared_spread();
    patch.c = hertz::coefficients(law, radius, patch.overlap, inverse_mass,
                                  hertz::tangential_inertia(pair));

    PairContact contact;
    add_normal(features, law, dt, patch, contact);
    const double elastic = hertz::elastic_share(law) * patch.c.k_n * square(patch.overlap);
    contact.elastic_energy = elastic;
    if (law.friction > 0.0) add_friction(patch, features, law, dt, history, contact);
    history.normal = patch.normal;
    contact.overlap = patch.overlap;
    contact.points = features.count();
    history.dissipated += contact.dissipated_energy;
    contact.dissipated_energy +=
        hertz::age(law, local_radius, radius, patch.c.frequency * dt, elastic, history);
    return contact;
}

}  // namespace dem
