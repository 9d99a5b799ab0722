// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/effective_radius.hpp"
#include "runtime/contact/law/motion.hpp"
#include "runtime/contact/law/normal.hpp"
#include "runtime/contact/law/patch_slots.hpp"
#include "runtime/contact/law/tangential.hpp"
#include "runtime/contact/law/whole_force.hpp"

#include <cmath>

/// All contact points of a pair as one Hertzian contact (docs/contact.md, "Many points"):
///   d = (sum d_k^p)^(1/p), w_k = (d_k / d)^(p-1), p = 16
///   f_k = w_k (k_n(d) d + gamma(d) d'_k)      from the potential of d and one dashpot per pair
/// d_k overlap of point k, d'_k its rate, f_k its force along its own gradient. A point of negative
/// overlap -d_k counts against the others: the sum is then with -d_k^p, and w_k < 0.
namespace dem::runtime {

namespace {

double sixteenth_root(double x) {
    return std::sqrt(std::sqrt(std::sqrt(std::sqrt(x))));
}
double power_15(double x) {
    const double x2 = x * x;
    const double x4 = x2 * x2;
    return x4 * x4 * x4 * x2 * x;
}
/// With the sign of x.
double power_16(double x) {
    return std::copysign(square(square(square(square(x)))), x);
}

/// What one point contributes.
struct Share {
    Vec3 velocity;  ///< relative, at the point [m/s]
    NormalForce normal;
    double k_t, gamma_t;  ///< of its tangential spring and dashpot
    double elastic;       ///< normal part, where points have their own [J]
};

/// multi_contact = norm: one potential for the pair.
class NormPatch {
  public:
    NormPatch(std::span<const ContactPoint> points, const PairState& pair, const ContactLaw& law,
              double radius)
        : pair_(pair), law_(law) {
        double deepest = 0.0;
        for (const ContactPoint& p : points) deepest = std::max(deepest, p.overlap);
        double sum = 0.0;
        for (const ContactPoint& p : points) sum += power_16(p.overlap / deepest);
        overlap_ = deepest * sixteenth_root(sum);

        Vec3 g = Vec3::Zero();
        Vec3 t_i = Vec3::Zero();
        Vec3 t_j = Vec3::Zero();
        double weights = 0.0;
        for (const ContactPoint& p : points) {
            const double w = power_15(p.overlap / overlap_);
            const Vec3 wg = w * p.gradient;
            g += wg;
            t_i += p.position.cross(wg);
            t_j += (p.position - pair.displacement).cross(wg);
            weights += w;
        }
        // gamma = sqrt(5) |beta| sqrt(m_e W^2 k_n): one point and many coinciding ones are the
        // same.
        const double inverse_mass = law.damping_mass == ContactLaw::DampingMass::contact
                                        ? inverse_contact_mass(pair, g, t_i, t_j) / square(weights)
                                        : inverse_reduced_mass(pair);
        coefficients_ =
            contact_coefficients(law, radius, overlap_, inverse_mass, tangential_inertia(pair));
        elastic_ = elastic_share(law) * coefficients_.k_n * square(overlap_);
    }

    Share share(const ContactPoint& p, double dt) const {
        const ContactCoefficients& c = coefficients_;
        const double w = power_15(p.overlap / overlap_);
        const Vec3 velocity = relative_velocity(pair_, p.position);
        const Pressing pressing{overlap_, -velocity.dot(p.gradient), w};
        return {velocity, normal_force(law_, c, pressing, dt), w * c.k_t, w * c.gamma_t, 0.0};
    }

    double overlap() const { return overlap_; }
    double elastic() const { return elastic_; }
    double frequency() const { return coefficients_.frequency; }

  private:
    const PairState& pair_;
    const ContactLaw& law_;
    double overlap_ = 0.0;
    double elastic_ = 0.0;
    ContactCoefficients coefficients_{};
};

/// multi_contact = sum, [SR] Eq. 17: every point a full spring-dashpot of its own.
class SumPatch {
  public:
    SumPatch(std::span<const ContactPoint> points, const PairState& pair, const ContactLaw& law,
             double radius)
        : pair_(pair), law_(law), radius_(radius) {
        const ContactPoint* deepest = &points.front();
        for (const ContactPoint& p : points)
            if (p.overlap > deepest->overlap) deepest = &p;
        overlap_ = deepest->overlap;
        frequency_ = coefficients(*deepest).frequency;
    }

