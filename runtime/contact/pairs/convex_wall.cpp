// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_wall.hpp"

#include "common/math/elementary.hpp"
#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/cores/farthest_of_ellipse.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace dem::runtime {

namespace {

// ---- A plane, or a disc.

class PlaneFeatures {
  public:
    PlaneFeatures(const PlacedCore& core, const PlaneField& plane, FeatureSum& features)
        : core_(core), plane_(plane), features_(features) {}

    void add_all(std::uint32_t lowest, ConvexScratch& scratch) {
        const ConvexShape& shape = core_.shape;
        const Vec3 down = -plane_.frame.axis;
        if (core_.has_vertices()) {
            collect_vertices(core_, down, features_.deepest(), lowest, scratch.i);
            for (const ConvexCap::Vertex& v : scratch.i.vertices)
                add(core_.vertex(v.number), features_);
            return;
        }
        const PlacedCaps caps = caps_of(core_);
        for (std::size_t k = 0; k < caps.count; ++k) add_cap(caps.cap[k], down);
        if (shape.core == ConvexShape::Core::cone)
            add(core_.place({0.0, 0.0, shape.low + shape.size.z}), features_);
        if (caps.count == 0) add(core_.support(down, 0).position, features_);
    }

  private:
    FeaturePoint point(const Vec3& x) const {
        const double overlap = core_.rounding - plane_.distance(x);
        const Vec3& normal = plane_.frame.axis;
        return {x - (core_.rounding - 0.5 * overlap) * normal, normal, overlap};
    }
    void add(const Vec3& x, FeatureSum& sum, double weight = 1.0) const {
        const FeaturePoint p = point(x);
        if (p.overlap > 0.0 && plane_.accepts(x)) sum.add(p, weight);
    }
    void add_cap(const PlacedCap& cap, const Vec3& down) const {
        const FeaturePoint deepest = point(cap.support(down, 0).position);
        if (!(deepest.overlap > 0.0)) return;
        FeatureSum samples(features_.pair(), features_.deepest());
        for (std::size_t k = 0; k < PlacedCap::sample_count; ++k)
            add(cap.sample(k), samples, rim_sample_weight);
        if (plane_.accepts(deepest.position)) add_blended(deepest, 1.0, samples, features_);
    }

    const PlacedCore& core_;
    const PlaneField& plane_;
    FeatureSum& features_;
};

// ---- The inside of a cylinder.

class TubeFeatures {
  public:
    TubeFeatures(const PlacedCore& core, const CylinderWall& wall, const Vec3& axis,
                 const PairState& pair)
        : core_(core),
          wall_(wall),
          axis_(axis),
          e1_(axis.unitOrthogonal()),
          e2_(axis.cross(e1_)),
          origin_(pair.displacement) {}

    /// Calls visit(feature, weight) for every feature; gap() is known afterwards.
    template <class Visit>
    void visit(const Visit& visit) {
        if (core_.has_vertices()) {
            for (std::uint32_t v = 0; v < core_.shape.vertices.size(); ++v)
                visit_point(core_.vertex(v), visit);
            return;
        }
        const PlacedCaps caps = caps_of(core_);
        for (std::size_t k = 0; k < caps.count; ++k) {
            const PlacedCap& cap = caps.cap[k];
            const double r = axial_point(cap.center - origin_, axis_).r;
            const double clear = wall_.radius - r - cap.radius - core_.rounding;
            gap_ = std::min(gap_, clear);
            if (clear > 0.0) continue;
            const Vec2 n = across(cap.axis);
            const double r2 = square(cap.radius);
            visit_outline(cap,
                          ellipse_of(across(cap.center - origin_), r2 * (1.0 - square(n.x())),
                                     -r2 * n.x() * n.y(), r2 * (1.0 - square(n.y()))),
                          visit);
        }
        if (core_.shape.core == ConvexShape::Core::cone)
            visit_point(core_.place({0.0, 0.0, core_.shape.low + core_.shape.size.z}), visit);
        if (caps.count == 0) {
            const Vec3 axes = core_.shape.size;
            const Vec3 x = axes.cwiseProduct(core_.direction_in_body(e1_));
            const Vec3 y = axes.cwiseProduct(core_.direction_in_body(e2_));
            const Vec2 center = across(core_.center - origin_);
            visit_outline(core_, ellipse_of(center, x.dot(x), x.dot(y), y.dot(y)), visit);
        }
    }
    double gap() const { return gap_; }

