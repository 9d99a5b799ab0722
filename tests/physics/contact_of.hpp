// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/pairs/clump_clump.hpp"
#include "runtime/contact/pairs/clump_wall.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/pairs/convex_wall.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"

#include <functional>

/// Contacts of two shapes of any kind as functions of one form, so that a test can ask the same of
/// all kinds.
namespace dem::test {

/// A contact with all that it remembers; a copy has a memory of its own.
using Contact = std::function<PairContact(const PairState&, double dt)>;

struct SmoothHost {
    PointHistory history{};
    MissCache miss{};
};

struct PointsHost {
    PatchHistory history{};
    NodeCache cache{};
    ContactScratch scratch = ContactScratch(20'000);
    double travel = 0.0;

    /// As if some point had moved by `way` since the step before [m].
    NodeMemory memory(double way) {
        travel += way;
        return {history, cache, scratch, travel};
    }
};
/// No point of a body moves farther than this in a step of a test [m].
inline constexpr double longest_way = 1e-4;

struct ConvexHost {
    ConvexHistory history{};
    MissCache miss{};
    ConvexScratch scratch{};

    ConvexMemory memory() { return {history, miss, scratch}; }
};

/// A contact of two shapes that takes its memory from a host.
template <class A, class B, class Host, class Remember>
Contact contact_of(const A& a, const B& b, const ContactLaw& law, Host host, Remember remember) {
    return [=](const PairState& pair, double dt) mutable {
        return collide(a, b, pair, law, dt, remember(host));
    };
}

/// Spheres and walls.
template <class A, class B>
Contact by_sphere(const A& a, const B& b, const ContactLaw& law) {
    return contact_of(a, b, law, PointHistory{},
                      [](PointHistory& h) -> PointHistory& { return h; });
}
/// Convex surfaces of revolution.
template <class A, class B>
Contact by_support(const A& a, const B& b, const ContactLaw& law) {
    return contact_of(a, b, law, SmoothHost{}, [](SmoothHost& h) {
        return ContactMemory{h.history, h.miss};
    });
}
/// Nodes, and spheres of clumps.
template <class A, class B>
Contact by_points(const A& a, const B& b, const ContactLaw& law) {
    return contact_of(a, b, law, PointsHost{}, [](PointsHost& h) { return h.memory(longest_way); });
}
/// Convex shapes.
template <class A, class B>
Contact by_cores(const A& a, const B& b, const ContactLaw& law) {
    return contact_of(a, b, law, ConvexHost{}, [](ConvexHost& h) { return h.memory(); });
}

}  // namespace dem::test
