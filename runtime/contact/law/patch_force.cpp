// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/contact_mass.hpp"
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/law/hertz_mindlin.hpp"
#include "runtime/contact/law/patch_slots.hpp"
#include "runtime/contact/law/point_force.hpp"

#include <cmath>

/// All contact points of a pair as one Hertzian contact (docs/contact.md, "Many points"):
///   d = (sum d_k^p)^(1/p), w_k = (d_k / d)^(p-1), p = 16
///   f_k = w_k (k_n(d) d + gamma(d) d'_k)      from the potential of d and one dashpot per pair
/// d_k overlap of point k, d'_k its rate, f_k its force along its own gradient. A point of negative
/// overlap -d_k counts against the others: the sum is then with -d_k^p, and w_k < 0.
namespace dem {

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
    Vec3 velocity;        ///< relative, at the point [m/s]
    double elastic_part;  ///< of the force along the gradient [N]
    double force;         ///< along the gradient [N]
    double k_t, gamma_t;  ///< of its tangential spring and dashpot
    double elastic;       ///< normal part, where points have their own [J]
    double dissipated;    ///< normal part [J]
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
        coefficients_ = hertz::coefficients(law, radius, overlap_, inverse_mass,
                                            hertz::tangential_inertia(pair));
        elastic_ = hertz::elastic_share(law) * coefficients_.k_n * square(overlap_);
    }

    Share share(const ContactPoint& p, double dt) const {
        const hertz::Coefficients& c = coefficients_;
        const double w = power_15(p.overlap / overlap_);
        Share s{};
        s.velocity = relative_velocity(pair_, p.position);
        const double rate = -s.velocity.dot(p.gradient);
        s.elastic_part = w * c.k_n * overlap_;
        s.force = s.elastic_part +
                  hertz::dashpot_share(law_, c, overlap_, rate, dt) * w * c.gamma_n * rate;
        if (law_.limit_force && w > 0.0) s.force = std::max(s.force, 0.0);
        s.dissipated = (s.force - s.elastic_part) * rate * dt;
        s.k_t = w * c.k_t;
        s.gamma_t = w * c.gamma_t;
        return s;
    }

    double overlap() const { return overlap_; }
    double elastic() const { return elastic_; }
    double frequency() const { return coefficients_.frequency; }

  private:
    const PairState& pair_;
    const ContactLaw& law_;
    double overlap_ = 0.0;
    double elastic_ = 0.0;
    hertz::Coefficients coefficients_{};
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
        const hertz::Coefficients c = coefficients(p);
        Share s{};
        s.velocity = relative_velocity(pair_, p.position);
        const double rate = -s.velocity.dot(p.gradient);
        s.elastic_part = c.k_n * p.overlap;
        s.force =
            s.elastic_part + hertz::dashpot_share(law_, c, p.overlap, rate, dt) * c.gamma_n * rate;
        if (law_.limit_force) s.force = std::max(s.force, 0.0);
        s.dissipated = (s.force - s.elastic_part) * rate * dt;
        s.k_t = c.k_t;
        s.gamma_t = c.gamma_t;
        s.elastic = hertz::elastic_share(law_) * s.elastic_part * p.overlap;
        return s;
    }

    double overlap() const { return overlap_; }
    static double elastic() { return 0.0; }  // the points have it
    double frequency() const { return frequency_; }

  private:
    hertz::Coefficients coefficients(const ContactPoint& p) const {
        const Vec3& g = p.gradient;
        const double inverse_mass =
            law_.damping_mass == ContactLaw::DampingMass::contact
                ? inverse_contact_mass(pair_, g, p.position.cross(g),
                                       (p.position - pair_.displacement).cross(g))
                : inverse_reduced_mass(pair_);
        return hertz::coefficients(law_, radius_, p.overlap, inverse_mass,
                                   hertz::tangential_inertia(pair_));
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
struct PatchCall {
    std::span<const ContactPoint> points;
    const PairState& pair;
    const ContactLaw& law;
    double dt;
    PatchHistory& history;
    double radius, local_radius;
};

/// The elastic parts of the forces of some points, and where they act.
struct Load {
    double force = 0.0;          ///< [N]
    Vec3 moment = Vec3::Zero();  ///< of places relative to the centre of i [N m]

    void add(double elastic_part, const Vec3& place) {
        force += elastic_part;
        moment += elastic_part * place;
    }
};

/// How the points in slots stand for all.
struct StandIn {
    double scale = 1.0;         ///< of their friction
    Vec3 shift = Vec3::Zero();  ///< from where they carry the load to where all do [m]
};

template <class Patch>
StandIn stand_in(const Patch& patch, const PatchCall& call, const PatchSlots& chosen,
                 const Load& load) {
    if (chosen.count == call.points.size()) return {};
    Load held;
    for (std::size_t k = 0; k < chosen.count; ++k) {
        const ContactPoint& p = call.points[chosen.point[k]];
        held.add(patch.share(p, call.dt).elastic_part, p.position);
    }
    if (!(held.force > 0.0)) return {};
    return {load.force / held.force, load.moment / load.force - held.moment / held.force};
}

/// Adds the friction of the points in slots.
template <class Patch>
void add_friction(const Patch& patch, const PatchCall& call, const Load& load,
                  PairContact& contact) {
    const PatchSlots chosen = choose_slots(call.points, call.history);
    const auto [scale, shift] = stand_in(patch, call, chosen, load);
    const double dt = call.dt;
    const Vec3 mean_spin = 0.5 * (call.pair.i.angular_velocity + call.pair.j.angular_velocity);
    for (std::size_t k = 0; k < chosen.count; ++k) {
        const ContactPoint& p = call.points[chosen.point[k]];
        const Vec3 place = p.position + shift;
        const Share s = patch.share(p, dt);
        const Vec3 n = p.gradient.normalized();
        PatchHistory::Slot& slot = call.history.slots[k];
        Vec3 spring = Vec3::Zero();
        if (chosen.known[k])
            spring = hertz::carried(slot.spring, slot.normal, n, mean_spin.dot(n) * dt);
        const Vec3 velocity =
            place == p.position ? s.velocity : relative_velocity(call.pair, place);
        const Vec3 u_t = velocity - velocity.dot(n) * n;
        const double k_t = scale * s.k_t;
        contact.dissipated_energy += hertz::restiffen(
            slot.stiffness, k_t, call.history.dissipated + contact.dissipated_energy, spring);
        const double limit =
            call.law.friction * scale * hertz::friction_load(call.law, s.elastic_part, s.force);
        const hertz::TangentialForce t =
            hertz::tangential_force(k_t, scale * s.gamma_t, limit, u_t, dt, spring);
        slot = {p.feature, n, spring, k_t};
        add_force(contact, t.force, place, call.pair);
        contact.elastic_energy += t.elastic;
        contact.dissipated_energy += t.dissipated;
    }
    call.history.used = chosen.count;
}

template <class Patch>
PairContact patch_force(const PatchCall& call) {
    const Patch patch(call.points, call.pair, call.law, call.radius);
    PairContact contact;
    Load load;
    for (const ContactPoint& p : call.points) {
        const Share s = patch.share(p, call.dt);
        add_force(contact, s.force * p.gradient, p.position, call.pair);
        load.add(s.elastic_part, p.position);
        contact.elastic_energy += s.elastic;
        contact.dissipated_energy += s.dissipated;
    }
    contact.elastic_energy += patch.elastic();
    const double normal_elastic = contact.elastic_energy;
    if (call.law.friction > 0.0) add_friction(patch, call, load, contact);
    contact.overlap = patch.overlap();
    contact.points = static_cast<std::uint32_t>(call.points.size());
    call.history.dissipated += contact.dissipated_energy;
    contact.dissipated_energy +=
        hertz::age(call.law, call.local_radius, call.radius, patch.frequency() * call.dt,
                   normal_elastic, call.history);
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
    PatchHistory::Slot& slot = history.slots[0];
    PointHistory single{slot.normal,   slot.spring,    history.effective_radius,
                        history.phase, slot.stiffness, history.dissipated};
    PairContact contact = contact_force(point, local_radius, pair, law, dt, single);
    slot = {point.feature, single.normal, single.spring, single.stiffness};
    history.effective_radius = single.effective_radius;
    history.phase = single.phase;
    history.dissipated = single.dissipated;
    history.used = 1;
    return contact;
}

}  // namespace

PairContact contact_force(std::span<const ContactPoint> points, double local_radius,
                          const PairState& pair, const ContactLaw& law, double dt,
                          PatchHistory& history) {
    if (points.empty()) {
        if (history.effective_radius > 0.0) history = {};
        return {};
    }
    if (is_single(points, history))
        return single_force(points[0], local_radius, pair, law, dt, history);
    PatchCall call{points, pair, law, dt, history, 0.0, local_radius};
    call.radius = hertz::effective_radius(law, local_radius, history);
    if (law.multi_contact == ContactLaw::MultiContact::sum) return patch_force<SumPatch>(call);
    if (law.multi_contact == ContactLaw::MultiContact::norm) return patch_force<NormPatch>(call);
    ContactPoint deepest = points.front();
    for (const ContactPoint& p : points)
        if (p.overlap > deepest.overlap) deepest = p;
    deepest.feature = 0;  // one spring, whichever point is deepest
    call.points = std::span(&deepest, 1);
    return patch_force<NormPatch>(call);
}

}  // namespace dem
