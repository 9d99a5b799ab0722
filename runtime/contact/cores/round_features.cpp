// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/round_features.hpp"

#include "common/math/elementary.hpp"
#include "runtime/contact/cores/rim_crossings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

/// cos and sin of the angles of the samples.
struct SampleCircle {
    std::array<double, PlacedCap::sample_count> cosine, sine;

    SampleCircle() {
        for (std::size_t k = 0; k < cosine.size(); ++k) {
            const double angle = 2.0 * pi * static_cast<double>(k) / PlacedCap::sample_count;
            cosine[k] = math::cos(angle);
            sine[k] = math::sin(angle);
        }
    }
};
const SampleCircle sample_circle;

/// One body of the pair with what the features of the other need to know.
struct Body {
    const PlacedCore& core;
    const ConvexCap& side;
    double sign;    ///< 1: i, -1: j
    Vec3 towards;   ///< unit, to the other body
    double extent;  ///< of the core along it, from the origin of the pair [m]
    NearEnds& ends;
};

/// What the history says about the ends of a pair, or is to say.
struct EndSearch {
    bool is_known;  ///< of all ends and samples
    double room;    ///< otherwise: what comes within this of touching is to be known [m]
};

/// Overlap of a point of one core, rounded, with the other body; all in the frame of the other.
FeaturePoint point_against(const Body& body, const Body& other, bool cores_overlap, const Vec3& x,
                           double beyond = std::numeric_limits<double>::infinity()) {
    const SurfaceDistance d = distance_in_body(other.core, other.side, cores_overlap, x, beyond);
    const double overlap = body.core.rounding + other.core.rounding - d.distance;
    return {x - (body.core.rounding - 0.5 * overlap) * d.normal, body.sign * d.normal, overlap};
}

FeaturePoint from_body(const PlacedCore& core, const FeaturePoint& p) {
    return {core.place(p.position), core.turned(p.normal), p.overlap};
}

/// An end of one body in the frame of another.
PlacedCap seen_from(const PlacedCore& core, const PlacedCap& cap) {
    return {core.in_body(cap.center),
            core.direction_in_body(cap.axis),
            cap.radius,
            cap.size,
            cap.rounding,
            core.direction_in_body(cap.across)};
}

/// Second derivative of the distance from a core at x along a unit direction [1/m]; `away` its
/// gradient. Zero, a lower bound, of other cores than cylinders.
double bend(const ConvexShape& core, const Vec3& x, const Vec3& away, double distance,
            const Vec3& along) {
    const double r = std::sqrt(square(x.x()) + square(x.y()));
    if (core.core != ConvexShape::Core::cylinder || r == 0.0) return 0.0;
    const Vec3 around(-x.y() / r, x.x() / r, 0.0);
    const double away_r = (away.x() * x.x() + away.y() * x.y()) / r;
    double second = away_r / r * square(along.dot(around));
    const bool is_beyond_rim = away_r > 0.0 && away.z() != 0.0 && distance > 0.0;
    if (is_beyond_rim) second += square(along.dot(away.cross(around))) / distance;
    return second;
}

