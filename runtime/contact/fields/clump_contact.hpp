// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/clump_search.hpp"
#include "runtime/contact/fields/node_contact.hpp"

#include <algorithm>
#include <span>

/// From touching spheres to the contact points of a pair: what all kernels of clumps share.
namespace dem::runtime {

template <class Sample>
struct TouchingSpheres {
    std::span<const ContactPoint> points;  ///< in the order of features
    Sample deepest{};
};

/// Room for contact points that a clump needs: more than any pair has that a run survives.
inline std::size_t contact_room(const Clump& clump) {
    return 16 * clump.spheres.size();
}

/// Width of the shell in which spheres are listed [m]; see list_margin().
inline double list_margin(double bounding_radius) {
    return 0.01 * bounding_radius;
}
/// What rounding may do to positions and travels, generously [m].
inline double clump_rounding(double bounding_radius) {
    return 1e-9 * bounding_radius;
}

/// Contact points of all elements (clump_search.hpp) that touch, each made by point(k, sample).
/// Should there be more than the scratch holds, the shallowest are left out.
template <class Elements, class MakePoint>
TouchingSpheres<typename Elements::Sample> touching_spheres(const Elements& elements, double margin,
                                                            const PatchCall& call,
                                                            const MakePoint& point) {
    using Sample = typename Elements::Sample;
    TouchingSpheres<Sample> touching;
    ContactScratch& scratch = *call.scratch.points;
    std::size_t count = 0;
    bool is_full = false;
    double deepest = 0.0;
    const auto is_deeper = [](const ContactPoint& a, const ContactPoint& b) {
        return a.overlap > b.overlap || (a.overlap == b.overlap && a.feature < b.feature);
    };
    visit_touching(elements, margin, call.travel, call.memory.cache,
                   [&](std::uint32_t k, const Sample& sample) {
                       if (sample.distance < deepest) {
                           deepest = sample.distance;
                           touching.deepest = sample;
                       }
                       if (count < scratch.size()) {
                           scratch[count++] = point(k, sample);
                           return;
                       }
                       // A heap with the shallowest point on top.
                       if (!is_full) std::make_heap(scratch.begin(), scratch.end(), is_deeper);
                       is_full = true;
                       const ContactPoint next = point(k, sample);
                       if (!is_deeper(next, scratch.front())) return;
                       std::pop_heap(scratch.begin(), scratch.end(), is_deeper);
                       scratch.back() = next;
                       std::push_heap(scratch.begin(), scratch.end(), is_deeper);
                   });
    if (is_full) {
        std::sort(scratch.begin(), scratch.end(),
                  [](const auto& a, const auto& b) { return a.feature < b.feature; });
    }
    touching.points = std::span(scratch.data(), count);
    return touching;
}

/// The contact point of a sphere of i that touches a field with this gradient.
template <class Sample>
ContactPoint sphere_point(std::uint32_t k, const Sample& s, const Vec3& gradient) {
    const double overlap = -s.distance;
    return {s.center - (s.radius - 0.5 * overlap) * gradient.normalized(), gradient, overlap, k};
}

/// A clump, i, against a field of distances to a wall or another body. `curvature`: of the partner,
/// 0 for a wall [1/m].
template <class Field>
PairContact clump_in_field(const PlacedSpheres& spheres, const Field& field, double margin,
                           double curvature, const PatchCall& call) {
    const Clump::Ball bound = spheres.bound();
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap =
            field.sample(spheres.place(bound.center())).distance - bound.radius - field.slack;
        if (gap > margin) return apart(call, gap);
    }
    const SpheresInField<Field> elements{spheres, field};
    const NodeFrame frame{Mat3::Identity()};
    const auto mean_at = during_step(field, frame, call, ContactLaw::NodeNormal::gradient);
    const auto touching =
        touching_spheres(elements, margin, call, [&](std::uint32_t k, const auto& sample) {
            return sphere_point(k, sample, mean_at(sample.center, sample.field).gradient);
        });
    const double radius = touching.deepest.radius;
    return contact_force(touching.points,
                         curvature > 0.0 ? 1.0 / (1.0 / radius + curvature) : radius, call);
}

}  // namespace dem::runtime
