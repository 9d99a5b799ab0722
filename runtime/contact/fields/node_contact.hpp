// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/fields/crease.hpp"
#include "runtime/contact/fields/node_fields.hpp"
#include "runtime/contact/fields/node_search.hpp"
#include "runtime/contact/law/contact_point.hpp"

#include <span>

/// From nodes inside a field to the contact points of a pair: what all kernels by nodes share.
namespace dem::runtime {

using PatchCall = Call<PatchHistory, NearCache>;

/// How the frame of the body with the nodes lies in the pair: its rotation to the world, its center
/// relative to the center of i [m], and whether it is i (1) or j (-1).
struct NodeFrame {
    Mat3 to_world;
    Vec3 center = Vec3::Zero();
    double sign = 1.0;
};

/// The touching nodes of a pair.
template <class Field>
struct TouchingNodes {
    std::span<const ContactPoint> points;
    std::uint32_t deepest = 0;                ///< node
    typename Field::Sample deepest_sample{};  ///< of the field at that node
};

/// Width of the shell in which nodes are listed [m]. Wider lists live longer but cost more each
/// step; measured in docs/contact-nodes.md.
inline double list_margin(const SrShape& shape) {
    return 0.0025 * shape.major_axis_length;
}
/// Width of that shell against a distance field: what its error may hide is added, never beyond the
/// band in which that error is known.
inline double list_margin(const SrShape& shape, const SrShape& other) {
    const double margin = list_margin(shape) + 2.0 * other.sdf.surface_slack;
    return other.sdf.surface_band > 0.0 ? std::min(margin, other.sdf.surface_band) : margin;
}

/// What a kernel returns for bodies that are apart by a proven gap > 0 [m].
inline PairContact apart(const PatchCall& call, double gap) {
    const auto& [history, cache] = call.memory;
    cache.count = 0;
    cache.clear_until = cache.listed_until = call.travel + gap;
    return parting(history);
}

/// Direction of the force at a touching node, in its body's frame. Exact fields have one.
template <class Field>
Vec3 node_normal(const Field& field, const Vec3& x, const typename Field::Sample& sample,
                 ContactLaw::NodeNormal rule) {
    if constexpr (requires { field.distance_vector(x, sample); }) {
        using NodeNormal = ContactLaw::NodeNormal;
        if (rule == NodeNormal::vectors || rule == NodeNormal::averaged)
            return -field.distance_vector(x, sample).normalized();
    }
    const Vec3 gradient = field.gradient(x, sample);
    return rule == ContactLaw::NodeNormal::gradient ? gradient : Vec3(gradient.normalized());
}

/// Direction of the force at a touching point x of the body in this frame, and its distance, as a
/// function of x and the sample there: where the field has creases the means over the step.
template <class Field>
auto during_step(const Field& field, const NodeFrame& frame, const PatchCall& call,
                 ContactLaw::NodeNormal rule) {
    using Sample = typename Field::Sample;
    if constexpr (CreasedField<Field>) {
        return [&field, way = step_way(call.pair, frame.to_world, frame.center, frame.sign,
                                       call.dt)](const Vec3& x, const Sample& sample) {
            return step_mean(field, x, sample, way.at(x));
        };
    } else {
        return [&field, rule](const Vec3& x, const Sample& sample) {
            return StepMean{node_normal(field, x, sample, rule), sample.distance};
        };
    }
}

/// [SR] Eq. 16: every point gets the direction of the sum of all overlap vectors.
inline void average_normals(std::span<ContactPoint> points) {
    Vec3 sum = Vec3::Zero();
    for (const ContactPoint& p : points) sum += p.overlap * p.gradient;
    const double length = sum.norm();
    if (length == 0.0) return;
    for (ContactPoint& p : points) p.gradient = sum / length;
}

/// Contact points of all nodes inside the field, in rising order of the nodes.
template <class Field>
TouchingNodes<Field> touching_nodes(const SurfaceNodes& nodes, const Field& field,
                                    const NodeFrame& frame, double margin, const PatchCall& call) {
    ContactScratch& scratch = *call.scratch.points;
    const ContactLaw::NodeNormal rule = call.law.geometry.node_normal;
    const auto mean_at = during_step(field, frame, call, rule);
    TouchingNodes<Field> touching;
    std::size_t count = 0;
    double deepest = 0.0;
    visit_touching_nodes(nodes, field, margin, call.travel, call.memory.cache,
                         [&](std::uint32_t k, const typename Field::Sample& sample) {
                             const SurfaceNodes::Node& node = nodes.nodes[k];
                             const Vec3 x(node.x, node.y, node.z);
                             const StepMean mean = mean_at(x, sample);
                             scratch[count++] = {
                                 frame.center + frame.to_world * x,
                                 frame.sign * (frame.to_world * mean.gradient),
                                 -(mean.distance < 0.0 ? mean.distance : sample.distance), k};
                             if (sample.distance < deepest) {
                                 deepest = sample.distance;
                                 touching.deepest = k;
                                 touching.deepest_sample = sample;
                             }
                         });
    const std::span<ContactPoint> points(scratch.data(), count);
    if (rule == ContactLaw::NodeNormal::averaged) average_normals(points);
    touching.points = points;
    return touching;
}

inline PairContact contact_force(std::span<const ContactPoint> points, double local_radius,
                                 const PatchCall& call) {
    return contact_force(points, local_radius, call.pair, call.law, call.dt, call.memory.history);
}

}  // namespace dem::runtime
