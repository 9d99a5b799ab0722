// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/features.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/pairs/convex_sr.hpp"
#include "runtime/contact/pairs/convex_wall.hpp"
#include "tests/runtime/contact/cores/convex_poses.hpp"
#include "tests/support/sample_convex.hpp"

#include <algorithm>

/// Contacts of convex shapes for tests: what a host keeps for one pair, and how far a force is from
/// the derivative of its energy.
namespace dem::test {

using namespace runtime;

struct Host {
    ConvexHistory history{};
    MissCache miss{};
    ConvexScratch scratch{};

    CoreCall call(const PairState& pair, const ContactLaw& law, double dt) {
        return {pair, law, dt, {history, miss}, 0.0, {nullptr, &scratch}};
    }
};

inline const ContactLaw elastic = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);

/// A contact of bodies at rest that has lasted: R* does not change.
template <class A, class B>
PairContact resting_contact(const A& a, const B& b, const PairState& pair) {
    Host host;
    host.history.effective_radius = 0.25;
    const double distance = pair.displacement.norm();
    host.history.search.direction = Vec3(pair.displacement / -distance);
    return collide(a, b, host.call(pair, elastic, 1e-6));
}

/// Largest deviation of force and torques from the derivatives of the stored energy, relative to
/// the force.
template <class Evaluate>
double gradient_error(const PairState& pair, const Evaluate& evaluate) {
    const PairContact at = evaluate(pair);
    const double h = 1e-7;
    double error = 0.0;
    for (int k = 0; k < 9; ++k) {
        const Vec3 axis = Vec3::Unit(k % 3);
        const auto moved = [&](double s) {
            PairState p = pair;
            if (k < 3) {
                p.displacement -= s * axis;
            } else if (k < 6) {
                p.i.orientation = turned(axis, s) * pair.i.orientation;
            } else {
                p.j.orientation = turned(axis, s) * pair.j.orientation;
            }
            return evaluate(p).elastic_energy;
        };
        const double expected = -(moved(h) - moved(-h)) / (2.0 * h);
        const Vec3& found = k < 3 ? at.force : k < 6 ? at.torque_i : at.torque_j;
        error = std::max(error, std::abs(found.dot(axis) - expected) / at.force.norm());
    }
    return error;
}

}  // namespace dem::test
