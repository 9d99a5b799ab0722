// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/feature_patch.hpp"
#include "runtime/contact/law/effective_radius.hpp"
#include "runtime/contact/law/motion.hpp"
#include "runtime/contact/law/normal.hpp"
#include "runtime/contact/law/tangential.hpp"
#include "runtime/contact/law/torsion.hpp"
#include "runtime/contact/law/whole_force.hpp"

namespace dem::runtime {

namespace {

/// The features together, with true weights.
struct FeaturePatch {
    double overlap;
    double weight;   ///< sum w_k
    Vec3 normal;     ///< unit
    Vec3 center;     ///< [m]
    double spread2;  ///< [m^2]
    ContactCoefficients c;
    double load = 0.0;  ///< that friction is a share of [N]

    SlippingSpring tangential(const ContactLaw& law) const {
        return {c.k_t * weight, c.gamma_t * weight, law.friction * load};
    }
};

void add_normal(const FeatureSum& features, const ContactLaw& law, double dt, FeaturePatch& patch,
                PairContact& contact, ContactEnergy& energy) {
    const double scale = features.scale();
    const double spring = scale * patch.c.k_n * features.overlap();
    const double share = dashpot_share(law, patch.c, patch.overlap, scale * features.rate(), dt);
    const double dashpot = share * scale * patch.c.gamma_n;
    const double elastic_part = spring * features.weight();
    const double normal_force = elastic_part + dashpot * features.rate();
    patch.load = friction_load(law, elastic_part, std::max(normal_force, 0.0));
    if (law.limit_force && normal_force < 0.0) {
        energy.dissipated -= spring * features.rate() * dt;
        return;
    }
    PairWrench sum;
    sum.add(spring, features.direction());
    sum.add(spring, features.of_weights());
    sum.add(dashpot, features.rates());
    contact.force = sum.force;
    contact.torque_i = sum.torque_i;
    contact.torque_j = sum.torque_j;
    contact.normal_force = normal_force;
    energy.dissipated += dashpot * features.squared_rate() * dt;
}

/// What contact_force was called with, and the energies it adds up.
struct Step {
    const FeatureSum& features;
    const ContactLaw& law;
    double dt;
    ConvexHistory& history;
    ContactEnergy& energy;
};

void add_torsion(const FeaturePatch& patch, const Step& step, PairContact& contact) {
    const PairState& pair = step.features.pair();
    const double rate = (pair.i.angular_velocity - pair.j.angular_velocity).dot(patch.normal);
    const SlippingSpring spring = torsion_spring(patch.tangential(step.law), patch.spread2);
    const Vec3 torque =
        torsion_moment(spring, rate, step.dt, step.history, step.energy) * patch.normal;
    contact.torque_i += torque;
    contact.torque_j -= torque;
}

/// How many overlaps long the spring of a contact without slip may be before it lets go: no less
/// than a force of no_slip normal ones stretches it, and than it has been in the loaded contact.
/// `stretch`: its length now [m].
double held_ratio(const FeaturePatch& patch, double stretch, double dt, ConvexHistory& history) {
    // A contact that stays forgets how it began.
    if (history.phase > settled_phase)
        history.deepest *= 1.0 - std::min(1.0, patch.c.frequency * dt / drift_phase);
    history.deepest = std::max(history.deepest, patch.overlap);
    if (patch.overlap >= 0.5 * history.deepest)
        history.held = std::max(history.held, stretch / patch.overlap);
    return std::max(no_slip * patch.c.k_n / patch.c.k_t, 1.05 * history.held);
}

/// A spring longer than this many overlaps would push so hard that a step cannot follow: the push
/// is as stiff as 2 ratio^2 k_t / k_n normal springs.
double longest_ratio(const FeaturePatch& patch, double dt) {
    return std::sqrt(0.5 * patch.c.k_n / patch.c.k_t) / (patch.c.frequency * dt);
}

struct FrictionForce {
    SpringForce along;
    double push = 0.0;  ///< along the gradient of the overlap [N]
};

/// The spring and dashpot along the surface; in a contact without slip that ends while the spring
/// is stretched, the spring gives its energy back as a push.
FrictionForce along_surface(const FeaturePatch& patch, const ContactLaw& law, const Vec3& u_t,
                            double dt, ConvexHistory& history, Vec3& lead) {
    const SlippingSpring s = patch.tangential(law);
    if (!gives_back(law) || !(s.k > 0.0)) return {slipping_force(s, u_t, dt, lead)};
    const Vec3 half_way = 0.5 * dt * u_t;
    const Vec3 spring = lead + half_way;
    const double length = spring.norm();
    const double ratio = held_ratio(patch, length, dt, history);
    if (ratio > longest_ratio(patch, dt) || !(length > ratio * patch.overlap))
        return {slipping_force(s, u_t, dt, lead)};
    const LettingGo go = letting_go(s.k, length, ratio, patch.overlap);
    lead = spring + half_way;
    return {{(-go.force / length) * spring - s.gamma * u_t, go.energy,
             s.gamma * u_t.squaredNorm() * dt},
            go.push};
}

void add_push(const FeatureSum& features, double push, PairContact& contact) {
    PairWrench sum;
    sum.add(push * features.scale(), features.direction());
    sum.add(push * features.scale(), features.of_weights());
    contact.force += sum.force;
    contact.torque_i += sum.torque_i;
    contact.torque_j += sum.torque_j;
    contact.normal_force += push * features.scale() * features.weight();
}

/// Where friction acts, relative to the center of i [m]: at the load. As long as it holds a contact
/// that has settled, it stays where it is on the surfaces, as far from the load as the points
/// reach. If it went along with the load of a body that rocks it would turn the body with every
/// rock, and what is turned is pushed aside by its spring and rocks: bodies swung for ever.
Vec3 place_of_friction(const FeaturePatch& patch, const Step& step) {
    const FeatureSum& features = step.features;
    if (!(step.history.phase > settled_phase) || features.count() == 1) return patch.center;
    const PairState& pair = features.pair();
    const Vec3 last = step.history.place;
    // Carried by both bodies alike.
    const Vec3 by_j =
        pair.j.velocity - pair.i.velocity + pair.j.angular_velocity.cross(last - pair.displacement);
    const Vec3 way = 0.5 * step.dt * (pair.i.angular_velocity.cross(last) + by_j);
    Vec3 away = last + way - patch.center;
    away -= away.dot(patch.normal) * patch.normal;
    const double size2 = away.squaredNorm();
    if (!(size2 > 0.0)) return patch.center;
    return patch.center + std::min(1.0, std::sqrt(features.squared_spread(away)) / size2) * away;
}

void add_friction(const FeaturePatch& patch, const Step& step, PairContact& contact) {
    const auto& [features, law, dt, history, energy] = step;
    const PairState& pair = features.pair();
    const Vec3& n = patch.normal;
    const Vec3 place = place_of_friction(patch, step);
    const Vec3 u = relative_velocity(pair, place);
    const Vec3 u_t = u - u.dot(n) * n;
    Vec3 spring = Vec3::Zero();
    double before = history.stiffness;
    if (history.touched()) {
        spring = carried(history.spring, history.normal, n, spin_about(pair, n) * dt);
        // Friction that is new to the patch starts without stretch, as in torsion_moment().
        const double kept = std::min(history.weight / patch.weight, 1.0);
        energy.dissipated += 0.5 * before * (1.0 - kept) * spring.squaredNorm();
        before /= kept;
        spring *= kept;
    } else {
        history.twist = 0.0;
    }
    const double k_t = patch.c.k_t * patch.weight;
    energy.dissipated += restiffen(before, k_t, history.dissipated + energy.dissipated, spring);
    const FrictionForce force = along_surface(patch, law, u_t, dt, history, spring);
    if (force.push > 0.0) add_push(features, force.push, contact);
    const SpringForce& t = force.along;
    history.spring = spring;
    history.stiffness = k_t;
    history.weight = patch.weight;
    contact.friction = t.force;
    contact.friction_limit = law.friction * patch.load;
    contact.force += t.force;
    contact.torque_i += place.cross(t.force);
    contact.torque_j -= (place - pair.displacement).cross(t.force);
    const bool slips = t.force.norm() > (1.0 - 1e-9) * law.friction * patch.load;
    history.place = slips ? patch.center : place;
    energy.elastic += t.elastic;
    energy.dissipated += t.dissipated;
    add_torsion(patch, step, contact);
}

FeaturePatch patch_of(const FeatureSum& features, double radius, const ContactLaw& law) {
    const PairState& pair = features.pair();
    const PairWrench& g = features.direction();
    // Of one point and of many coinciding ones the mass is the same.
    const double inverse_mass = law.damping_mass == ContactLaw::DampingMass::contact
                                    ? inverse_contact_mass(pair, g.force, g.torque_i, g.torque_j) /
                                          square(features.weight())
                                    : inverse_reduced_mass(pair);
    const double overlap = features.overlap();
    const double length = g.force.norm();
    return {overlap,
            features.scale() * features.weight(),
            length > 0.0 ? Vec3(g.force / length) : Vec3::UnitZ(),
            features.center(),
            features.squared_spread(),
            contact_coefficients(law, radius, overlap, inverse_mass, tangential_inertia(pair))};
}

}  // namespace

PairContact contact_force(const FeatureSum& features, double local_radius, const ContactLaw& law,
                          double dt, ConvexHistory& history) {
    const double radius = effective_radius(law, local_radius, history);
    FeaturePatch patch = patch_of(features, radius, law);
    PairContact contact;
    ContactEnergy energy;
    add_normal(features, law, dt, patch, contact, energy);
    const double elastic = elastic_share(law) * patch.c.k_n * square(patch.overlap);
    energy.elastic = elastic;
    const WholeContact whole{
        features.pair(),   dt,           !history.touched(),         patch.normal,
        history.normal,    patch.center, patch.c.k_n * patch.weight, patch.load,
        history.dissipated};
    if (law.friction > 0.0) add_friction(patch, {features, law, dt, history, energy}, contact);
    const Vec3 moment = end_step(
        law, whole, {local_radius, radius, patch.c.frequency * dt, elastic}, history, energy);
    contact.torque_i += moment;
    contact.torque_j -= moment;
    contact.place = patch.center;
    contact.normal = patch.normal;
    contact.overlap = patch.overlap;
    contact.points = features.count();
    contact.elastic_energy = energy.elastic;
    contact.dissipated_energy = energy.dissipated;
    return contact;
}

}  // namespace dem::runtime
