// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"

#include "runtime/contact/smooth/sr_curvature.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

namespace dem::runtime {

namespace {

/// The shape's distance field at the center of the sphere, everything in world axes.
PairContact by_distance(const Sphere& sphere, const SrShape& shape, const PatchCall& call) {
    const SrField field(shape, call.pair.displacement, body_axis(call.pair.j.orientation));
    const SrField::Sample s = field.sample(Vec3::Zero());
    const double overlap = sphere.radius - s.distance;
    if (overlap <= 0.0) return apart(call, -overlap - field.slack);
    call.memory.cache = {};
    // The gradient points from the shape to the sphere.
    const Vec3 gradient = node_normal(field, Vec3::Zero(), s, call.law.geometry.node_normal);
    const Vec3 position = -(sphere.radius - 0.5 * overlap) * gradient.normalized();
    const ContactPoint point{position, gradient, overlap, 0};
    const double of_shape = mean_curvature_near(shape, s.r, s.z, std::max(s.d_dr, 0.0), s.d_dz);
    return contact_force({&point, 1}, local_radius(shape, of_shape, sphere.radius), call);
}

/// The shape's nodes inside the sphere.
PairContact by_nodes(const Sphere& sphere, const SrShape& shape, const PatchCall& call) {
    const PairState& pair = call.pair;
    const NodeFrame frame{pair.j.orientation.toRotationMatrix(), pair.displacement, -1.0};
    const Vec3 center = frame.to_world.transpose() * Vec3(-pair.displacement);
    const SphereField field{{1e-9 * shape.bounding_radius}, center, sphere.radius};
    const double margin = list_margin(shape);
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap =
            field.sample(Vec3::Zero()).distance - shape.bounding_radius - field.slack;
        if (gap > margin) return apart(call, gap);
    }
    const TouchingNodes<SphereField> touching =
        touching_nodes(shape.nodes, field, frame, margin, call);
    const double of_shape = shape.nodes.nodes[touching.deepest].mean_curvature;
    return contact_force(touching.points, local_radius(shape, of_shape, sphere.radius), call);
}

}  // namespace

PairContact collide(const Sphere& a, const SrShape& b, const PatchCall& call) {
    return a.radius <= b.sdf.margin ? by_distance(a, b, call) : by_nodes(a, b, call);
}

}  // namespace dem::runtime
