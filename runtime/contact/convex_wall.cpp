// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/convex_wall.hpp"

#include "runtime/contact/convex_pair.hpp"
#include "runtime/contact/wall_frame.hpp"

#include <algorithm>
#include <limits>

namespace dem {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// ---- A plane, or a disc.

struct Plane {
    Vec3 origin, normal;
    double radius;

    double height(const Vec3& x) const { return (x - origin).dot(normal); }
    bool accepts(const Vec3& x) const {
        return std::isinf(radius) || axial_point(x - origin, normal).r <= radius;
    }
};

class PlaneFeatures {
  public:
    PlaneFeatures(const PlacedCore& core, const Plane& plane, FeatureSum& features)
        : core_(core), plane_(plane), features_(features) {}

    void add_all(std::uint32_t lowest, ConvexScratch& scratch) {
        const ConvexShape& shape = core_.shape;
        const Vec3 down = -plane_.normal;
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
        const double overlap = core_.rounding - plane_.height(x);
        return {x - (core_.rounding - 0.5 * overlap) * plane_.normal, plane_.normal, overlap};
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
    const Plane& plane_;
    FeatureSum& features_;
};

// ---- The inside of a cylinder.

/// A convex curve's support function in the plane across the axis of a tube: of an ellipsoid, or of
/// a flat end. The places farthest from the axis are the maxima of F(e) = e . x(e), x support point
/// of the unit direction e, and F' = e' . x(e).
template <class Support>
class TubeMaxima {
  public:
    TubeMaxima(const Support& support, const Vec3& e1, const Vec3& e2)
        : support_(support), e1_(e1), e2_(e2), axis_(e1.cross(e2)) {}

    struct Maximum {
        double value;
        Vec3 point, direction;
    };
    /// Calls visit(maximum) for each.
    template <class Visit>
    void visit(const Visit& visit) const {
        Vec3 from = direction(0);
        double low = slope(from);
        for (std::size_t k = 1; k <= division; ++k) {
            const Vec3 to = direction(k % division);
            const double high = slope(to);
            if (low >= 0.0 && high < 0.0) visit(between(from, to, low, high));
            from = to;
            low = high;
        }
    }

  private:
    static constexpr std::size_t division = PlacedCap::sample_count;

    Vec3 direction(std::size_t k) const {
        const Vec2 u = PlacedCap::sample_direction(k);
        return u.x() * e1_ + u.y() * e2_;
    }
    double slope(const Vec3& e) const { return axis_.cross(e).dot(support_(e)); }
    /// The root of the slope on the way t from one direction to the other: secants within the
    /// bracket, halved when they gain little.
    Maximum between(const Vec3& from, const Vec3& to, double low, double high) const {
        double begin = 0.0;
        double end = 1.0;
        for (int k = 0; k < 60 && end - begin > 1e-13; ++k) {
            double t = begin + (end - begin) * low / (low - high);
            if (k % 3 == 2) t = 0.5 * (begin + end);
            const double s = slope((from + t * (to - from)).normalized());
            if (s == 0.0) {
                begin = end = t;
            } else if (s > 0.0) {
                begin = t;
                low = s;
            } else {
                end = t;
                high = s;
            }
        }
        const Vec3 e = (from + 0.5 * (begin + end) * (to - from)).normalized();
        const Vec3 x = support_(e);
        return {e.dot(x), x, e};
    }

    const Support& support_;
    Vec3 e1_, e2_, axis_;
};

class TubeFeatures {
  public:
    TubeFeatures(const PlacedCore& core, const CylinderWall& wall, const Vec3& axis,
                 const PairState& pair)
        : core_(core), wall_(wall), axis_(axis), origin_(pair.displacement) {}

    /// Calls visit(feature, weight) for every feature; gap() is known afterwards.
    template <class Visit>
    void visit(const Visit& visit) {
        if (core_.has_vertices()) {
            for (std::uint32_t v = 0; v < core_.shape.vertices.size(); ++v)
                visit_point(core_.vertex(v), visit);
            return;
        }
        const Vec3 e1 = axis_.unitOrthogonal();
        const Vec3 e2 = axis_.cross(e1);
        const PlacedCaps caps = caps_of(core_);
        for (std::size_t k = 0; k < caps.count; ++k) {
            const PlacedCap& cap = caps.cap[k];
            const double r = axial_point(cap.center - origin_, axis_).r;
            const double clear = wall_.radius - r - cap.radius - core_.rounding;
            gap_ = std::min(gap_, clear);
            if (clear > 0.0) continue;
            visit_maxima([&](const Vec3& e) { return Vec3(cap.support(e, 0).position - origin_); },
                         e1, e2, visit);
        }
        if (core_.shape.core == ConvexShape::Core::cone)
            visit_point(core_.place({0.0, 0.0, core_.shape.low + core_.shape.size.z}), visit);
        if (caps.count == 0) {
            visit_maxima(
                [&](const Vec3& e) { return Vec3(core_.support(e, 0).position - origin_); }, e1, e2,
                visit);
        }
    }
    double gap() const { return gap_; }

