// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstdint>
#include <type_traits>

/// The kernel contract: what goes into and comes out of every contact kernel of `dem_contact`.
/// A kernel is a pure function
///
///     PairContact collide(const ShapeA& a, const ShapeB& b, const PairState& pair,
///                         const ContactLaw& law, double dt, Memory memory)
///
/// in which `memory` is what the pair remembers: its history, by reference, with a cache where the
/// search has one (ContactMemory, NodeMemory). i (shape a) is the particle with the lower id, or
/// the particle when b is a wall. All vectors are in the world frame; points are relative to the
/// centre of mass of i. The host owns the history and the cache, calls in any order on any thread
/// or process, and gets the same bits.
namespace dem {

/// Inertia of a rigid body as a contact needs it. All zero: a fixed body or a wall.
struct InverseInertia {
    double mass = 0.0;            ///< 1/m [1/kg]
    Vec3 moments = Vec3::Zero();  ///< 1/I about the body's principal axes [1/(kg m^2)]
    /// Mean squared distance of the surface over the mean moment of inertia, [GC] Eq. 13 [1/kg].
    double surface = 0.0;
};

/// Motion of one body. For a wall: of its reference point.
struct BodyState {
    Quat orientation = Quat::Identity();   ///< body -> world
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< world frame [rad/s]
    InverseInertia inverse_inertia;
};

struct PairState {
    Vec3 displacement;  ///< from the centre of i to the centre of j [m]; periodic image resolved
    BodyState i, j;
};

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

    Model model = Model::hertz;
    Method method = Method::automatic;
    Tangential tangential = Tangential::mindlin;
    DampingMass damping_mass = DampingMass::contact;
    MultiContact multi_contact = MultiContact::norm;
    Radius radius = Radius::onset;
    NodeNormal node_normal = NodeNormal::gradient;
    bool limit_force = false;  ///< cut the normal force at zero

    double youngs_modulus = 0.0;  ///< Y* [Pa], [SR] Eq. 13
    double shear_modulus = 0.0;   ///< G* [Pa], [SR] Eq. 13
    /// Of the normal dashpot over sqrt(k_n m_e): sqrt(5) |beta| ([SR] Eq. 12-13), for `linear`
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
};

/// What a contact does to its two bodies in this step. The force on j is exactly -force.
struct PairContact {
    Vec3 force = Vec3::Zero();       ///< on i [N]
    Vec3 torque_i = Vec3::Zero();    ///< on i about its centre of mass [N m]
    Vec3 torque_j = Vec3::Zero();    ///< on j about its centre of mass [N m]
    double overlap = 0.0;            ///< generalised overlap [m]; > 0 while touching
    double elastic_energy = 0.0;     ///< stored in normal and tangential springs [J]
    double dissipated_energy = 0.0;  ///< by dashpots and slip during this step [J]
    std::uint32_t points = 0;        ///< contact points; 0: the bodies do not touch
    bool cores_met = false;          ///< two convex cores overlap for the first time

    bool touches() const { return points != 0; }
};

/// History of a pair that touches in one point. All zero: no contact.
struct PointHistory {
    StoredVec3 normal;  ///< last unit normal, from j towards i
    StoredVec3 spring;  ///< tangential spring, half a step ahead [m], normal to `normal`
    double effective_radius = 0.0;  ///< R* frozen at the onset of the contact [m]
    double phase = 0.0;      ///< age in radians of its own oscillation; counts in laps once settled
    double stiffness = 0.0;  ///< k_t of the step before [N/m]
    double dissipated = 0.0;  ///< by the contact so far; a stiffness that grows gives no more [J]
};
static_assert(std::is_trivially_copyable_v<PointHistory>);

/// Lower bound of the gap of a pair that does not touch, found on the way. It may prove a miss
/// later (the host compares it with how far the bodies have moved) and never changes a contact.
struct MissCache {
    StoredVec3 axis;   ///< unit separating direction, from i to j; zero: none known
    double gap = 0.0;  ///< proven distance when the kernel last ran [m]; <= 0: unknown
};

/// What the host owns for a pair of smooth bodies.
template <class History>
struct ContactMemory {
    History& history;
    MissCache& miss;
};
template <class History>
ContactMemory(History&, MissCache&) -> ContactMemory<History>;

}  // namespace dem
