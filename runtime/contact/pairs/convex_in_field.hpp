// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/walls/wall_field.hpp"

/// A rounded core against any wall that is a field of distances f: all points of the core where
/// f(x) is less than the rounding overlap. Features are the corners of the core (vertices, the tip
/// of a cone, points fixed on rims), which carry where a body lies in a hollow, and its lowest
/// point, the one of least f, which carries where an edge, a side or a face meets a wall that
/// bulges. Together they are one potential (add_remaining()).
///
/// The lowest point is found by steps down f that are projected back onto the core (gradient
/// projection with Armijo's rule for the step), from the lowest corner on. It is one of several
/// where a body is not small against the wall's own radii. Some ten projections make this slower
/// than a kernel made for a shape, which planes and cylinders have (convex_wall.cpp).
namespace dem::runtime {

struct LowestPoint {
    Vec3 position;    ///< relative to the center of i [m]
    double distance;  ///< of the field [m]
};

/// The point of a core nearest to y.
inline Vec3 nearest_on(const PlacedCore& core, const Vec3& y) {
    const Vec3 y_body = core.in_body(y);
    const SurfaceDistance d = core_distance(core.shape, y_body);
    return d.distance > 0.0 ? core.place(y_body - d.distance * d.normal) : y;
}

/// Goes down from x, a point of the core, to where the field is least.
template <WallField Field>
LowestPoint lowest_point(const PlacedCore& core, const Field& field, const Vec3& x) {
    constexpr int most_steps = 100;
    const double least_way = 1e-9 * core.size;
    // An edge nearly along a rod asks for steps longer than the body; from farther away rounding
    // moves the nearest point of a round core.
    const double longest = 10.0 * core.size;
    double step = core.size;
    Vec3 here = x;
    auto sample = field.sample(here);
    for (int k = 0; k < most_steps; ++k) {
        const Vec3 next = nearest_on(core, here - step * field.gradient(here, sample));
        const double way2 = (next - here).squaredNorm();
        if (way2 <= square(least_way)) break;
        const auto there = field.sample(next);
        // Of a plane it is one, of a field of curvature c it is 1 - c step / 2.
        const double gain = (sample.distance - there.distance) * step / way2;
        if (gain < 0.5) {
            step *= 0.5;
            continue;
        }
        here = next;
        sample = there;
        if (gain > 0.75) step = std::min(2.0 * step, longest);
    }
    return {here, sample.distance};
}

/// The corners of a core as features of a wall.
template <WallField Field>
class CornerFeatures {
  public:
    CornerFeatures(const PlacedCore& core, const Field& field) : core_(core), field_(field) {}

    /// Calls visit(position, weight) for all corners.
    template <class Visit>
    void visit(const Visit& visit) const {
        const ConvexShape& shape = core_.shape;
        for (std::uint32_t v = 0; v < shape.vertices.size(); ++v) visit(core_.vertex(v), 1.0);
        const PlacedCaps caps = caps_of(core_);
        for (std::size_t c = 0; c < caps.count; ++c) {
            for (std::size_t k = 0; k < PlacedCap::sample_count; ++k)
                visit(caps.cap[c].sample(k), rim_sample_weight);
        }
        if (shape.core == ConvexShape::Core::cone)
            visit(core_.place({0.0, 0.0, shape.low + shape.size.z}), 1.0);
    }
    /// The lowest corner, or of a core without corners the point farthest down.
    Vec3 lowest() const {
        const Vec3 down = -field_.gradient(core_.center, field_.sample(core_.center));
        Vec3 lowest = core_.support(down, 0).position;
        double least = field_.sample(lowest).distance;
        visit([&](const Vec3& x, double /*weight*/) {
            const double distance = field_.sample(x).distance;
            if (!(distance < least)) return;
            least = distance;
            lowest = x;
        });
        return lowest;
    }
    FeaturePoint point(const Vec3& x) const {
        const auto sample = field_.sample(x);
        const double overlap = core_.rounding - sample.distance;
        const Vec3 normal = field_.gradient(x, sample);
        return {x - (core_.rounding - 0.5 * overlap) * normal, normal, overlap};
    }
    void add_to(FeatureSum& sum) const {
        visit([&](const Vec3& x, double weight) {
            const FeaturePoint p = point(x);
            if (p.overlap > 0.0 && field_.accepts(x)) sum.add(p, weight);
        });
    }

  private:
    const PlacedCore& core_;
    const Field& field_;
};

template <WallField Field>
PairContact convex_in_field(const ConvexShape& a, const Field& field, const CoreCall& call) {
    const Vec3 center = Vec3::Zero();
    const double height = field.sample(center).distance;
    if (height > a.bounding_radius) return apart(call, height - a.bounding_radius);
    if (field.lets_pass(center)) return apart(call, -height);
    const PlacedCore core(a, call.pair.i.orientation, center);
    const CornerFeatures<Field> corners(core, field);
    const LowestPoint lowest = lowest_point(core, field, corners.lowest());
    const FeaturePoint deepest = corners.point(lowest.position);
    if (!(deepest.overlap > 0.0)) return apart(call, 0.0);
    FeatureSum features(call.pair, deepest.overlap);
    if (a.is_strictly_convex()) {
        if (field.accepts(lowest.position)) features.add(deepest, 1.0);
    } else {
        FeatureSum others(call.pair, deepest.overlap);
        corners.add_to(others);
        if (field.accepts(lowest.position)) {
            add_remaining(deepest, others, features);
        } else {
            features.add(others, 1.0);
        }
    }
    if (features.empty()) return apart(call, 0.0);
    return contact_force(features, 0.5 * a.equivalent_diameter, call.law, call.dt,
                         call.memory.history);
}

}  // namespace dem::runtime
