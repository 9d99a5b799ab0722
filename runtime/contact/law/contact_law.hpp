// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/rolling.hpp"
#include "runtime/contact/law/slipping_spring.hpp"
#include "runtime/contact/law/whole_contact.hpp"

#include <cstdint>
#include <type_traits>

/// What a pair of materials says about its contacts, what a contact remembers, and the parts that
/// the law consists of (docs/contact.md, "Force law").
namespace dem::runtime {

/// Force law of one pair of materials, with everything that does not change during a run derived.
struct ContactLaw {
    enum class Model : std::uint8_t { hertz, linear };
    enum class Method : std::uint8_t { automatic, continuous, nodes, centroid };
    enum class Tangential : std::uint8_t { ratio, mindlin };
    enum class DampingMass : std::uint8_t { contact, reduced };
    enum class MultiContact : std::uint8_t { norm, sum, deepest };
    enum class Radius : std::uint8_t { onset, local, equivalent };
    /// Direction of the force at a node (docs/contact-nodes.md): gradient of the interpolant, the
    /// same normalized, interpolated distance vectors, averaged over the contact nodes [SR] Eq. 16.
    enum class NodeNormal : std::uint8_t { gradient, normalized, vectors, averaged };

    /// How the geometry of a contact is looked at, whatever the materials are.
    struct Geometry {
        Method method = Method::automatic;
        MultiContact multi_contact = MultiContact::norm;
        Radius radius = Radius::onset;
        NodeNormal node_normal = NodeNormal::gradient;
    };
    Geometry geometry;

    Model model = Model::hertz;
    Tangential tangential = Tangential::mindlin;
    DampingMass damping_mass = DampingMass::contact;
    bool limit_force = false;  ///< cut the normal force at zero

    double youngs_modulus = 0.0;  ///< Y* [Pa], [SR] Eq. 13
    double shear_modulus = 0.0;   ///< G* [Pa], [SR] Eq. 13
    /// Normal dashpot over sqrt(k_n m_e): sqrt(5) |beta| ([SR] Eq. 12-13), for `linear`
    /// 2 |beta|; beta from the restitution.
    double damping = 0.0;
    double friction = 0.0;               ///< Coulomb mu
    double stiffness_ratio = 2.0 / 7.0;  ///< k_t / k_n
    double damping_ratio = 0.5;          ///< gamma_t / gamma_n

    // model = linear [GC] Sec. 6, instead of moduli and ratios.
    double normal_stiffness = 0.0;      ///< k_n [N/m]
    double contact_time = 0.0;          ///< t_c sqrt(k_n / m) = sqrt(pi^2 + ln^2 e_n)
    double tangential_stiffness = 0.0;  ///< (pi^2 + ln^2 e_t) / (pi^2 + ln^2 e_n)
    double tangential_damping = 0.0;    ///< -2 ln e_t / sqrt(pi^2 + ln^2 e_n)

    // Parts that act once per contact.
    RollingResistance rolling;
};

/// The normal force alone.
inline ContactLaw frictionless(ContactLaw law) {
    law.friction = 0.0;
    law.rolling = {};
    return law;
}

/// What every contact remembers, however its bodies touch. All zero: no contact.
struct ContactHistory {
    StoredVec3 normal;              ///< last unit normal, from j towards i
    double effective_radius = 0.0;  ///< R* frozen at the onset of the contact [m]
    double phase = 0.0;  ///< age in radians of its own oscillation; counts in laps once settled
    double dissipated = 0.0;  ///< by the contact so far; a stiffness that grows gives no more [J]
    RollingHistory rolling;

    bool touched() const { return effective_radius > 0.0; }
};
static_assert(std::is_trivially_copyable_v<ContactHistory>);

/// History of a pair that touches in one point. All zero: no contact.
struct PointHistory : ContactHistory, SpringHistory {};
static_assert(std::is_trivially_copyable_v<PointHistory>);

inline double held_energy(const PointHistory& history) {
    return held_energy(static_cast<const SpringHistory&>(history)) + held_energy(history.rolling);
}

using SphereCall = Call<PointHistory, NoCache>;
using SmoothCall = Call<PointHistory, MissCache>;

/// Moment on i of the parts that act once per contact, in the order of docs/contact.md [N m].
inline Vec3 moment_of_parts(const ContactLaw& law, const WholeContact& contact,
                            ContactHistory& history, ContactEnergy& energy) {
    Vec3 moment = Vec3::Zero();
    if (law.rolling.friction > 0.0)
        moment += rolling_moment(law.rolling, contact, history.rolling, energy);
    return moment;
}

}  // namespace dem::runtime
