// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/convex_lone.hpp"

#include <algorithm>
#include <limits>

namespace dem {

namespace {

using Index = std::uint32_t;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// One body of the pair as the cap of the other sees it.
struct Side {
    const PlacedCore& core;
    const NearVertices& near;
    Vec3 towards;  ///< unit, to the other body, body frame
    double sign;   ///< 1: i, -1: j
};

/// How far the edges from a vertex, but those that skip(end) names, reach within the cap [m];
/// without end if one ends in it.
template <class Skip>
double clip_reach(const Side& side, Index vertex, double farthest, double depth, const Skip& skip) {
    const ConvexShape& shape = side.core.shape;
    const double behind = farthest - shape.vertices[vertex].dot(side.towards);
    if (!(behind < depth)) return infinite;
    double reach = 0.0;
    const Index end = shape.neighbor_begin[vertex + 1];
    for (Index n = shape.neighbor_begin[vertex]; n < end; ++n) {
        const Index other = shape.neighbors[n];
        if (skip(other)) continue;
        const double other_behind = farthest - shape.vertices[other].dot(side.towards);
        if (other_behind < depth) return infinite;
        const double share = (depth - behind) / (other_behind - behind);
        reach = std::max(reach, share * shape.edges[shape.neighbor_edges[n]].length);
    }
    return reach;
}

/// Whether a ball about x above the face comes near nothing else of the body: the edges of the face
/// lie `far` from its foot, and those that leave it downwards end sooner.
bool is_well_above(const Side& side, Index face, const Vec3& x, double far, double depth) {
    const ConvexShape& shape = side.core.shape;
    const Index begin = shape.face_begin[face];
    const Index size = shape.face_begin[face + 1] - begin;
    const Vec3& normal = shape.planes[face].normal;
    const auto number = [&](Index k) { return shape.face_vertices[begin + k % size]; };
    double farthest = -infinite;
    for (Index k = 0; k < size; ++k) {
        const Vec3& a = shape.vertices[number(k)];
        const Vec3 along = shape.vertices[number(k + 1)] - a;
        const double inside = normal.cross(along).dot(x - a);
        if (!(inside > 0.0 && square(inside) > square(far) * along.squaredNorm())) return false;
        farthest = std::max(farthest, a.dot(side.towards));
    }
    for (Index k = 0; k < size; ++k) {
        const Index before = number(k + size - 1);
        const Index after = number(k + 1);
        const auto is_of_face = [&](Index v) { return v == before || v == after; };
        const double clip = clip_reach(side, number(k), farthest, depth, is_of_face);
        const Vec3 away = x - shape.vertices[number(k)];
        if (clip == infinite || !(away.squaredNorm() > square(clip + far))) return false;
    }
    return true;
}

/// The face around a vertex that x is highest above.
Index highest_face(const ConvexShape& shape, Index vertex, const Vec3& x, double& height) {
    Index best = 0;
    height = -infinite;
    for (Index n = shape.neighbor_begin[vertex]; n < shape.neighbor_begin[vertex + 1]; ++n) {
        // Of the two faces of each edge one is enough: it is left of one edge from the vertex.
        const ConvexShape::Edge& edge = shape.edges[shape.neighbor_edges[n]];
        const Index face = edge.from == vertex ? edge.left : edge.right;
        const ConvexShape::Plane& plane = shape.planes[face];
        const double h = plane.normal.dot(x) - plane.offset;
        if (h > height) {
            height = h;
            best = face;
        }
    }
    return best;
}

bool add_lone_vertex(const Side& side, const Side& other, const NearCores& near,
                     FeatureSum& features) {
    const double reach = side.core.rounding + other.core.rounding;
    const ConvexShape& shape = other.core.shape;
    if (shape.planes.empty()) return false;
    const Index vertex = side.near.vertex[0];
    const double farthest = side.core.shape.vertices[vertex].dot(side.towards);
    const double clip =
        clip_reach(side, vertex, farthest, near.deepest, [](Index) { return false; });
    if (clip == infinite) return false;
    const Vec3 x = side.core.vertex(vertex);
    const Vec3 x_body = other.core.in_body(x);
    double height = 0.0;
    const Index face = highest_face(shape, other.near.vertex[0], x_body, height);
    if (!(height > 0.0) || !is_well_above(other, face, x_body, clip + reach, near.deepest))
        return false;
    const Vec3 normal = other.core.turned(shape.planes[face].normal);
    add_vertex_at(side.core, x, other.core, {height, normal}, side.sign, features);
    return true;
}

/// The one edge that is the cap of a body, but for how far others reach in from its ends.
struct LoneEdge {
    Index number;
    Vec3 from, to;  ///< relative to the center of i [m]
    double clip;    ///< [m]
};

bool is_lone_edge(const Side& side, double depth, LoneEdge& edge) {
    const ConvexShape& shape = side.core.shape;
    const Index a = side.near.vertex[0];
    const Index b = side.near.vertex[1];
    const Index begin = shape.neighbor_begin[a];
    const Index end = shape.neighbor_begin[a + 1];
    const std::uint32_t* const all = shape.neighbors.data();
    const std::uint32_t* const found = std::find(all + begin, all + end, b);
    if (found == all + end) return false;
    edge.number = shape.neighbor_edges[static_cast<std::size_t>(found - all)];
    const double farthest =
        std::max(shape.vertices[a].dot(side.towards), shape.vertices[b].dot(side.towards));
    edge.clip = std::max(clip_reach(side, a, farthest, depth, [b](Index v) { return v == b; }),
                         clip_reach(side, b, farthest, depth, [a](Index v) { return v == a; }));
    if (edge.clip == infinite) return false;
    edge.from = side.core.vertex(a);
    edge.to = side.core.vertex(b);
    return true;
}

bool is_farther(const Vec3& x, const LoneEdge& edge, double distance) {
    const Vec3 along = edge.to - edge.from;
    const double t = std::clamp((x - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (x - edge.from - t * along).squaredNorm() > square(distance);
}

bool add_lone_edges(const Side& i, const Side& j, const NearCores& near, FeatureSum& features) {
    LoneEdge a{};
    LoneEdge b{};
    if (!is_lone_edge(i, near.deepest, a) || !is_lone_edge(j, near.deepest, b)) return false;
    const double far = a.clip + b.clip + i.core.rounding + j.core.rounding;
    if (!is_farther(a.from, b, far) || !is_farther(a.to, b, far) || !is_farther(b.from, a, far) ||
        !is_farther(b.to, a, far))
        return false;
    add_line_pair(line_of(i.core, a.number), line_of(j.core, b.number), near, i.core.rounding,
                  j.core.rounding, features);
    return true;
}

}  // namespace

bool add_lone_feature(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                      FeatureSum& features) {
    const Side side_i{i, near.i, i.direction_in_body(-near.normal), 1.0};
    const Side side_j{j, near.j, j.direction_in_body(near.normal), -1.0};
    if (near.i.count == 1) return add_lone_vertex(side_i, side_j, near, features);
    if (near.j.count == 1) return add_lone_vertex(side_j, side_i, near, features);
    if (near.i.count == 2 && near.j.count == 2)
        return add_lone_edges(side_i, side_j, near, features);
    return false;
}

}  // namespace dem
