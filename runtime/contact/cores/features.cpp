// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/features.hpp"

namespace dem::runtime {

namespace {

/// Nearest points of two edges' lines.
struct EdgePair {
    const EdgeLine& a;
    const EdgeLine& b;
    double cosine;
    double sine2;
    double t, u;  ///< places along the edges [m]
    Vec3 gap;     ///< from the point on b to that on a [m]
};

/// Derivative of the weight s(t) s(u) s(sine2) (docs/contact-convex.md, "Edges").
PairGradient weight_gradient(const EdgePair& e, const Ramp& at_t, const Ramp& at_u,
                             const Ramp& crossing, const Vec3& displacement) {
    const double by_t = at_t.slope * at_u.value * crossing.value;
    const double by_u = at_t.value * at_u.slope * crossing.value;
    const double by_sine2 = at_t.value * at_u.value * crossing.slope / parallel_sine2;
    const double alpha = (by_t + e.cosine * by_u) / e.sine2;
    const double beta = -(e.cosine * by_t + by_u) / e.sine2;
    const Vec3& dir_a = e.a.direction;
    const Vec3& dir_b = e.b.direction;
    const Vec3 on_a = e.a.start + e.t * dir_a;
    const Vec3 on_b = e.b.start + e.u * dir_b - displacement;
    const Vec3 across = dir_a.cross(dir_b);
    PairGradient g;
    g.shift = -alpha * dir_a - beta * dir_b;
    g.turn_i = on_a.cross(g.shift) - alpha * dir_a.cross(e.gap) +
               2.0 * by_sine2 * dir_a.cross(dir_b.cross(across));
    g.turn_j = -on_b.cross(g.shift) - beta * dir_b.cross(e.gap) +
               2.0 * by_sine2 * dir_b.cross(across.cross(dir_a));
    return g;
}

void add_edge_pair(const EdgePair& e, const NearCores& near, double rounding_i, double reach,
                   FeatureSum& features) {
    const double distance = e.gap.norm();
    const bool is_behind = e.gap.dot(near.normal) < 0.0;
    if (is_behind && !near.cores_overlap) return;
    const double overlap = is_behind ? reach + distance : reach - distance;
    if (!(overlap > 0.0) || distance == 0.0) return;
    // Edges that have passed through the other body on its far side.
    if (is_behind && overlap > (1.0 + 1e-6) * near.deepest) return;
    const Vec3 n = (is_behind ? -1.0 : 1.0) / distance * e.gap;
    const Ramp at_t = end_ramp(e.a, e.t);
    const Ramp at_u = end_ramp(e.b, e.u);
    const Ramp crossing(e.sine2 / parallel_sine2);
    const Vec3 on_a = e.a.start + e.t * e.a.direction;
    const FeaturePoint p{on_a - (rounding_i - 0.5 * overlap) * n, n, overlap};
    features.add(p, at_t.value * at_u.value * crossing.value);
    if (at_t.slope != 0.0 || at_u.slope != 0.0 || crossing.slope != 0.0) {
        features.add_weight_gradient(
            p, weight_gradient(e, at_t, at_u, crossing, features.pair().displacement));
    }
}

}  // namespace

Ramp end_ramp(const EdgeLine& edge, double t) {
    const Ramp low(t / edge.ramp);
    const Ramp high((edge.length - t) / edge.ramp);
    return {low.value * high.value, (low.slope * high.value - low.value * high.slope) / edge.ramp};
}

SurfaceDistance distance_in_body(const PlacedCore& core, const ConvexCap& cap, bool cores_overlap,
                                 const Vec3& x, double beyond) {
    return core.has_vertices() && !cores_overlap
               ? distance_from_faces(core.shape, cap.faces, x, beyond)
               : core_distance(core.shape, x, beyond);
}

SurfaceDistance distance_to(const PlacedCore& core, const ConvexCap& cap, bool cores_overlap,
                            const Vec3& x, double beyond) {
    SurfaceDistance d = distance_in_body(core, cap, cores_overlap, core.in_body(x), beyond);
    d.normal = core.turned(d.normal);
    return d;
}

void add_vertex(const PlacedCore& core, std::uint32_t vertex, const CappedCore& other,
                const NearCores& near, double sign, FeatureSum& features) {
    const double reach = core.rounding + other.core.rounding;
    const Vec3 x = core.vertex(vertex);
    const SurfaceDistance d = distance_to(other.core, other.cap, near.cores_overlap, x, reach);
    add_vertex_at(core, x, other.core, d, sign, features);
}

void add_vertex_at(const PlacedCore& core, const Vec3& x, const PlacedCore& other,
                   const SurfaceDistance& distance, double sign, FeatureSum& features) {
    const double overlap = core.rounding + other.rounding - distance.distance;
    if (!(overlap > 0.0)) return;
    const Vec3 position = x - (core.rounding - 0.5 * overlap) * distance.normal;
    features.add({position, sign * distance.normal, overlap}, 1.0);
}

void add_line_pair(const EdgeLine& a, const EdgeLine& b, const NearCores& near, double rounding_i,
                   double rounding_j, FeatureSum& features) {
    const double reach = rounding_i + rounding_j;
    const Vec3 between = a.start - b.start;
    const double cosine = a.direction.dot(b.direction);
    const double sine2 = 1.0 - cosine * cosine;
    if (sine2 < least_sine2) return;
    const double along_a = a.direction.dot(between);
    const double along_b = b.direction.dot(between);
    const double t = (cosine * along_b - along_a) / sine2;
    if (!(t > 0.0 && t < a.length)) return;
    const double u = (along_b - cosine * along_a) / sine2;
    if (!(u > 0.0 && u < b.length)) return;
    const Vec3 gap = between + t * a.direction - u * b.direction;
    if (gap.squaredNorm() >= reach * reach) return;
    add_edge_pair({a, b, cosine, sine2, t, u, gap}, near, rounding_i, reach, features);
}

void add_edges(const ConvexScratch& scratch, const NearCores& near, double rounding_i,
               double rounding_j, FeatureSum& features) {
    const double reach = rounding_i + rounding_j;
    for (const EdgeLine& a : scratch.i.lines) {
        for (const EdgeLine& b : scratch.j.lines) {
            if ((a.middle - b.middle).squaredNorm() < square(a.half + b.half + reach))
                add_line_pair(a, b, near, rounding_i, rounding_j, features);
        }
    }
}

namespace {

/// Sum over the vertices that can be near the other cap.
void add_vertices(const CappedCore& side, const PlacedCore& other, ConvexCap& other_cap,
                  const NearCores& near, double sign, FeatureSum& features) {
    const double reach = side.core.rounding + other.rounding;
    const CapBall in_body{side.core.in_body(other_cap.ball.center), other_cap.ball.radius};
    bool has_faces = false;
    for (const ConvexCap::Vertex& v : side.cap.vertices) {
        // Of cores that overlap what is nearest to a vertex may lie outside the cap.
        if (!near.cores_overlap && !in_body.meets(side.core.shape.vertices[v.number], reach))
            continue;
        if (!has_faces) list_faces(other, other_cap);
        has_faces = true;
        add_vertex(side.core, v.number, {other, other_cap}, near, sign, features);
    }
}

/// Edges of both caps near the other one, those of the larger cap first: mostly there are none.
bool list_near_lines(const PlacedCore& larger, ConvexCap& large, const PlacedCore& smaller,
                     ConvexCap& small) {
    const double reach = larger.rounding + smaller.rounding;
    list_lines(larger, small.ball, reach, large);
    if (large.lines.empty()) return false;
    list_lines(smaller, large.ball, reach, small);
    return true;
}

}  // namespace

void add_polyhedra(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                   ConvexScratch& scratch, FeatureSum& features) {
    collect_cap(i, -near.normal, near.deepest, near.i.vertex[0], scratch.i);
    collect_cap(j, near.normal, near.deepest, near.j.vertex[0], scratch.j);
    add_vertices({i, scratch.i}, j, scratch.j, near, 1.0, features);
    add_vertices({j, scratch.j}, i, scratch.i, near, -1.0, features);
    const bool has_lines = scratch.i.ball.radius > scratch.j.ball.radius
                               ? list_near_lines(i, scratch.i, j, scratch.j)
                               : list_near_lines(j, scratch.j, i, scratch.i);
    if (has_lines) add_edges(scratch, near, i.rounding, j.rounding, features);
}

}  // namespace dem::runtime