  private:
    template <class Visit>
    void visit_point(const Vec3& x, const Visit& visit) {
        const AxialPoint p = axial_point(x - origin_, axis_);
        add({x, p.radial, p.r, p.z}, 1.0, visit);
    }
    Vec2 across(const Vec3& v) const { return {v.dot(e1_), v.dot(e2_)}; }
    /// The places farthest from the axis of an end or a body whose outline across the axis is the
    /// ellipse.
    template <class Supported, class Visit>
    void visit_outline(const Supported& body, const Ellipse& outline, const Visit& visit) {
        const FarthestPlaces places = farthest_places(outline);
        const auto look_at = [&](const Vec2& direction, double weight) {
            const Vec3 e = direction.x() * e1_ + direction.y() * e2_;
            const Vec3 x = body.support(e, 0).position - origin_;
            return add({origin_ + x, e, e.dot(x), x.dot(axis_)}, weight, visit);
        };
        bool all_touch = true;
        for (std::size_t k = 0; k < places.count; ++k)
            all_touch = look_at(places.direction[k], 1.0) && all_touch;
        // Two places that become one do so together with the place between them: counted against
        // them it leaves one (docs/contact.md, "Many points").
        if (places.count == 2 && all_touch) look_at(places.between, -1.0);
    }
    /// A point of the core as the tube sees it.
    struct Place {
        Vec3 x, outward;
        double r, z;
    };
    template <class Visit>
    bool add(const Place& p, double weight, const Visit& visit) {
        const double overlap = p.r + core_.rounding - wall_.radius;
        if (weight > 0.0) gap_ = std::min(gap_, -overlap);
        if (!(overlap > 0.0)) return false;
        if (!wall_.reaches(p.z)) return false;
        const Vec3 position = p.x + (core_.rounding - 0.5 * overlap) * p.outward;
        visit(FeaturePoint{position, -p.outward, overlap}, weight);
        return true;
    }

    const PlacedCore& core_;
    const CylinderWall& wall_;
    Vec3 axis_, e1_, e2_, origin_;
    double gap_ = infinite;
};

PairContact in_tube(const ConvexShape& a, const CylinderWall& wall, const CoreCall& call) {
    const Vec3 axis = body_axis(call.pair.j.orientation);
    const AxialPoint c = axial_point(-call.pair.displacement, axis);
    const double clear = wall.radius - c.r - a.bounding_radius;
    if (clear > 0.0) return apart(call, clear);
    const PlacedCore core(a, call.pair.i.orientation, Vec3::Zero());
    TubeFeatures tube(core, wall, axis, call.pair);
    std::vector<FeaturePoint>& points = call.scratch.features->points;
    points.clear();
    double deepest = 0.0;
    // Places between others never are the deepest: they wait at the end.
    std::array<FeaturePoint, 2> between;
    std::size_t between_count = 0;
    tube.visit([&](const FeaturePoint& p, double weight) {
        deepest = std::max(deepest, p.overlap);
        if (weight > 0.0)
            points.push_back(p);
        else
            between[between_count++] = p;
    });
    if (points.empty()) return apart(call, std::max(tube.gap(), 0.0));
    FeatureSum features(call.pair, deepest);
    for (const FeaturePoint& p : points) features.add(p, 1.0);
    for (std::size_t k = 0; k < between_count; ++k) features.add(between[k], -1.0);
    return contact_force(features, 0.5 * a.equivalent_diameter, call.law, call.dt,
                         call.memory.history);
}

/// The part of a solid rod that a body can reach, as a convex shape without rounding.
PairContact at_rod(const ConvexShape& a, const CylinderWall& wall, const CoreCall& call) {
    const Vec3 axis = body_axis(call.pair.j.orientation);
    const AxialPoint c = axial_point(-call.pair.displacement, axis);
    const double clear = std::max(c.r - wall.radius, wall.beyond_end(c.z)) - a.bounding_radius;
    if (clear > 0.0) return apart(call, clear);
    const double reach = 2.0 * a.bounding_radius;
    const double low = wall.is_endless() ? c.z - reach : std::max(0.0, c.z - reach);
    const double high = wall.is_endless() ? c.z + reach : std::min(wall.length, c.z + reach);
    ConvexShape rod;
    rod.core = ConvexShape::Core::cylinder;
    rod.size = Vec3(wall.radius, wall.radius, high - low);
    rod.low = low;
    rod.bounding_radius = math::hypot(wall.radius, std::max(std::abs(low), std::abs(high)));
    const PlacedCore i(a, call.pair.i.orientation, Vec3::Zero());
    const PlacedCore j(rod, call.pair.j.orientation, call.pair.displacement);
    return core_contact(i, j, {a.equivalent_diameter, infinite}, call);
}

}  // namespace

PairContact collide(const ConvexShape& a, const PlaneWall& wall, const CoreCall& call) {
    const PairState& pair = call.pair;
    ConvexHistory& history = call.memory.history;
    const PlaneField plane{{0.0}, {pair.displacement, body_axis(pair.j.orientation)}, wall.radius};
    const double height = plane.distance(Vec3::Zero());
    if (height > a.bounding_radius) return apart(call, height - a.bounding_radius);
    if (plane.lets_pass(Vec3::Zero())) return apart(call, -height);
    const PlacedCore core(a, pair.i.orientation, Vec3::Zero());
    const CorePoint lowest = core.support(-plane.frame.axis, history.search.a[0].vertex);
    const double deepest = a.rounding - plane.distance(lowest.position);
    if (!(deepest > 0.0)) return apart(call, -deepest);
    FeatureSum features(pair, deepest);
    PlaneFeatures(core, plane, features).add_all(lowest.vertex, *call.scratch.features);
    if (features.empty()) return apart(call, 0.0);
    PairContact contact =
        contact_force(features, 0.5 * a.equivalent_diameter, call.law, call.dt, history);
    history.search.a[0].vertex = lowest.vertex;
    return contact;
}

PairContact collide(const ConvexShape& a, const CylinderWall& wall, const CoreCall& call) {
    return wall.inside ? in_tube(a, wall, call) : at_rod(a, wall, call);
}

}  // namespace dem::runtime