    Share share(const ContactPoint& p, double dt) const {
        const ContactCoefficients c = coefficients(p);
        const Vec3 velocity = relative_velocity(pair_, p.position);
        const NormalForce normal =
            normal_force(law_, c, {p.overlap, -velocity.dot(p.gradient)}, dt);
        return {velocity, normal, c.k_t, c.gamma_t,
                elastic_share(law_) * normal.elastic_part * p.overlap};
    }

    double overlap() const { return overlap_; }
    static double elastic() { return 0.0; }  // the points have it
    double frequency() const { return frequency_; }

  private:
    ContactCoefficients coefficients(const ContactPoint& p) const {
        const Vec3& g = p.gradient;
        const double inverse_mass =
            law_.damping_mass == ContactLaw::DampingMass::contact
                ? inverse_contact_mass(pair_, g, p.position.cross(g),
                                       (p.position - pair_.displacement).cross(g))
                : inverse_reduced_mass(pair_);
        return contact_coefficients(law_, radius_, p.overlap, inverse_mass,
                                    tangential_inertia(pair_));
    }

    const PairState& pair_;
    const ContactLaw& law_;
    double radius_;
    double overlap_ = 0.0;
    double frequency_ = 0.0;
};

void add_force(PairContact& contact, const Vec3& force, const Vec3& r_i, const PairState& pair) {
    contact.force += force;
    contact.torque_i += r_i.cross(force);
    contact.torque_j -= (r_i - pair.displacement).cross(force);
}

/// What contact_force was called with, and R* of this step.
struct PatchInput {
    std::span<const ContactPoint> points;
    const PairState& pair;
    const ContactLaw& law;
    double dt;
    PatchHistory& history;
    double radius, local_radius;
};

/// The elastic parts of the forces of some points, and where they act.
struct Load {
    double force = 0.0;             ///< [N]
    Vec3 moment = Vec3::Zero();     ///< of places relative to the center of i [N m]
    Vec3 direction = Vec3::Zero();  ///< sum of the forces [N]

