// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/touch.hpp"

#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/fields/node_contact.hpp"
#include "runtime/contact/pairs/clump_clump.hpp"
#include "runtime/contact/pairs/clump_convex.hpp"
#include "runtime/contact/pairs/clump_sr.hpp"
#include "runtime/contact/pairs/clump_wall.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/pairs/convex_sr.hpp"
#include "runtime/contact/pairs/convex_wall.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"
#include "runtime/contact/smooth/support_sample.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace dem {

namespace {

/// A law without stiffness: only the geometry counts.
const ContactLaw no_force{};

/// Calls the kernel that takes what it remembers of a pair in this form, all of it blank.
template <class A, class B>
bool by_nodes(const A& a, const B& b, const PairState& pair, std::size_t nodes) {
    PatchHistory history;
    NodeCache cache;
    ContactScratch scratch(nodes);
    return collide(a, b, pair, no_force, 0.0, NodeMemory{history, cache, scratch, 0.0}).touches();
}
template <class History, class A, class B>
bool by_support(const A& a, const B& b, const PairState& pair) {
    History history;
    MissCache miss;
    return collide(a, b, pair, no_force, 0.0, ContactMemory{history, miss}).touches();
}
template <class A, class B>
bool in_closed_form(const A& a, const B& b, const PairState& pair) {
    PointHistory history;
    return collide(a, b, pair, no_force, 0.0, history).touches();
}

template <class A, class B>
bool by_cores(const A& a, const B& b, const PairState& pair) {
    ConvexHistory history;
    MissCache miss;
    ConvexScratch scratch;
    return collide(a, b, pair, no_force, 0.0, ConvexMemory{history, miss, scratch}).touches();
}

PairState swapped(const PairState& pair) {
    return {-pair.displacement, pair.j, pair.i};
}

bool touching(const Sphere& a, const Sphere& b, const PairState& pair) {
    return in_closed_form(a, b, pair);
}
bool touching(const Sphere& a, const SrShape& b, const PairState& pair) {
    return b.is_convex ? by_support<PointHistory>(a, b, pair)
                       : by_nodes(a, b, pair, b.nodes.nodes.size());
}
bool touching(const SrShape& a, const Sphere& b, const PairState& pair) {
    return touching(b, a, swapped(pair));
}
bool touching(const SrShape& a, const SrShape& b, const PairState& pair) {
    if (a.is_convex && b.is_convex) return by_support<PointHistory>(a, b, pair);
    // The nodes of one body alone would miss a point of the other that lies between them.
    return by_nodes(a, b, pair, a.nodes.nodes.size()) ||
           by_nodes(b, a, swapped(pair), b.nodes.nodes.size());
}

/// Pairs with a clump, in this order.
std::size_t contact_points(const Clump& a, const SrShape& b) {
    return std::max<std::size_t>(contact_room(a), b.nodes.nodes.size());
}
template <class B>
std::size_t contact_points(const Clump& a, const B&) {
    return contact_room(a);
}
template <class B>
bool touching(const Clump& a, const B& b, const PairState& pair) {
    return by_nodes(a, b, pair, contact_points(a, b));
}
bool touching(const Sphere& a, const Clump& b, const PairState& pair) {
    return touching(b, a, swapped(pair));
}
bool touching(const SrShape& a, const Clump& b, const PairState& pair) {
    return touching(b, a, swapped(pair));
}

bool touching(const ConvexShape& a, const ConvexShape& b, const PairState& pair) {
    return by_cores(a, b, pair);
}
bool touching(const Sphere& a, const ConvexShape& b, const PairState& pair) {
    return by_cores(a, b, pair);
}
bool touching(const ConvexShape& a, const Sphere& b, const PairState& pair) {
    return by_cores(a, b, pair);
}
bool touching(const SrShape& a, const ConvexShape& b, const PairState& pair) {
    return a.is_convex ? by_cores(a, b, pair) : by_nodes(a, b, pair, a.nodes.nodes.size());
}
bool touching(const ConvexShape& a, const SrShape& b, const PairState& pair) {
    return touching(b, a, swapped(pair));
}
bool touching(const ConvexShape& a, const Clump& b, const PairState& pair) {
    return touching(b, a, swapped(pair));
}

template <class Wall>
bool touching(const ConvexShape& a, const Wall& wall, const PairState& pair) {
    return by_cores(a, wall, pair);
}
template <class Wall>
bool touching(const Sphere& a, const Wall& wall, const PairState& pair) {
    return in_closed_form(a, wall, pair);
}
template <class Wall>
bool touching(const SrShape& a, const Wall& wall, const PairState& pair) {
    if constexpr (SmoothWall<Wall>) {
        if (a.is_convex) return by_support<typename SmoothHistory<Wall>::Type>(a, wall, pair);
    }
    return by_nodes(a, wall, pair, a.nodes.nodes.size());
}

double extent(const Sphere& shape, const Quat&, const Vec3&) {
    return shape.radius;
}
double extent(const SrShape& shape, const Quat& orientation, const Vec3& direction) {
    if (shape.is_convex) return SrSupport{shape.support, body_axis(orientation)}(direction).h;
    const Vec3 n = orientation.conjugate() * direction;
    double farthest = -std::numeric_limits<double>::infinity();
    for (const SurfaceNodes::Node& node : shape.nodes.nodes)
        farthest = std::max(farthest, n.dot(Vec3(node.x, node.y, node.z)));
    return farthest;
}

double extent(const ConvexShape& shape, const Quat& orientation, const Vec3& direction) {
    return extent(shape, orientation.conjugate() * direction);
}

double extent(const Clump& shape, const Quat& orientation, const Vec3& direction) {
    const Vec3 n = orientation.conjugate() * direction;
    double farthest = -std::numeric_limits<double>::infinity();
    for (const ClumpSphere& s : shape.spheres)
        farthest = std::max(farthest, n.dot(s.center()) + s.radius);
    return farthest;
}

}  // namespace

bool touches(const ParticleTemplate& a, const ParticleTemplate& b, const PairState& pair) {
    return std::visit([&](const auto& i, const auto& j) { return touching(i, j, pair); }, a.shape,
                      b.shape);
}

bool touches(const ParticleTemplate& a, const WallShape& wall, const PairState& pair) {
    return std::visit([&](const auto& i, const auto& j) { return touching(i, j, pair); }, a.shape,
                      wall);
}

double extent(const ParticleTemplate& shape, const Quat& orientation, const Vec3& direction) {
    return std::visit([&](const auto& s) { return extent(s, orientation, direction); },
                      shape.shape);
}

}  // namespace dem
