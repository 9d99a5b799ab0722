// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"

#include "runtime/contact/smooth/sr_curvature.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

namespace dem {

namespace {

/// Where the shape is, seen from the centre of i, and whether it is i.
struct Placement {
    Vec3 center = Vec3::Zero();  ///< of the shape [m]
    Vec3 sphere = Vec3::Zero();  ///< centre of the sphere [m]
    const Quat& orientation;     ///< of the shape
    double sign;                 ///< 1: the shape is i
};

double effective_radius(const Sphere& sphere, const SrShape& shape, double of_shape) {
    return 1.0 / (contact_curvature(of_shape, shape.equivalent_diameter) + 1.0 / sphere.radius);
}

/// The shape's distance field at the centre of the sphere, everything in world axes.
PairContact by_distance(const Sphere& sphere, const SrShape& shape, const Placement& place,
                        const NodeCall& call) {
    const NodeMemory& memory = call.memory;
    const SrField field(shape, place.center, body_axis(place.orientation));
    const SrField::Sample s = field.sample(place.sphere);
    const double overlap = sphere.radius - s.distance;
    if (overlap <= 0.0) return keep_apart(-overlap - field.slack, memory);
    memory.cache = {};
    // The gradient points from the shape to the sphere.
    const Vec3 gradient = node_normal(field, place.sphere, s, call.law.node_normal);
    const Vec3 towards_i = -place.sign * gradient;
    const Vec3 position = place.sphere - (sphere.radius - 0.5 * overlap) * gradient.normalized();
    const ContactPoint point{position, towards_i, overlap, 0};
    const double of_shape = mean_curvature_near(shape, s.r, s.z, std::max(s.d_dr, 0.0), s.d_dz);
    return contact_force({&point, 1}, effective_radius(sphere, shape, of_shape), call);
}

/// The shape's nodes inside the sphere.
PairContact by_nodes(const Sphere& sphere, const SrShape& shape, const Placement& place,
                     const NodeCall& call) {
    const NodeMemory& memory = call.memory;
    const NodeFrame frame{place.orientation.toRotationMatrix(), place.center, place.sign};
    const Vec3 center = frame.to_world.transpose() * (place.sphere - place.center);
    const SphereField field{{1e-9 * shape.bounding_radius}, center, sphere.radius};
    const double margin = list_margin(shape);
    if (memory.travel >= memory.cache.listed_until) {
        const double gap =
            field.sample(Vec3::Zero()).distance - shape.bounding_radius - field.slack;
        if (gap > margin) return keep_apart(gap, memory);
    }
    const TouchingNodes<SphereField> touching =
        touching_nodes(shape.nodes, field, frame, margin, call);
    const double of_shape = shape.nodes.nodes[touching.deepest].mean_curvature;
    return contact_force(touching.points, effective_radius(sphere, shape, of_shape), call);
}

PairContact touch(const Sphere& sphere, const SrShape& shape, const Placement& place,
                  const NodeCall& call) {
    return sphere.radius <= shape.sdf.margin ? by_distance(sphere, shape, place, call)
                                             : by_nodes(sphere, shape, place, call);
}

}  // namespace

PairContact collide(const Sphere& a, const SrShape& b, const PairState& pair, const ContactLaw& law,
                    double dt, const NodeMemory& memory) {
    return touch(a, b, {pair.displacement, Vec3::Zero(), pair.j.orientation, -1.0},
                 {pair, law, dt, memory});
}

PairContact collide(const SrShape& a, const Sphere& b, const PairState& pair, const ContactLaw& law,
                    double dt, const NodeMemory& memory) {
    return touch(b, a, {Vec3::Zero(), pair.displacement, pair.i.orientation, 1.0},
                 {pair, law, dt, memory});
}

}  // namespace dem