/// Where the rim of an end is nearest to the other body, downhill from a point of the rim: the root
/// of the derivative by the angle, by the secant method within a bracket once there is one. A step
/// to a place that is farther away has left the valley and ends the bracket. Angles are held as the
/// tangent u of their half, which spares sines. All in the frame of the other body.
FeaturePoint deepest_of_rim(const PlacedCap& cap, const Vec3& start, const Body& body,
                            const Body& other) {
    const Vec3 across = cap.axis.cross(start);
    const double rounding_error = 1e-15 * cap.size;
    const double reach = body.core.rounding + other.core.rounding;
    double low = -std::numeric_limits<double>::infinity();  // where the slope was last seen < 0
    double high = -low;                                     // and > 0
    double u = 0.0;
    double best_u = 0.0;
    double best_slope = 0.0;
    FeaturePoint best{};
    for (int k = 0; k < 40; ++k) {
        const double scale = 1.0 / (1.0 + u * u);
        const double c = (1.0 - u * u) * scale;
        const double s = 2.0 * u * scale;
        const Vec3 m = c * start + s * across;
        const Vec3 x = cap.center + cap.radius * m;
        const FeaturePoint p = point_against(body, other, false, x);
        if (k > 0 && p.overlap < best.overlap - rounding_error) {
            (u < best_u ? low : high) = u;
            u = 0.5 * (u + best_u);
            if (std::abs(u - best_u) <= 1e-13) break;
            continue;
        }
        const Vec3 away = body.sign * p.normal;
        const Vec3 along = c * across - s * start;
        const double slope = away.dot(along);
        (slope < 0.0 ? low : high) = u;
        double curvature = 0.0;
        if (k > 0) {
            curvature = (slope - best_slope) / (u - best_u);
        } else {
            const double distance = reach - p.overlap;
            const double by_angle =
                cap.radius * bend(other.core.shape, x, away, distance, along) - away.dot(m);
            curvature = 2.0 * scale * std::max(by_angle, 2.0 * std::abs(slope));
        }
        best = p;
        best_u = u;
        best_slope = slope;
        // The distance is then known to the square of it.
        if (std::abs(slope) <= 1e-9) break;
        const double most = 0.25 / scale;
        const double step = curvature > 0.0 ? std::clamp(-slope / curvature, -most, most)
                                            : -std::copysign(most, slope);
        u += step;
        if (u <= low || u >= high) u = 0.5 * (low + high);
        if (std::abs(u - best_u) <= 1e-13) break;
    }
    return best;
}

/// The deepest point of an end: where the other body reaches lowest, if that is above the end, else
/// on the rim. `seen`: the end as seen from there. `on_core`: the nearest point of the whole core.
FeaturePoint deepest_of_cap(const PlacedCap& cap, const PlacedCap& seen, const Vec3& on_core,
                            const Body& body, const Body& other) {
    const Vec3 lowest = other.core.support(-cap.axis, 0).position - cap.center;
    const double height = lowest.dot(cap.axis);
    const Vec3 foot = lowest - height * cap.axis;
    if (height > 0.0 && foot.squaredNorm() < square(cap.radius)) {
        const double overlap = body.core.rounding + other.core.rounding - height;
        return {cap.center + foot + (body.core.rounding - 0.5 * overlap) * cap.axis,
                -body.sign * cap.axis, overlap};
    }
    const Vec3 from_center = on_core - cap.center;
    const double above = from_center.dot(cap.axis);
    Vec3 radial = from_center - above * cap.axis;
    if (std::abs(above) > 0.01 * body.core.size)
        radial = body.towards - body.towards.dot(cap.axis) * cap.axis;
    if (!(radial.norm() > 1e-9 * body.core.size)) radial = cap.axis.unitOrthogonal();
    radial.normalize();
    radial -= radial.dot(cap.axis) * cap.axis;  // what rounding has left of it
    const Vec3 start = other.core.direction_in_body(radial);
    return from_body(other.core, deepest_of_rim(seen, start, body, other));
}

/// Whether no point of an end comes within `room` of the other body. Those that can lie on the disc
/// above the height `least` along `towards`, which leaves of it a segment around its highest point.
bool is_out_of_reach(const PlacedCap& cap, double least, double room, const Body& body,
                     const Body& other, const NearCores& near) {
    const Vec3 highest = cap.support(body.towards, 0).position;
    const double height = highest.dot(body.towards) - least;
    if (height < 0.0) return true;
    const double sine = body.towards.cross(cap.axis).norm();
    if (near.cores_overlap || !(height < sine * cap.radius)) return false;
    // From the highest point to where the rim, turned by phi, sinks below:
    //     2 R sin(phi / 2),  height = sine R (1 - cos phi)
    const double segment = std::sqrt(2.0 * cap.radius * height / sine);
    const double reach = body.core.rounding + other.core.rounding + room + segment;
    // Farther than the features of a pair ever are: what is nearest may lie outside of the cap.
    const Vec3 x = other.core.in_body(highest);
    return core_distance(other.core.shape, x, reach).distance >= reach;
}

