// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/lanes.hpp"
#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/contact/law/whole_contact.hpp"

#include <array>

/// The kernel contract (contact_types.hpp) with a pair in each lane, and how lanes are filled.
namespace dem::runtime {

template <class Real>
struct LaneInertia {
    Real mass;
    Vec3Of<Real> moments;
    Real surface;
};

template <class Real>
struct LaneBody {
    Vec3Of<Real> axis;
    Vec3Of<Real> velocity, angular_velocity;
    LaneInertia<Real> inverse_inertia;
};

/// PairContact in each lane.
template <class Real>
struct LanePairContact {
    Vec3Of<Real> force, torque_i, torque_j;
    Real overlap, elastic_energy, dissipated_energy;
    int points;
    Vec3Of<Real> place, normal, friction;
    Real friction_limit, normal_force;
};

/// PairState in each lane.
template <class RealType>
struct LanePair {
    using Real = RealType;
    using Contact = LanePairContact<Real>;
    Vec3Of<Real> displacement;
    LaneBody<Real> i, j;
};

/// What a contact of one point remembers, in each lane.
template <class Real>
struct LaneHistory {
    Vec3Of<Real> normal;
    Real effective_radius, phase, dissipated;
    Vec3Of<Real> spring;
    Real stiffness;

    MaskOf<Real> touched() const { return effective_radius > 0.0; }
};

/// ContactLaw in each lane; what is chosen for a whole run is the same in all.
template <class Real>
struct LaneLaw {
    ContactLaw::Geometry geometry;
    ContactLaw::Model model;
    ContactLaw::Tangential tangential;
    ContactLaw::DampingMass damping_mass;
    bool limit_force;
    Real youngs_modulus, shear_modulus;
    Real damping, friction, stiffness_ratio, damping_ratio;
    Real normal_stiffness, tangential_stiffness, tangential_damping;
};

/// Lanes have none of the parts that act once per contact (runs_in_lanes()).
template <class Real, class Pair>
Vec3Of<Real> moment_of_parts(const LaneLaw<Real>& /*law*/, const WholeContactOf<Pair>& /*contact*/,
                             LaneHistory<Real>& /*history*/, ContactEnergyOf<Real>& /*energy*/) {
    return Vec3Of<Real>::Zero();
}

/// The contacts of all lanes: as many as there are lanes, the last one again where there are fewer.
template <class Real>
using LaneGroup = std::array<const LaneContact*, static_cast<std::size_t>(width_of<Real>)>;

}  // namespace dem::runtime
