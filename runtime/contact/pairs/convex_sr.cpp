// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_sr.hpp"

#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/fields/core_field.hpp"
#include "runtime/contact/smooth/sr_curvature.hpp"

namespace dem {

namespace {

/// `frame`: of the surface of revolution.
PairContact by_nodes(const SrShape& sr, const NodeFrame& frame, const ConvexField& field,
                     const NodeCall& call) {
    const NodeMemory& memory = call.memory;
    const double margin = list_margin(sr);
    if (memory.travel >= memory.cache.listed_until) {
        const double gap = field.sample(Vec3::Zero()).distance - sr.bounding_radius - field.slack;
        if (gap > margin) return keep_apart(gap, memory);
    }
    const auto touching = touching_nodes(sr.nodes, field, frame, margin, call);
    const double curvature =
        contact_curvature(sr.nodes.nodes[touching.deepest].mean_curvature, sr.equivalent_diameter);
    return contact_force(touching.points,
                         1.0 / (curvature + 2.0 / field.shape->equivalent_diameter), call);
}

/// The convex shape in the frame of the surface of revolution.
ConvexField field_in(const NodeFrame& frame, const ConvexShape& shape, const Quat& orientation,
                     const Vec3& center) {
    return {{1e-9 * shape.bounding_radius},
            &shape,
            frame.to_world.transpose() * orientation.toRotationMatrix(),
            frame.to_world.transpose() * (center - frame.center)};
}

PlacedSr placed(const SrShape& shape, const Quat& orientation, const Vec3& center) {
    return {shape, orientation, center};
}
PlacedCore placed(const ConvexShape& shape, const Quat& orientation, const Vec3& center) {
    return {shape, orientation, center};
}

template <class A, class B>
PairContact by_cores(const A& a, const B& b, const ConvexCall& call) {
    const PairState& pair = call.pair;
    return between_cores(placed(a, pair.i.orientation, Vec3::Zero()),
                         placed(b, pair.j.orientation, pair.displacement),
                         {a.equivalent_diameter, b.equivalent_diameter}, call);
}

}  // namespace

PairContact collide(const SrShape& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    return by_cores(a, b, {pair, law, dt, memory});
}

PairContact collide(const ConvexShape& a, const SrShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    return by_cores(a, b, {pair, law, dt, memory});
}

PairContact collide(const SrShape& a, const ConvexShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    const NodeFrame frame{pair.i.orientation.toRotationMatrix()};
    return by_nodes(a, frame, field_in(frame, b, pair.j.orientation, pair.displacement),
                    {pair, law, dt, memory});
}

PairContact collide(const ConvexShape& a, const SrShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    const NodeFrame frame{pair.j.orientation.toRotationMatrix(), pair.displacement, -1.0};
    return by_nodes(b, frame, field_in(frame, a, pair.i.orientation, Vec3::Zero()),
                    {pair, law, dt, memory});
}

}  // namespace dem
