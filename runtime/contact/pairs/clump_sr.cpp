// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_sr.hpp"

#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/smooth/common_normal.hpp"
#include "runtime/contact/smooth/smooth_contact.hpp"
#include "runtime/contact/smooth/sr_curvature.hpp"
#include "runtime/contact/walls/wall_frame.hpp"

namespace dem::runtime {

namespace {

/// The distance field as the centers of spheres see it. They touch some way off the surface, where
/// the interpolant is known to SdfQuadtree::lipschitz_slack and no better.
struct OffsetField : SrField {
    OffsetField(const SrShape& shape, const Vec3& shape_center, const Quat& orientation)
        : SrField(shape, shape_center, body_axis(orientation)) {
        slack = 2.0 * sdf->lipschitz_slack;
    }
    double proven_gap(double distance) const { return distance - slack; }
};

/// Spheres against a convex shape: the gap along the common normal, or a lower bound of it where
/// the distance field proves a miss.
struct SpheresOnConvex {
    struct Sample {
        double distance;  ///< [m]
        double radius;    ///< of the sphere [m]
        CommonNormal at;  ///< from the sphere to the shape, relative to the center of the sphere
        Vec3 center;      ///< of the sphere [m]
    };

    const PlacedSpheres& spheres;
    const SrShape& shape;
    SpheresInField<OffsetField> near;
    SrSupport support;
    double slack;  ///< of the field, and of the support map's crowned flats against it [m]

    SpheresOnConvex(const PlacedSpheres& placed, const OffsetField& field, const SrShape& sr)
        : spheres(placed),
          shape(sr),
          near{placed, field},
          support{sr.support, field.axis},
          slack(field.slack + 1e-4 * sr.major_axis_length) {}

    Sample sample(std::uint32_t k) const { return sample(near.sample(k)); }
    Sample sample(const SpheresInField<OffsetField>::Sample& s) const {
        if (s.distance > slack) return {s.distance - slack, s.radius, {}, s.center};
        const Vec3 d = near.field.center - s.center;
        const double length = d.norm();
        const Vec3 start = length > 0.0 ? Vec3(d / length) : Vec3::UnitZ();
        const CommonNormal at =
            result_of(common_normal(SphereSupport{s.radius}, support, d, start), d);
        return {-at.f, s.radius, at, s.center};
    }
    static bool accepts(std::uint32_t /*k*/, const Sample& /*sample*/) { return true; }
    double proven_gap(double distance) const {
        return distance - clump_rounding(shape.bounding_radius);
    }

    template <class Visit>
    double visit_near(double margin, const Visit& visit) const {
        double others = std::numeric_limits<double>::infinity();
        const double beyond =
            near.visit_near(margin + slack, [&](std::uint32_t k, const auto& in_field) {
                const Sample s = sample(in_field);
                if (s.distance < margin)
                    visit(k, s);
                else
                    others = std::min(others, s.distance);
            });
        return std::min(others, beyond - slack);
    }
};

/// The clump is i.
struct ClumpAndShape {
    const Clump& clump;
    const SrShape& shape;
    const PairState& pair;

