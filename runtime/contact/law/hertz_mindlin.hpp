// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

#include <algorithm>
#include <cmath>

/// The parts of the Hertz-Mindlin law [SR] Eqs. 10-15, and of the linear one beside it, that one
/// contact point and many share (docs/contact.md, "Force law").
///   k_n = 4/3 Y* sqrt(R* d), gamma_n = sqrt(5) |beta| sqrt(m_e k_n), F_n = k_n d - gamma_n u_n
///   F_t = -k_t s - gamma_t u_t, |F_t| <= mu k_n d, the elastic part of F_n
/// d overlap, s tangential spring, u relative velocity, m_e effective mass of the contact.
namespace dem::hertz {

/// How long an elastic collision of two Hertzian bodies lasts, in radians of its own oscillation:
/// the integral of sqrt(k_n/m_e) dt is 2 pi / sqrt(5) at any speed, mass and stiffness.
inline constexpr double collision_phase = 2.8099258924162904;

/// A contact older than this is not a collision any more: its R* starts to follow the geometry.
inline constexpr double settled_phase = 4.0 * collision_phase;

/// Time constant of that drift: slow against the contact's own oscillation, so that what the change
/// of stiffness adds or takes in a cycle stays below what it would in a bounce by that factor.
inline constexpr double drift_phase = 20.0 * collision_phase;

/// The drift goes in small jumps, one each time the contact has aged by this many radians: R* of
/// the place is needed then and only then.
inline constexpr double drift_interval = 0.25;

/// Whether the law asks for R* at the present place, or for none because the frozen one serves.
template <class History>
bool needs_local_radius(const ContactLaw& law, const History& history) {
    return law.radius == ContactLaw::Radius::local || history.effective_radius == 0.0 ||
           (law.radius == ContactLaw::Radius::onset &&
            history.phase >= settled_phase + drift_interval);
}

/// R* of this step [m].
template <class History>
double effective_radius(const ContactLaw& law, double local_radius, const History& history) {
    const bool keeps = law.radius != ContactLaw::Radius::local && history.effective_radius > 0.0;
    return keeps ? history.effective_radius : local_radius;
}

/// What resists a tangential motion of a pair at its surfaces, [GC] Sec. 6.
struct TangentialInertia {
    double inverse_reduced = 0.0;  ///< 1/mu of the two masses [1/kg]
    double inverse = 0.0;  ///< B: 1/mu and the mean squared surface distances over moments [1/kg]
};
inline TangentialInertia tangential_inertia(const PairState& pair) {
    const InverseInertia& i = pair.i.inverse_inertia;
    const InverseInertia& j = pair.j.inverse_inertia;
    const double reduced = i.mass + j.mass;
    return {reduced, reduced + i.surface + j.surface};
}

/// Energy of a spring over force times overlap.
inline double elastic_share(const ContactLaw& law) {
    return law.model == ContactLaw::Model::linear ? 0.5 : 0.4;
}

struct Coefficients {
    double k_n;      ///< [N/m]
    double gamma_n;  ///< [kg/s]
    double k_t, gamma_t;
    double frequency;  ///< sqrt(k_n/m_e) [rad/s]
};

/// Linear spring-dashpot [GC] Eqs. 13-16, corrected: k_t = k_n (1/mu)/B (pi^2 + ln^2 e_t)/(pi^2 +
/// ln^2 e_n), gamma_t = -(2/t_c) ln e_t / B.
inline Coefficients linear_coefficients(const ContactLaw& law, double inverse_mass,
                                        const TangentialInertia& tangential) {
    Coefficients c{};
    c.k_n = law.normal_stiffness;
    c.frequency = std::sqrt(c.k_n * inverse_mass);
    c.gamma_n = inverse_mass > 0.0 ? law.damping * c.frequency / inverse_mass : 0.0;
    if (!(tangential.inverse > 0.0)) return c;
    c.k_t = c.k_n * law.tangential_stiffness * tangential.inverse_reduced / tangential.inverse;
    c.gamma_t =
        law.tangential_damping * std::sqrt(c.k_n * tangential.inverse_reduced) / tangential.inverse;
    return c;
}

/// `inverse_mass` = 1/m_e [1/kg].
inline Coefficients coefficients(const ContactLaw& law, double radius, double overlap,
                                 double inverse_mass, const TangentialInertia& tangential) {
    if (law.model == ContactLaw::Model::linear)
        return linear_coefficients(law, inverse_mass, tangential);
    const double root = std::sqrt(radius * overlap);
    Coefficients c{};
    c.k_n = 4.0 / 3.0 * law.youngs_modulus * root;
    c.frequency = std::sqrt(c.k_n * inverse_mass);
    const double mass = inverse_mass > 0.0 ? 1.0 / inverse_mass : 0.0;
    c.gamma_n = law.damping * c.frequency * mass;
    c.k_t = law.tangential == ContactLaw::Tangential::mindlin ? 8.0 * law.shear_modulus * root
                                                              : law.stiffness_ratio * c.k_n;
    c.gamma_t = law.damping_ratio * c.gamma_n;
    return c;
}

/// How long the normal dashpot acts in this step, in steps. A linear one sets in with its full
/// force at the touch and stops at the parting: where one of them is less than a step away it acts
/// from half a step before to half a step after now, but not beyond. Without this a restitution of
/// 0.3 is off by up to 0.01 at t_c/50. Hertz's dashpot sets in from zero.
inline double dashpot_share(const ContactLaw& law, const Coefficients& c, double overlap,
                            double rate, double dt) {
    if (law.model != ContactLaw::Model::linear) return 1.0;
    if (rate > 0.0) return overlap < rate * dt ? 0.5 + overlap / (rate * dt) : 1.0;
    // Until the next step the bodies part at the rate that this step's forces leave. A longer pull
    // must not keep them together for a step that it has counted already.
    const double push = -rate + 0.5 * dt * square(c.frequency) * overlap;
    const double pull = -0.5 * dt * c.frequency * law.damping * rate;
    const double path = (push - pull) * dt;
    if (!(overlap < path && pull > 0.0)) return 1.0;
    return std::min(0.5 + overlap / path, 0.5 + 0.5 * (push - overlap / dt) / pull);
}

/// Lets R* drift, ages the contact by `turn` [rad] and returns what the change of R* took away of
/// the energy `elastic` of the normal spring [J], which goes with sqrt(R*). What it takes from the
/// tangential spring, restiffen() finds in the next step. `history.dissipated`, up to date, bounds
/// what the drift gives or takes: bodies that dissipate nothing neither gain nor lose by it.
template <class History>
double age(const ContactLaw& law, double local_radius, double radius, double turn, double elastic,
           History& history) {
    double loss = 0.0;
    if (law.model == ContactLaw::Model::linear) {
        // The stiffness knows no radius.
    } else if (law.radius == ContactLaw::Radius::local) {
        if (history.effective_radius > 0.0)
            loss = 0.5 * (history.effective_radius / radius - 1.0) * elastic;
    } else if (law.radius == ContactLaw::Radius::onset &&
               history.phase >= settled_phase + drift_interval) {
        const double drifted = radius + (local_radius - radius) * (drift_interval / drift_phase);
        const double most = std::max(history.dissipated, 0.0) / elastic;
        const double root = std::clamp(std::sqrt(drifted / radius), 1.0 - most, 1.0 + most);
        radius *= square(root);
        loss = (1.0 - root) * elastic;
        history.phase -= drift_interval;
    }
    history.effective_radius = radius;
    history.phase += turn;
    history.dissipated += loss;
    return loss;
}

/// Carries a spring in the plane of `old_normal` into the plane of `normal`: the smallest rotation
/// between the two, then `spin` [rad] about the new one. Both keep its length.
inline Vec3 carried(const Vec3& spring, const Vec3& old_normal, const Vec3& normal, double spin) {
    const double cosine = old_normal.dot(normal);
    // A normal that turned round within a step is another contact.
    if (cosine < -0.9) return Vec3::Zero();
    const Vec3 s = spring - (old_normal + normal) * (normal.dot(spring) / (1.0 + cosine));
    const double t = 0.5 * spin;  // rotation by 2 atan(t), Cayley
    const double scale = 1.0 / (1.0 + t * t);
    return ((1.0 - t * t) * scale) * s + (2.0 * t * scale) * normal.cross(s);
}

/// The normal force of which friction may be the share mu [N]: the elastic part of it. The dashpot
/// gives no impulse over a whole contact, but it pulls at its end; friction cut at the size of the
/// damped force would go on there, and sliding impacts would exceed Coulomb. Where the damped force
/// is itself cut at zero it serves: what the dashpot then gives does not vanish.
inline double friction_load(const ContactLaw& law, double elastic_part, double force) {
    return law.limit_force ? force : elastic_part;
}

struct TangentialForce {
    Vec3 force;         ///< on i [N]
    double elastic;     ///< [J]
    double dissipated;  ///< in this step [J]
};

/// Spring and dashpot cut at `limit` = mu friction_load(). The force of this step uses the spring
/// at its end, integrated by the trapezoidal rule (second order): `lead`, what the history stores,
/// is ahead of it by u_t dt/2. When slipping the spring is reset so that the law gives the slip
/// force exactly. Where the dashpot alone exceeds the limit the spring is empty: stretched against
/// the motion, as the rule would have it, it would push forward as soon as the stiffness grows, and
/// with k_t -> 0 at the onset of a Hertzian contact the impact would depend on the time step
/// without limit. The slip force keeps the direction of the force it replaces: along -u_t in steady
/// slip, along the spring when the limit falls below it while the contact springs back. Slip takes
/// the force of the cut spring, averaged over the step, along the way that was cut off: the
/// spring's own loss of energy counts the whole way at the stretched length and is more by half of
/// k_t u_t dt times that way, an error of first order in dt.
inline TangentialForce tangential_force(double k_t, double gamma_t, double limit, const Vec3& u_t,
                                        double dt, Vec3& lead) {
    const Vec3 half_way = 0.5 * dt * u_t;
    Vec3 spring = lead + half_way;
    Vec3 force = -k_t * spring - gamma_t * u_t;
    const double before = 0.5 * k_t * spring.squaredNorm();
    double elastic = before;
    double slip = 0.0;
    const double size2 = force.squaredNorm();
    if (size2 > limit * limit) {
        force *= limit / std::sqrt(size2);
        const Vec3 spring_force = force + gamma_t * u_t;
        spring = spring_force.dot(force) > 0.0 ? Vec3(spring_force / -k_t) : Vec3::Zero();
        elastic = 0.5 * k_t * spring.squaredNorm();
        slip = before - elastic - k_t * half_way.dot(lead + half_way - spring);
    }
    lead = spring + half_way;
    const double dashpot = -(force + k_t * spring).dot(u_t) * dt;
    return {force, elastic, dashpot + slip};
}

/// From this coefficient of friction on, contacts of convex shapes under the linear law give back
/// what their tangential spring holds when they end (docs/contact.md, "Without slip").
inline constexpr double no_slip = 2.0;

inline bool gives_back(const ContactLaw& law) {
    return law.model == ContactLaw::Model::linear && law.friction > no_slip;
}

struct LettingGo {
    double force;   ///< of the spring, against it [N]
    double push;    ///< along the normal, repulsive [N]
    double energy;  ///< [J]
};

/// A spring of stiffness k_t and length s that is longer than `ratio` overlaps d: with h = ratio d
///     U = k_t (h^2 - h^4 / (2 s^2)),    force dU/ds, push dU/dd,
/// which goes on from k_t s^2 / 2 at s = h without a kink and vanishes with the overlap.
inline LettingGo letting_go(double k_t, double s, double ratio, double overlap) {
    const double h = ratio * overlap;
    const double r2 = square(h / s);
    return {k_t * h * r2 * h / s, 2.0 * k_t * h * ratio * (1.0 - r2),
            k_t * square(h) * (1.0 - 0.5 * r2)};
}

/// Gives a spring its stiffness k_t of this step, which was `before` in the last, and returns the
/// energy that it loses [J]. `lead`, from the history: the spring half way between the two steps,
/// where the change of stiffness at constant length and that of length at constant stiffness
/// separate. The length stays, so that a spring that stiffens gains; where that were more than
/// `dissipated`, what the contact has taken before [J], the force stays instead, as it does in the
/// theory of elastic contacts under rising load, and the spring becomes shorter.
inline double restiffen(double before, double k_t, double dissipated, Vec3& lead) {
    const double size2 = lead.squaredNorm();
    const double loss = 0.5 * (before - k_t) * size2;
    if (-loss <= std::max(dissipated, 0.0)) return loss;
    const double kept = before / k_t;
    lead *= kept;
    return 0.5 * before * (1.0 - kept) * size2;
}

}  // namespace dem::hertz
