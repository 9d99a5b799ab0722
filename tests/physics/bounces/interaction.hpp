// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/pairs/pair_table.hpp"

#include <memory>

namespace dem::test {

using namespace runtime;

/// The kernel that the time loop takes for two shapes, with what a host keeps for one pair.
class Interaction {
  public:
    virtual ~Interaction() = default;
    /// `travel`: bound of the way of any point of both bodies so far [m].
    virtual PairContact collide(const PairState& pair, const ContactLaw& law, double dt,
                                double travel) = 0;
    /// How far the bodies can come nearer before they touch, after collide() found them apart; 0
    /// where that is not known [m].
    virtual double gap(double travel) const = 0;
};

std::unique_ptr<Interaction> interaction(const ParticleTemplate& a, const ParticleTemplate& b,
                                         const ContactLaw& law);
std::unique_ptr<Interaction> interaction(const ParticleTemplate& a, const WallShape& b,
                                         const ContactLaw& law);

}  // namespace dem::test
