// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/touch.hpp"

#include "runtime/contact/cores/features.hpp"
#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/pairs/pair_table.hpp"
#include "runtime/contact/smooth/support_sample.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace dem::runtime {

namespace {

/// A law without stiffness: only the geometry counts.
const ContactLaw no_force{};

template <class Shape>
std::size_t points_of(const Shape& /*shape*/) {
    return 0;
}
std::size_t points_of(const SrShape& shape) {
    return shape.nodes.nodes.size();
}
std::size_t points_of(const Clump& shape) {
    return contact_room(shape);
}

/// Whether the kernel of a row finds a contact, with nothing remembered of the pair.
template <class Row>
bool touching(const typename Row::A& a, const typename Row::B& b, const PairState& pair) {
    typename Row::History history{};
    typename Row::Cache cache{};
    ContactScratch points(std::max(points_of(a), points_of(b)));
    ConvexScratch features;
    const Call call{pair, no_force, 0.0, Memory{history, cache}, 0.0, {&points, &features}};
    if (collide(a, b, call).touches()) return true;
    // The nodes of one body alone would miss a point of the other that lies between them.
    if constexpr (std::is_same_v<typename Row::A, SrShape> &&
                  std::is_same_v<typename Row::B, SrShape> &&
                  Row::method == ContactLaw::Method::nodes) {
        const PairState back = reversed(pair);
        history = {};
        cache = {};
        return collide(b, a,
                       Call{back, no_force, 0.0, Memory{history, cache}, 0.0,
                            Scratch{&points, &features}})
            .touches();
    }
    return false;
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
    return ParticlePairs::at_row_of(a, b, no_force, [&]<class Row>() {
        const auto* first = std::get_if<typename Row::A>(&a.shape);
        const auto* second = std::get_if<typename Row::B>(&b.shape);
        if (first != nullptr && second != nullptr) return touching<Row>(*first, *second, pair);
        return touching<Row>(std::get<typename Row::A>(b.shape), std::get<typename Row::B>(a.shape),
                             reversed(pair));
    });
}

bool touches(const ParticleTemplate& a, const WallShape& wall, const PairState& pair) {
    return WallPairs::at_row_of(a, wall, no_force, [&]<class Row>() {
        return touching<Row>(std::get<typename Row::A>(a.shape), std::get<typename Row::B>(wall),
                             pair);
    });
}

double extent(const ParticleTemplate& shape, const Quat& orientation, const Vec3& direction) {
    return std::visit([&](const auto& s) { return extent(s, orientation, direction); },
                      shape.shape);
}

}  // namespace dem::runtime