/// Bits of the samples above a height along `towards`.
std::uint32_t samples_above(const PlacedCap& cap, double least, const Vec3& towards) {
    const double middle = cap.center.dot(towards);
    const double along = cap.radius * cap.across.dot(towards);
    const double beside = cap.radius * cap.axis.cross(cap.across).dot(towards);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < PlacedCap::sample_count; ++k) {
        const Vec2 direction = PlacedCap::sample_direction(k);
        const bool is_above = middle + direction.x() * along + direction.y() * beside >= least;
        bits |= std::uint32_t{is_above} << k;
    }
    return bits;
}

/// Adds the samples that overlap, of those that can.
void add_samples(const PlacedCap& cap, const PlacedCap& seen, double least, const Body& body,
                 const Body& other, bool cores_overlap, const EndSearch& search, NearEnd& end,
                 FeatureSum& samples) {
    const double reach = body.core.rounding + other.core.rounding + search.room;
    std::uint32_t bits = search.is_known ? end.samples : samples_above(cap, least, body.towards);
    std::uint32_t near = 0;
    for (; bits != 0; bits &= bits - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(bits));
        const FeaturePoint p = point_against(body, other, cores_overlap, seen.sample(k), reach);
        if (p.overlap > 0.0) samples.add(from_body(other.core, p), rim_sample_weight);
        if (p.overlap > -search.room) near |= 1U << k;
    }
    if (!search.is_known) end.samples = static_cast<std::uint16_t>(near);
}

void add_cap(const PlacedCap& cap, const Body& body, const Body& other, const NearCores& near,
             const FeaturePoint& deepest, const EndSearch& search, NearEnd& end,
             FeatureSum& features) {
    const double least = body.extent - near.deepest - search.room;
    if (!search.is_known)
        end.can_touch = is_out_of_reach(cap, least, search.room, body, other, near) ? 0 : 1;
    if (end.can_touch == 0) return;
    const PlacedCap seen = seen_from(other.core, cap);
    FeatureSum samples(features.pair(), features.deepest());
    add_samples(cap, seen, least, body, other, near.cores_overlap, search, end, samples);
    const Vec3 on_core = deepest.position +
                         body.sign * (body.core.rounding - 0.5 * deepest.overlap) * deepest.normal;
    if (near.cores_overlap) {
        const bool is_here =
            std::abs((on_core - cap.center).dot(cap.axis)) <= 1e-9 * body.core.size;
        if (is_here) add_blended(deepest, 1.0, samples, features);
        return;
    }
    // Corners of the patch count beside the samples: where the deepest point jumps from one to
    // another, they carry.
    const RimCrossings crossings(cap, other.core, other.sign);
    for (const EdgeLine& edge : other.side.lines) crossings.add(edge, samples);
    // Where they carry alone, the deepest point of the end would not change a thing.
    if (samples.power() >= 1.5) {
        features.add(samples, 1.0);
    } else {
        add_blended(deepest_of_cap(cap, seen, on_core, body, other), 1.0, samples, features);
    }
}

void add_tip(const Body& body, const Body& other, const NearCores& near, FeatureSum& features) {
    const ConvexShape& shape = body.core.shape;
    const Vec3 tip = body.core.place({0.0, 0.0, shape.low + shape.size.z});
    if (tip.dot(body.towards) < body.extent - near.deepest) return;
    const FeaturePoint p = point_against(body, other, near.cores_overlap, other.core.in_body(tip));
    if (p.overlap > 0.0) features.add(from_body(other.core, p), 1.0);
}

/// The axis of a cylinder as an edge that is as thick as the cylinder.
void list_axis(const PlacedCore& core, ConvexCap& cap) {
    cap.vertices.clear();
    cap.edges.clear();
    cap.faces.clear();
    cap.lines.clear();
    const ConvexShape& shape = core.shape;
    if (shape.core != ConvexShape::Core::cylinder || shape.size.z == 0.0) return;
    const double half = 0.5 * shape.size.z;
    cap.lines.push_back({core.place({0.0, 0.0, shape.low}), core.turned(Vec3::UnitZ()),
                         shape.size.z, std::min(edge_ramp * core.size, half),
                         core.place({0.0, 0.0, shape.low + half}), half});
}

