// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_wall_nodes.hpp"

#include "runtime/contact/smooth/sr_curvature.hpp"

namespace dem::runtime {

namespace {

/// What rounding may do to positions and to the travel that lists live by, generously [m].
double rounding(const SrShape& a) {
    return 1e-9 * a.bounding_radius;
}

template <class Field>
PairContact against(const SrShape& a, const Field& field, const NodeFrame& frame,
                    const PatchCall& call) {
    const double margin = list_margin(a);
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap = field.sample(Vec3::Zero()).distance - a.bounding_radius - field.slack;
        if (gap > margin) return apart(call, gap);
    }
    const TouchingNodes<Field> touching = touching_nodes(a.nodes, field, frame, margin, call);
    const double radius = 1.0 / contact_curvature(a.nodes.nodes[touching.deepest].mean_curvature,
                                                  a.equivalent_diameter);
    return contact_force(touching.points, radius, call);
}

}  // namespace

template <AnyWall Wall>
PairContact collide(const SrShape& a, const Wall& wall, const PatchCall& call) {
    const PairState& pair = call.pair;
    const NodeFrame frame{pair.i.orientation.toRotationMatrix()};
    const WallFrame place{frame.to_world.transpose() * pair.displacement,
                          frame.to_world.transpose() * body_axis(pair.j.orientation)};
    return wall.with_field(place, rounding(a), [&](const auto& field) {
        const Vec3 center = Vec3::Zero();
        if (field.lets_pass(center)) return apart(call, -field.sample(center).distance);
        return against(a, field, frame, call);
    });
}

#define DEM_NODES_AT(Wall) \
    template PairContact collide(const SrShape&, const Wall&, const PatchCall&);
DEM_FOR_EACH_WALL_SHAPE(DEM_NODES_AT)

}  // namespace dem::runtime