    PlacedSpheres spheres() const { return {clump, pair.i.orientation, Vec3::Zero()}; }
    OffsetField field() const { return {shape, pair.displacement, pair.j.orientation}; }
};

double margin_of(const ClumpAndShape& pair) {
    return list_margin(std::min(pair.spheres().bound().radius, pair.shape.bounding_radius));
}

PairContact on_convex(const ClumpAndShape& pair, const PatchCall& call) {
    const OffsetField field = pair.field();
    const PlacedSpheres spheres = pair.spheres();
    const SpheresOnConvex elements(spheres, field, pair.shape);
    const auto touching =
        touching_spheres(elements, margin_of(pair), call, [&](std::uint32_t k, const auto& s) {
            return ContactPoint{s.center + s.at.middle, -s.at.n, -s.distance, k};
        });
    if (touching.points.empty()) return contact_force(touching.points, 0.0, call);
    const SpheresOnConvex::Sample& deepest = touching.deepest;
    const double radius =
        contact_radius(call.law, SphereSupport{deepest.radius}(deepest.at.n), 2.0 * deepest.radius,
                       elements.support(-deepest.at.n), pair.shape.equivalent_diameter);
    return contact_force(touching.points, radius, call);
}

PairContact by_distance(const ClumpAndShape& pair, const PatchCall& call) {
    const SrShape& shape = pair.shape;
    const OffsetField field = pair.field();
    const PlacedSpheres spheres = pair.spheres();
    const SpheresInField<OffsetField> elements{spheres, field};
    const auto touching = touching_spheres(
        elements, margin_of(pair) + field.slack, call, [&](std::uint32_t k, const auto& s) {
            return sphere_point(
                k, s, node_normal(field, s.center, s.field, call.law.geometry.node_normal));
        });
    if (touching.points.empty()) return contact_force(touching.points, 0.0, call);
    const SrField::Sample& s = touching.deepest.field;
    const double of_shape = mean_curvature_near(shape, s.r, s.z, std::max(s.d_dr, 0.0), s.d_dz);
    return contact_force(touching.points, local_radius(shape, of_shape, touching.deepest.radius),
                         call);
}

/// The union of the spheres of a clump; exact outside, where nodes are sought.
struct UnionField : ExactField {
    struct Sample {
        double distance;       ///< [m]
        std::uint32_t sphere;  ///< the one that is nearest
    };

    PlacedSpheres spheres;

    Sample sample(const Vec3& x) const {
        Sample nearest{std::numeric_limits<double>::infinity(), 0};
        const Vec3 x_body = spheres.in_body(x);
        spheres.visit(
            [&](const Clump::Ball& ball) {
                return (x_body - ball.center()).norm() - ball.radius >=
                       nearest.distance + 2.0 * slack;
            },
            [&](std::uint32_t k) {
                const double distance = (x - spheres.center(k)).norm() - spheres.radius(k);
                if (distance < nearest.distance) nearest = {distance, k};
            });
        return nearest;
    }
    Vec3 gradient(const Vec3& x, const Sample& s) const {
        return (x - spheres.center(s.sphere)).normalized();
    }
    static bool accepts(const Vec3& /*x*/) { return true; }
};

PairContact by_nodes(const ClumpAndShape& pair, const PatchCall& call) {
    const SrShape& shape = pair.shape;
    const BodyState& j = pair.pair.j;
    const Quat to_shape = j.orientation.conjugate();
    const NodeFrame frame{j.orientation.toRotationMatrix(), pair.pair.displacement, -1.0};
    const PlacedSpheres spheres(pair.clump, to_shape * pair.pair.i.orientation,
                                to_shape * Vec3(-pair.pair.displacement));
    const UnionField field{{clump_rounding(spheres.bound().radius + shape.bounding_radius)},
                           spheres};
    const auto touching = touching_nodes(shape.nodes, field, frame, list_margin(shape), call);
    if (touching.points.empty()) return contact_force(touching.points, 0.0, call);
    const double of_shape = shape.nodes.nodes[touching.deepest].mean_curvature;
    const double of_sphere = spheres.radius(touching.deepest_sample.sphere);
    return contact_force(touching.points, local_radius(shape, of_shape, of_sphere), call);
}

}  // namespace

PairContact collide(const Clump& a, const SrShape& b, const PatchCall& call) {
    const ClumpAndShape pair{a, b, call.pair};
    const PlacedSpheres spheres = pair.spheres();
    const Clump::Ball bound = spheres.bound();
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap = (spheres.place(bound.center()) - call.pair.displacement).norm() -
                           bound.radius - b.bounding_radius -
                           clump_rounding(bound.radius + b.bounding_radius);
        if (gap > margin_of(pair)) return apart(call, gap);
    }
    if (b.is_convex) return on_convex(pair, call);
    return a.largest_radius <= b.sdf.margin ? by_distance(pair, call) : by_nodes(pair, call);
}

}  // namespace dem::runtime
