// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"
#include "runtime/walls/wall.hpp"
#include "tests/physics/bounces/members.hpp"
#include "tests/physics/two_bodies.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace dem::test {

using namespace runtime;

/// Which bounces to throw.
struct BounceSettings {
    Kind i = Kind::sphere, j = Kind::sphere;  ///< walls second
    ContactLaw::Model model = ContactLaw::Model::hertz;
    std::optional<double> divisor;  ///< of the critical time step; none: the default
};

/// What an elastic, frictionless bounce did to the total energy, kinetic and elastic and booked as
/// dissipated, relative to what the bodies had before the touch in the frame of their center of
/// mass.
struct Bounce {
    std::uint64_t seed = 0;
    bool touched = false;
    bool cores_met = false;  ///< of convex bodies: their rounding was too small for the load
    double overlap = 0.0;    ///< largest, relative to the smaller equivalent radius
    double change = 0.0;     ///< over all of it, absolute
    double jump = 0.0;       ///< the largest within a step that lasted
    double moment = 0.0;     ///< time of the jump since the first touch [s]
    std::uint64_t steps = 0;
};

/// Deeper than this a run stops (docs/contact.md): such bounces do not count.
inline constexpr double deepest_bounce = 0.1;

/// Sees a bounce after every step.
struct BounceView {
    const ParticleTemplate& i;
    const ParticleTemplate& j;  ///< without meaning at a wall
    const std::optional<Wall>& wall;
    const TwoBodies& bodies;
    double dt;      ///< [s]
    double energy;  ///< in total, relative
};
using BounceWatch = std::function<void(const BounceView&)>;

/// Seeded: the same bodies, attitudes, speeds and spins for a seed, whatever the law.
Bounce bounce(const BounceSettings& settings, std::uint64_t seed, const BounceWatch& watch = {});

}  // namespace dem::test
