// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_sr_nodes.hpp"

#include "runtime/contact/smooth/sr_curvature.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

namespace dem::runtime {

namespace {

/// Lower bound of the distance of the nodes of a from b [m]: bounding spheres against each other,
/// and the bounding sphere of each body in the distance field of the other.
double bounding_gap(const SrShape& a, const SrShape& b, const SrField& field) {
    const double spheres = field.center.norm() - a.bounding_radius - b.bounding_radius;
    const double of_a = field.sample(Vec3::Zero()).distance - a.bounding_radius - field.slack;
    const SrField reverse(a, Vec3::Zero(), Vec3::UnitZ());
    const double of_b =
        reverse.sample(field.center).distance - b.bounding_radius - reverse.slack - field.slack;
    return std::max({spheres, of_a, of_b});
}

/// Outward direction of the slave near the node that is nearest to it: at the block that seems the
/// nearest one. Any direction would do for what it is used for; a good one saves most.
Vec3 facing_direction(const SurfaceNodes& nodes, const SrField& field) {
    const auto nearest = [&](const SharedArray<SurfaceNodes::Ball>& balls, std::size_t first,
                             std::size_t last) {
        std::size_t best = first;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = first; k < last; ++k) {
            const double d = field.sample({balls[k].x, balls[k].y, balls[k].z}).distance;
            if (d < least) {
                least = d;
                best = k;
            }
        }
        return best;
    };
    constexpr std::size_t fan = SurfaceNodes::block_size;
    const std::size_t super_block = nearest(nodes.super_blocks, 0, nodes.super_blocks.size());
    const std::size_t block = nearest(nodes.blocks, fan * super_block,
                                      std::min(fan * (super_block + 1), nodes.blocks.size()));
    const Vec3 x(nodes.blocks[block].x, nodes.blocks[block].y, nodes.blocks[block].z);
    const Vec3 gradient = field.gradient(x, field.sample(x));
    return gradient.squaredNorm() > 0.0 ? Vec3(gradient.normalized()) : field.axis;
}

/// R* where the deepest node lies: H of the master at the node, of the slave beside it [1/m].
double local_radius(const SrShape& a, const SrShape& b, const TouchingNodes<SrField>& nodes) {
    const SrField::Sample& s = nodes.deepest_sample;
    const double of_a = a.nodes.nodes[nodes.deepest].mean_curvature;
    const double of_b = mean_curvature_near(b, s.r, s.z, std::max(s.d_dr, 0.0), s.d_dz);
    return 1.0 / (contact_curvature(of_a, a.equivalent_diameter) +
                  contact_curvature(of_b, b.equivalent_diameter));
}

}  // namespace

PairContact collide(const SrShape& a, const SrShape& b, const PatchCall& call) {
    const PairState& pair = call.pair;
    const NodeFrame frame{pair.i.orientation.toRotationMatrix()};
    SrField field(b, frame.to_world.transpose() * pair.displacement,
                  frame.to_world.transpose() * body_axis(pair.j.orientation));
    const double margin = list_margin(a, b);
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap = bounding_gap(a, b, field);
        if (gap > margin) return apart(call, gap);
        if (b.is_convex) field.set_floor(b, facing_direction(a.nodes, field));
    }
    const TouchingNodes<SrField> touching = touching_nodes(a.nodes, field, frame, margin, call);
    const double radius = touching.points.empty() ? 0.0 : local_radius(a, b, touching);
    return contact_force(touching.points, radius, call);
}

}  // namespace dem::runtime
