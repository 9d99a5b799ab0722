// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_sr.hpp"

#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/fields/core_field.hpp"
#include "runtime/contact/smooth/sr_curvature.hpp"

namespace dem::runtime {

PairContact collide(const SrShape& a, const ConvexShape& b, const CoreCall& call) {
    const PairState& pair = call.pair;
    return between_cores(PlacedSr(a, pair.i.orientation, Vec3::Zero()),
                         PlacedCore(b, pair.j.orientation, pair.displacement),
                         {a.equivalent_diameter, b.equivalent_diameter}, call);
}

PairContact collide(const SrShape& a, const ConvexShape& b, const PatchCall& call) {
    const PairState& pair = call.pair;
    const NodeFrame frame{pair.i.orientation.toRotationMatrix()};
    // The convex shape in the frame of the surface of revolution.
    const ConvexField field{{1e-9 * b.bounding_radius},
                            &b,
                            frame.to_world.transpose() * pair.j.orientation.toRotationMatrix(),
                            frame.to_world.transpose() * pair.displacement};
    const double margin = list_margin(a);
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap = field.sample(Vec3::Zero()).distance - a.bounding_radius - field.slack;
        if (gap > margin) return apart(call, gap);
    }
    const auto touching = touching_nodes(a.nodes, field, frame, margin, call);
    const double curvature =
        contact_curvature(a.nodes.nodes[touching.deepest].mean_curvature, a.equivalent_diameter);
    return contact_force(touching.points, 1.0 / (curvature + 2.0 / b.equivalent_diameter), call);
}

}  // namespace dem::runtime
