// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_wall_nodes.hpp"

#include "runtime/contact/smooth/sr_curvature.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

#include <cmath>

namespace dem {

namespace {

/// What rounding may do to positions and to the travel that lists live by, generously [m].
double rounding(const SrShape& a) {
    return 1e-9 * a.bounding_radius;
}

template <class Field>
PairContact against(const SrShape& a, const Field& field, const NodeFrame& frame,
                    const NodeCall& call) {
    const NodeMemory& memory = call.memory;
    const double margin = list_margin(a);
    if (memory.travel >= memory.cache.listed_until) {
        const double gap = field.sample(Vec3::Zero()).distance - a.bounding_radius - field.slack;
        if (gap > margin) return keep_apart(gap, memory);
    }
    const TouchingNodes<Field> touching = touching_nodes(a.nodes, field, frame, margin, call);
    const double radius = 1.0 / contact_curvature(a.nodes.nodes[touching.deepest].mean_curvature,
                                                  a.equivalent_diameter);
    return contact_force(touching.points, radius, call);
}

}  // namespace

PairContact collide(const SrShape& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    const NodeCall call{pair, law, dt, memory};
    const Vec3 normal = body_axis(pair.j.orientation);
    const double in_front = -pair.displacement.dot(normal);
    // A disc acts on bodies in front of it; one behind has at least the way through it to go.
    if (std::isfinite(wall.radius) && in_front <= 0.0) return keep_apart(-in_front, memory);
    const NodeFrame frame{pair.i.orientation.toRotationMatrix()};
    const PlaneField field{{rounding(a)},
                           frame.to_world.transpose() * pair.displacement,
                           frame.to_world.transpose() * normal,
                           wall.radius};
    return against(a, field, frame, call);
}

PairContact collide(const SrShape& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const NodeMemory& memory) {
    const NodeFrame frame{pair.i.orientation.toRotationMatrix()};
    const NodeCall call{pair, law, dt, memory};
    const Vec3 origin = frame.to_world.transpose() * pair.displacement;
    const Vec3 axis = frame.to_world.transpose() * body_axis(pair.j.orientation);
    const ExactField exact{rounding(a)};
    if (wall.inside) {
        return against(a, TubeField{exact, origin, axis, wall.radius, wall.length}, frame, call);
    }
    return against(a, RodField{exact, origin, axis, wall.radius, wall.length}, frame, call);
}

}  // namespace dem
