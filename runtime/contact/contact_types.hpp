// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstdint>
#include <vector>

/// The kernel contract: what goes into and comes out of every contact kernel of `dem_contact`.
/// A kernel is a pure function
///
///     PairContact collide(const ShapeA& a, const ShapeB& b, const Call<History, Cache>& call)
///
/// of two shapes, written once for each row of the table of pairs (pairs/pair_table.hpp). i has
/// shape a; a wall is always j. All vectors are in the world frame; points are relative to the
/// center of mass of i. The host owns what a pair remembers, calls in any order on any thread or
/// process, and gets the same bits.
namespace dem::runtime {

/// Force law of one pair of materials (law/contact_law.hpp).
struct ContactLaw;

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
    Vec3 velocity = Vec3::Zero();          ///< of the center of mass [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< world frame [rad/s]
    InverseInertia inverse_inertia;
};

struct PairContact;

struct PairState {
    using Real = double;
    using Contact = PairContact;
    Vec3 displacement;  ///< from the center of i to the center of j [m]; periodic image resolved
    BodyState i, j;
};

/// What a contact does to its two bodies in this step. The force on j is exactly -force.
struct PairContact {
    Vec3 force = Vec3::Zero();       ///< on i [N]
    Vec3 torque_i = Vec3::Zero();    ///< on i about its center of mass [N m]
    Vec3 torque_j = Vec3::Zero();    ///< on j about its center of mass [N m]
    double overlap = 0.0;            ///< generalized overlap [m]; > 0 while touching
    double elastic_energy = 0.0;     ///< stored in normal and tangential springs [J]
    double dissipated_energy = 0.0;  ///< in this step, also of a contact that ends in it [J]
    std::uint32_t points = 0;        ///< contact points; 0: the bodies do not touch
    bool cores_met = false;          ///< two convex cores overlap for the first time

    // How the force is made up, for who looks at contacts; no step needs it.
    Vec3 place = Vec3::Zero();     ///< where the load acts, relative to the center of i [m]
    Vec3 normal = Vec3::Zero();    ///< unit, from j towards i
    Vec3 friction = Vec3::Zero();  ///< part of the force that friction is, on i [N]
    double friction_limit = 0.0;   ///< at which friction slips [N]
    double normal_force = 0.0;     ///< sizes of the forces along the normals of the points [N]

    bool touches() const { return points != 0; }
};

/// Lower bound of the gap of a pair that does not touch, found on the way. It may prove a miss
/// later (the host compares it with how far the bodies have moved) and never changes a contact.
struct MissCache {
    StoredVec3 axis;   ///< unit separating direction, from i to j; zero: none known
    double gap = 0.0;  ///< proven distance when the kernel last ran [m]; <= 0: unknown
};

/// For kernels that prove no gap.
struct NoCache {};

/// What a pair remembers, owned by the host: its history, which the next step needs, and what may
/// be dropped at any time and spares work.
template <class HistoryType, class CacheType>
struct Memory {
    HistoryType& history;
    CacheType& cache;
};
template <class History, class Cache>
Memory(History&, Cache&) -> Memory<History, Cache>;

struct ContactPoint;
struct ConvexScratch;

/// Room that kernels work in, owned by the host, one per thread: kernels allocate nothing.
struct Scratch {
    /// For kernels with many points; as large as the largest number of nodes of any shape and as
    /// contact_room() of any clump.
    std::vector<ContactPoint>* points = nullptr;
    ConvexScratch* features = nullptr;  ///< of kernels of convex shapes
    /// Takes the contacts of a pair that touches in several, for who looks at them one by one.
    std::vector<PairContact>* several = nullptr;
};

/// What a kernel is called with, besides the two shapes.
template <class History, class Cache>
struct Call {
    const PairState& pair;
    const ContactLaw& law;
    double dt;  ///< of the step that led here [s]
    Memory<History, Cache> memory;
    /// A bound on the path walked by any point of either body, one added to the other, since some
    /// fixed time [m]: it never falls, and no point of one body has come nearer to a point of the
    /// other by more than its increase.
    double travel = 0.0;
    Scratch scratch = {};
};
template <class History, class Cache>
Call(const PairState&, const ContactLaw&, double, Memory<History, Cache>, double = 0.0,
     Scratch = {}) -> Call<History, Cache>;

/// Ends a contact, if there was one: what its springs still hold is lost.
template <class History>
PairContact parting(History& history) {
    PairContact contact;
    if (!history.touched()) return contact;
    contact.dissipated_energy = held_energy(history);
    history = {};
    return contact;
}

/// What a kernel returns for bodies that are apart: the history forgets the contact.
template <class History>
PairContact apart(const Call<History, NoCache>& call) {
    return parting(call.memory.history);
}
/// What it returns where a gap is proven [m], along `axis` from i to j if there is one: the cache
/// keeps both.
template <class History>
PairContact apart(const Call<History, MissCache>& call, double gap,
                  const Vec3& axis = Vec3::Zero()) {
    call.memory.cache = {axis, gap};
    return parting(call.memory.history);
}

}  // namespace dem::runtime
