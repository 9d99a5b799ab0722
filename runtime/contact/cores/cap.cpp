// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/cap.hpp"

#include <algorithm>
#include <limits>

namespace dem::runtime {

namespace {

using Index = std::uint32_t;

/// The part of an edge that lies in the cap, from its end there on.
ConvexCap::ClippedEdge clipped(const ConvexShape& shape, Index edge, const Vec3& inside,
                               const Vec3& other, double share) {
    const double half = 0.5 * share;
    return {edge, inside + half * (other - inside), half * shape.edges[edge].length};
}

EdgeLine clipped_line(const PlacedCore& core, const ConvexCap::ClippedEdge& clip) {
    EdgeLine line = line_of(core, clip.number);
    line.middle = core.place(clip.middle);
    line.half = clip.half;
    return line;
}

/// Spreads from the farthest vertex. Calls visit(vertex, edge, other vertex) for every edge with an
/// end in the cap, once for each.
template <class Visit>
void spread(const PlacedCore& core, const Vec3& direction, double depth, Index start,
            ConvexCap& cap, const Visit& visit) {
    const ConvexShape& shape = core.shape;
    const Vec3 along = core.direction_in_body(direction);
    start = farthest_vertex(shape, along, start);
    const double farthest = shape.vertices[start].dot(along);
    cap.marks.clear(shape.vertices.size());
    cap.marks.add(start);
    cap.vertices.assign(1, {start, 0.0});
    for (std::size_t k = 0; k < cap.vertices.size(); ++k) {
        const ConvexCap::Vertex v = cap.vertices[k];
        const Index end = shape.neighbor_begin[v.number + 1];
        for (Index n = shape.neighbor_begin[v.number]; n < end; ++n) {
            const Index other = shape.neighbors[n];
            const double behind = farthest - shape.vertices[other].dot(along);
            if (behind < depth && cap.marks.add(other)) cap.vertices.push_back({other, behind});
            visit(v, shape.neighbor_edges[n], ConvexCap::Vertex{other, behind});
        }
    }
}

}  // namespace

void collect_vertices(const PlacedCore& core, const Vec3& direction, double depth, Index start,
                      ConvexCap& cap) {
    spread(core, direction, depth, start, cap, [](const auto&, Index, const auto&) {});
}

void collect_cap(const PlacedCore& core, const Vec3& direction, double depth, Index start,
                 ConvexCap& cap) {
    const ConvexShape& shape = core.shape;
    cap.edges.clear();
    Vec3 low = Vec3::Constant(infinite);
    Vec3 high = -low;
    const auto include = [&](const Vec3& x) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    };
    spread(core, direction, depth, start, cap, [&](const auto& v, Index edge, const auto& other) {
        const Vec3& x = shape.vertices[v.number];
        const Vec3& y = shape.vertices[other.number];
        if (other.behind < depth) {
            // Met twice.
            if (other.number < v.number) return;
            cap.edges.push_back(clipped(shape, edge, x, y, 1.0));
            include(x);
            include(y);
        } else {
            const double share = (depth - v.behind) / (other.behind - v.behind);
            cap.edges.push_back(clipped(shape, edge, x, y, share));
            include(x);
            include(x + share * (y - x));
        }
    });
    // Rounding of the clipping.
    const double radius = 0.5 * (high - low).norm() + 1e-12 * core.size;
    cap.ball = {core.place(0.5 * (low + high)), radius};
}

EdgeLine line_of(const PlacedCore& core, Index edge) {
    const ConvexShape::Edge& e = core.shape.edges[edge];
    return {core.vertex(e.from),
            core.turned(e.direction),
            e.length,
            std::min(edge_ramp * core.size, 0.5 * e.length),
            Vec3::Zero(),
            0.0};
}

void list_faces(const PlacedCore& core, ConvexCap& cap) {
    cap.faces.clear();
    cap.marks.clear(core.shape.face_count());
    for (const ConvexCap::ClippedEdge& e : cap.edges) {
        const ConvexShape::Edge& edge = core.shape.edges[e.number];
        if (edge.left == ConvexShape::Edge::no_face) continue;
        if (cap.marks.add(edge.left)) cap.faces.push_back(edge.left);
        if (cap.marks.add(edge.right)) cap.faces.push_back(edge.right);
    }
}

void list_lines(const PlacedCore& core, const CapBall& ball, double reach, ConvexCap& cap) {
    const CapBall in_body{core.in_body(ball.center), ball.radius};
    cap.lines.clear();
    for (const ConvexCap::ClippedEdge& e : cap.edges)
        if (in_body.meets(e.middle, e.half + reach)) cap.lines.push_back(clipped_line(core, e));
}

void list_lines(const PlacedCore& core, ConvexCap& cap) {
    cap.lines.clear();
    for (const ConvexCap::ClippedEdge& e : cap.edges) cap.lines.push_back(clipped_line(core, e));
}

}  // namespace dem::runtime