/// What of a core can touch. The end of a cylinder can lie above an edge of a face that is far
/// away, so that all edges count.
void list_cap(const PlacedCore& core, const Vec3& direction, double depth, std::uint32_t start,
              ConvexCap& cap) {
    if (!core.has_vertices()) {
        list_axis(core, cap);
        return;
    }
    collect_cap(core, direction, depth, start, cap);
    list_faces(core, cap);
    list_lines(core, cap);
}

void add_body(const Body& body, const Body& other, const NearCores& near,
              const FeaturePoint& deepest, const EndSearch& search, FeatureSum& features) {
    if (body.core.has_vertices()) {
        for (const ConvexCap::Vertex& v : body.side.vertices)
            add_vertex(body.core, v.number, {other.core, other.side}, near, body.sign, features);
        return;
    }
    const PlacedCaps caps = caps_of(body.core);
    for (std::size_t k = 0; k < caps.count; ++k)
        add_cap(caps.cap[k], body, other, near, deepest, search, body.ends[k], features);
    if (body.core.shape.core == ConvexShape::Core::cone) add_tip(body, other, near, features);
}

Body body_of(const PlacedCore& core, const ConvexCap& side, const Vec3& towards, double sign,
             NearEnds& ends) {
    return {core, side, sign, towards, core.support(towards, 0).position.dot(towards), ends};
}

}  // namespace

Vec2 PlacedCap::sample_direction(std::size_t k) {
    return {sample_circle.cosine[k], sample_circle.sine[k]};
}

Vec3 PlacedCap::sample(std::size_t k) const {
    return center +
           radius * (sample_circle.cosine[k] * across + sample_circle.sine[k] * axis.cross(across));
}

PlacedCaps caps_of(const PlacedCore& core) {
    const ConvexShape& shape = core.shape;
    PlacedCaps caps;
    const Vec3 axis = core.turned(Vec3::UnitZ());
    const Vec3 across = core.turned(Vec3::UnitX());
    const bool is_cylinder = shape.core == ConvexShape::Core::cylinder;
    if (!is_cylinder && shape.core != ConvexShape::Core::cone) return caps;
    const auto add = [&](double z, const Vec3& outward) {
        caps.cap[caps.count++] = {
            core.place({0.0, 0.0, z}), outward, shape.size.x, core.size, core.rounding, across};
    };
    add(shape.low, -axis);
    if (is_cylinder && shape.size.z > 0.0) add(shape.low + shape.size.z, axis);
    return caps;
}

void add_round(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
               const FeaturePoint& deepest, const CoreCall& call, FeatureSum& features) {
    ConvexScratch& scratch = *call.scratch.features;
    ConvexHistory& history = call.memory.history;
    // Of cores that overlap distances are signed, and other points come into play.
    if (near.cores_overlap) history.leash.room = 0.0;
    const bool is_known = history.leash.room > 0.0;
    const double room = near.cores_overlap || is_known ? 0.0 : leash_room(i, j);
    const EndSearch search{is_known, room};
    // The same faces with and without a leash: no bit is to depend on it.
    const double depth = near.deepest + (near.cores_overlap ? 0.0 : leash_room(i, j));
    list_cap(i, -near.normal, depth, near.i.vertex[0], scratch.i);
    list_cap(j, near.normal, depth, near.j.vertex[0], scratch.j);
    const Body body_i = body_of(i, scratch.i, -near.normal, 1.0, history.ends_of_i);
    const Body body_j = body_of(j, scratch.j, near.normal, -1.0, history.ends_of_j);
    FeatureSum others(features.pair(), features.deepest());
    add_body(body_i, body_j, near, deepest, search, others);
    add_body(body_j, body_i, near, deepest, search, others);
    if (room > 0.0) history.leash = leash_at(features.pair(), room);
    if (!near.cores_overlap) add_edges(scratch, near, line_thickness(i), line_thickness(j), others);
    add_remaining(deepest, others, features);
}

}  // namespace dem::runtime
