// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/features.hpp"
#include "runtime/contact/pairs/pair_table.hpp"

#include <functional>

/// Contacts of two shapes of any kind as functions of one form, so that a test can ask the same of
/// all kinds.
namespace dem::test {

using namespace runtime;

/// A contact with all that it remembers; a copy has a memory of its own.
using Contact = std::function<PairContact(const PairState&, double dt)>;

/// What a host keeps for one pair.
template <class History, class Cache>
struct Host {
    History history{};
    Cache cache{};
    ContactScratch points = ContactScratch(20'000);
    ConvexScratch features{};
    double travel = 0.0;

    /// No point of a body moves farther than this in a step of a test [m].
    static constexpr double longest_way = 1e-4;

    Call<History, Cache> call(const PairState& pair, const ContactLaw& law, double dt) {
        travel += longest_way;
        return {pair, law, dt, {history, cache}, travel, {&points, &features}};
    }
};

/// A contact of two shapes that a host remembers.
template <class Host, class A, class B>
Contact contact_of(const A& a, const B& b, const ContactLaw& law) {
    return [=, host = Host{}](const PairState& pair, double dt) mutable {
        return collide(a, b, host.call(pair, law, dt));
    };
}

/// Spheres and walls.
template <class A, class B>
Contact by_sphere(const A& a, const B& b, const ContactLaw& law) {
    return contact_of<Host<PointHistory, NoCache>>(a, b, law);
}
/// Convex surfaces of revolution.
template <class A, class B>
Contact by_support(const A& a, const B& b, const ContactLaw& law) {
    return contact_of<Host<PointHistory, MissCache>>(a, b, law);
}
/// Nodes, and spheres of clumps.
template <class A, class B>
Contact by_points(const A& a, const B& b, const ContactLaw& law) {
    return contact_of<Host<PatchHistory, NearCache>>(a, b, law);
}
/// Convex shapes.
template <class A, class B>
Contact by_cores(const A& a, const B& b, const ContactLaw& law) {
    return contact_of<Host<ConvexHistory, MissCache>>(a, b, law);
}

}  // namespace dem::test