  private:
    template <class Visit>
    void visit_point(const Vec3& x, const Visit& visit) {
        const AxialPoint p = axial_point(x - origin_, axis_);
        add(x, p.radial, p.r, p.z, visit);
    }
    template <class Support, class Visit>
    void visit_maxima(const Support& support, const Vec3& e1, const Vec3& e2, const Visit& visit) {
        TubeMaxima<Support>(support, e1, e2).visit([&](const auto& m) {
            add(origin_ + m.point, m.direction, m.value, m.point.dot(axis_), visit);
        });
    }
    template <class Visit>
    void add(const Vec3& x, const Vec3& outward, double r, double z, const Visit& visit) {
        const double overlap = r + core_.rounding - wall_.radius;
        gap_ = std::min(gap_, -overlap);
        if (!(overlap > 0.0)) return;
        if (std::isfinite(wall_.length) && (z < 0.0 || z > wall_.length)) return;
        visit(FeaturePoint{x + (core_.rounding - 0.5 * overlap) * outward, -outward, overlap});
    }

    const PlacedCore& core_;
    const CylinderWall& wall_;
    Vec3 axis_, origin_;
    double gap_ = infinite;
};

PairContact in_tube(const ConvexShape& a, const CylinderWall& wall, const ConvexCall& call) {
    const Vec3 axis = body_axis(call.pair.j.orientation);
    const AxialPoint c = axial_point(-call.pair.displacement, axis);
    const double clear = wall.radius - c.r - a.bounding_radius;
    if (clear > 0.0) return keep_apart(call.memory, clear);
    const PlacedCore core(a, call.pair.i.orientation, Vec3::Zero());
    TubeFeatures tube(core, wall, axis, call.pair);
    std::vector<FeaturePoint>& points = call.memory.scratch.points;
    points.clear();
    double deepest = 0.0;
    tube.visit([&](const FeaturePoint& p) {
        deepest = std::max(deepest, p.overlap);
        points.push_back(p);
    });
    if (points.empty()) return keep_apart(call.memory, std::max(tube.gap(), 0.0));
    FeatureSum features(call.pair, deepest);
    for (const FeaturePoint& p : points) features.add(p, 1.0);
    return contact_force(features, 0.5 * a.equivalent_diameter, call.law, call.dt,
                         call.memory.history);
}

/// The part of a solid rod that a body can reach, as a convex shape without rounding.
PairContact at_rod(const ConvexShape& a, const CylinderWall& wall, const ConvexCall& call) {
    const Vec3 axis = body_axis(call.pair.j.orientation);
    const AxialPoint c = axial_point(-call.pair.displacement, axis);
    const double beyond_end =
        std::isinf(wall.length) ? -infinite : std::max(-c.z, c.z - wall.length);
    const double clear = std::max(c.r - wall.radius, beyond_end) - a.bounding_radius;
    if (clear > 0.0) return keep_apart(call.memory, clear);
    const double reach = 2.0 * a.bounding_radius;
    const bool is_endless = std::isinf(wall.length);
    const double low = is_endless ? c.z - reach : std::max(0.0, c.z - reach);
    const double high = is_endless ? c.z + reach : std::min(wall.length, c.z + reach);
    ConvexShape rod;
    rod.core = ConvexShape::Core::cylinder;
    rod.size = Vec3(wall.radius, wall.radius, high - low);
    rod.low = low;
    rod.bounding_radius = std::hypot(wall.radius, std::max(std::abs(low), std::abs(high)));
    const PlacedCore i(a, call.pair.i.orientation, Vec3::Zero());
    const PlacedCore j(rod, call.pair.j.orientation, call.pair.displacement);
    return core_contact(i, j, {a.equivalent_diameter, infinite}, call);
}

}  // namespace

PairContact collide(const ConvexShape& a, const PlaneWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    const Plane plane{pair.displacement, body_axis(pair.j.orientation), wall.radius};
    const double height = plane.height(Vec3::Zero());
    if (height > a.bounding_radius) return keep_apart(memory, height - a.bounding_radius);
    if (std::isfinite(wall.radius) && height < 0.0) return keep_apart(memory, -height);
    const PlacedCore core(a, pair.i.orientation, Vec3::Zero());
    const CorePoint lowest = core.support(-plane.normal, memory.history.search.a[0].vertex);
    const double deepest = a.rounding - plane.height(lowest.position);
    if (!(deepest > 0.0)) return keep_apart(memory, -deepest);
    FeatureSum features(pair, deepest);
    PlaneFeatures(core, plane, features).add_all(lowest.vertex, memory.scratch);
    if (features.empty()) return keep_apart(memory, 0.0);
    PairContact contact =
        contact_force(features, 0.5 * a.equivalent_diameter, law, dt, memory.history);
    memory.history.search.a[0].vertex = lowest.vertex;
    return contact;
}

PairContact collide(const ConvexShape& a, const CylinderWall& wall, const PairState& pair,
                    const ContactLaw& law, double dt, const ConvexMemory& memory) {
    const ConvexCall call{pair, law, dt, memory};
    return wall.inside ? in_tube(a, wall, call) : at_rod(a, wall, call);
}

}  // namespace dem