    void add(double elastic_part, const ContactPoint& point) {
        force += elastic_part;
        moment += elastic_part * point.position;
        direction += elastic_part * point.gradient;
    }
};

/// How the points in slots stand for all.
struct StandIn {
    double scale = 1.0;         ///< of their friction
    Vec3 shift = Vec3::Zero();  ///< from where they carry the load to where all do [m]
};

template <class PointPatch>
StandIn stand_in(const PointPatch& patch, const PatchInput& call, const PatchSlots& chosen,
                 const Load& load) {
    if (chosen.count == call.points.size()) return {};
    Load held;
    for (std::size_t k = 0; k < chosen.count; ++k) {
        const ContactPoint& p = call.points[chosen.point[k]];
        held.add(patch.share(p, call.dt).normal.elastic_part, p);
    }
    if (!(held.force > 0.0)) return {};
    return {load.force / held.force, load.moment / load.force - held.moment / held.force};
}

/// Adds the friction of the points in slots.
template <class PointPatch>
void add_friction(const PointPatch& patch, const PatchInput& call, const Load& load,
                  PairContact& contact, ContactEnergy& energy) {
    const PatchSlots chosen = choose_slots(call.points, call.history);
    const auto [scale, shift] = stand_in(patch, call, chosen, load);
    for (std::size_t k = 0; k < chosen.count; ++k) {
        const ContactPoint& p = call.points[chosen.point[k]];
        const Vec3 place = p.position + shift;
        const Share s = patch.share(p, call.dt);
        const Vec3 n = p.gradient.normalized();
        PatchHistory::Slot& slot = call.history.slots[k];
        const Sliding sliding{
            place == p.position ? s.velocity : relative_velocity(call.pair, place),
            n,
            slot.normal,
            spin_about(call.pair, n) * call.dt,
            !chosen.known[k],
            call.dt};
        const double load_here = friction_load(call.law, s.normal.elastic_part, s.normal.size);
        const SlippingSpring spring{scale * s.k_t, scale * s.gamma_t,
                                    call.law.friction * scale * load_here};
        const Vec3 force = friction_force(spring, sliding, call.history.dissipated, slot, energy);
        slot.feature = p.feature;
        slot.normal = n;
        add_force(contact, force, place, call.pair);
        contact.friction += force;
        contact.friction_limit += spring.limit;
    }
    call.history.used = chosen.count;
}

/// The patch as one contact.
WholeContact whole_contact(const PatchInput& call, const Load& load, double overlap,
                           double normal_force) {
    const double size = load.direction.norm();
    const Vec3 normal =
        size > 0.0 ? Vec3(load.direction / size) : call.points.front().gradient.normalized();
    const double force = std::max(load.force, 0.0);
    return {call.pair,
            call.dt,
            !call.history.touched(),
            normal,
            call.history.normal,
            force > 0.0 ? Vec3(load.moment / force) : call.points.front().position,
            force / overlap,
            friction_load(call.law, force, std::max(normal_force, 0.0)),
            call.history.dissipated};
}

template <class PointPatch>
PairContact patch_force(const PatchInput& call) {
    const PointPatch patch(call.points, call.pair, call.law, call.radius);
    PairContact contact;
    ContactEnergy energy;
    Load load;
    double normal_force = 0.0;
    for (const ContactPoint& p : call.points) {
        const Share s = patch.share(p, call.dt);
        add_force(contact, s.normal.size * p.gradient, p.position, call.pair);
        load.add(s.normal.elastic_part, p);
        normal_force += s.normal.size;
        energy.elastic += s.elastic;
        energy.dissipated += s.normal.dissipated;
    }
    energy.elastic += patch.elastic();
    const double normal_elastic = energy.elastic;
    const WholeContact whole = whole_contact(call, load, patch.overlap(), normal_force);
    if (call.law.friction > 0.0) add_friction(patch, call, load, contact, energy);
    const Vec3 moment =
        end_step(call.law, whole,
                 {call.local_radius, call.radius, patch.frequency() * call.dt, normal_elastic},
                 call.history, energy);
    contact.torque_i += moment;
    contact.torque_j -= moment;
    contact.overlap = patch.overlap();
    contact.place = whole.center;
    contact.normal = whole.normal;
    contact.normal_force = normal_force;
    contact.points = static_cast<std::uint32_t>(call.points.size());
    contact.elastic_energy = energy.elastic;
    contact.dissipated_energy = energy.dissipated;
    return contact;
}

/// One point that is not just losing others: the plain law, half as dear as a patch of one.
bool is_single(std::span<const ContactPoint> points, const PatchHistory& history) {
    return points.size() == 1 &&
           (history.used == 0 ||
            (history.used == 1 && points[0].feature == history.slots[0].feature));
}
PairContact single_force(const ContactPoint& point, double local_radius, const PairState& pair,
                         const ContactLaw& law, double dt, PatchHistory& history) {
    PointHistory single = as_point(history, law);
    PairContact contact = contact_force(point, local_radius, pair, law, dt, single);
    keep_point(single, point.feature, history);
    return contact;
}

}  // namespace

PairContact contact_force(std::span<const ContactPoint> points, double local_radius,
                          const PairState& pair, const ContactLaw& law, double dt,
                          PatchHistory& history) {
    if (points.empty()) return parting(history);
    ContactPoint deepest = points.front();
    if (law.geometry.multi_contact == ContactLaw::MultiContact::deepest) {
        for (const ContactPoint& p : points)
            if (p.overlap > deepest.overlap) deepest = p;
        deepest.feature = 0;  // one spring, whichever point is deepest
        points = std::span(&deepest, 1);
    }
    if (is_single(points, history))
        return single_force(points[0], local_radius, pair, law, dt, history);
    PatchInput input{points, pair, law, dt, history, 0.0, local_radius};
    input.radius = effective_radius(law, local_radius, history);
    if (law.geometry.multi_contact == ContactLaw::MultiContact::sum)
        return patch_force<SumPatch>(input);
    return patch_force<NormPatch>(input);
}

}  // namespace dem::runtime
