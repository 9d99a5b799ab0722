// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/lone_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

using Index = std::uint32_t;

/// One body of the pair as the cap of the other sees it.
struct LoneSide {
    const PlacedCore& core;
    const NearVertices& near;
    Vec3 towards;  ///< unit, to the other body, body frame
    double sign;   ///< 1: i, -1: j
};

/// How far the edges from a vertex, but those that skip(end) names, reach within the cap [m];
/// without end if one ends in it.
template <class Skip>
double clip_reach(const LoneSide& side, Index vertex, double farthest, double depth,
                  const Skip& skip) {
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
bool is_well_above(const LoneSide& side, Index face, const Vec3& x, double far, double depth) {
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

bool add_lone_vertex(const LoneSide& side, const LoneSide& other, const NearCores& near,
                     double room, FeatureSum& features, LoneFeature& lone) {
    const double reach = side.core.rounding + other.core.rounding + room;
    const double depth = near.deepest + room;
    const ConvexShape& shape = other.core.shape;
    if (shape.planes.empty()) return false;
    const Index vertex = side.near.vertex[0];
    const double farthest = side.core.shape.vertices[vertex].dot(side.towards);
    const double clip = clip_reach(side, vertex, farthest, depth, [](Index) { return false; });
    if (clip == infinite) return false;
    const Vec3 x = side.core.vertex(vertex);
    const Vec3 x_body = other.core.in_body(x);
    double height = 0.0;
    const Index face = highest_face(shape, other.near.vertex[0], x_body, height);
    if (!(height > 0.0) || !is_well_above(other, face, x_body, clip + reach, depth)) return false;
    const Vec3 normal = other.core.turned(shape.planes[face].normal);
    add_vertex_at(side.core, x, other.core, {height, normal}, side.sign, features);
    lone.kind = side.sign > 0.0 ? LoneFeature::Kind::vertex_of_i : LoneFeature::Kind::vertex_of_j;
    lone.of_i = side.sign > 0.0 ? vertex : face;
    lone.of_j = side.sign > 0.0 ? face : vertex;
    return true;
}

/// The one edge that is the cap of a body, but for how far others reach in from its ends.
struct LoneEdge {
    Index number;
    Vec3 from, to;  ///< relative to the center of i [m]
    double clip;    ///< [m]
};

bool is_lone_edge(const LoneSide& side, double depth, LoneEdge& edge) {
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

bool add_lone_edges(const LoneSide& i, const LoneSide& j, const NearCores& near, double room,
                    FeatureSum& features, LoneFeature& lone) {
    LoneEdge a{};
    LoneEdge b{};
    const double depth = near.deepest + room;
    if (!is_lone_edge(i, depth, a) || !is_lone_edge(j, depth, b)) return false;
    const double far = a.clip + b.clip + i.core.rounding + j.core.rounding + room;
    if (!is_farther(a.from, b, far) || !is_farther(a.to, b, far) || !is_farther(b.from, a, far) ||
        !is_farther(b.to, a, far))
        return false;
    add_line_pair(line_of(i.core, a.number), line_of(j.core, b.number), near, i.core.rounding,
                  j.core.rounding, features);
    lone.kind = LoneFeature::Kind::edges;
    lone.of_i = a.number;
    lone.of_j = b.number;
    return true;
}

bool add_lone(const LoneSide& i, const LoneSide& j, const NearCores& near, double room,
              FeatureSum& features, LoneFeature& lone) {
    if (near.i.count == 1) return add_lone_vertex(i, j, near, room, features, lone);
    if (near.j.count == 1) return add_lone_vertex(j, i, near, room, features, lone);
    if (near.i.count == 2 && near.j.count == 2)
        return add_lone_edges(i, j, near, room, features, lone);
    return false;
}

struct VertexAtFace {
    const PlacedCore& of_vertex;
    const PlacedCore& of_face;
    Vec3 x;  ///< the vertex [m]
    SurfaceDistance distance;
};
VertexAtFace vertex_at_face(const PlacedCore& of_vertex, Index vertex, const PlacedCore& of_face,
                            Index face) {
    const ConvexShape::Plane& plane = of_face.shape.planes[face];
    const Vec3 x = of_vertex.vertex(vertex);
    const double height = plane.normal.dot(of_face.in_body(x)) - plane.offset;
    return {of_vertex, of_face, x, {height, of_face.turned(plane.normal)}};
}
VertexAtFace vertex_at_face(const PlacedCore& i, const PlacedCore& j, const LoneFeature& lone) {
    return lone.kind == LoneFeature::Kind::vertex_of_i ? vertex_at_face(i, lone.of_i, j, lone.of_j)
                                                       : vertex_at_face(j, lone.of_j, i, lone.of_i);
}

/// Features that can touch while the bodies move by `room`: none, one, or more.
class Contenders {
  public:
    Contenders(double reach, double room) : reach_(reach), room_(room) {}

    /// Notes a vertex with the face that it stays above. False when that is not certain.
    bool add_vertex(const PlacedCore& core, Index vertex, const PlacedCore& other,
                    LoneFeature::Kind kind) {
        const ConvexShape& shape = other.shape;
        const Vec3 x = other.in_body(core.vertex(vertex));
        Index face = 0;
        double height = -infinite;
        for (Index f = 0; f < shape.planes.size(); ++f) {
            const double h = shape.planes[f].normal.dot(x) - shape.planes[f].offset;
            if (h >= reach_ + room_) return true;
            if (h > height) {
                height = h;
                face = f;
            }
        }
        if (core_distance(shape, x).distance >= reach_ + room_) return true;
        if (!(height > room_) || !is_above(shape, face, x)) return false;
        const bool is_of_i = kind == LoneFeature::Kind::vertex_of_i;
        return add(kind, is_of_i ? vertex : face, is_of_i ? face : vertex);
    }
    /// Notes two edges. Where their lines are nearest moves by a multiple of `room`.
    bool add_edges(const EdgeLine& a, Index number_a, const EdgeLine& b, Index number_b) {
        const Vec3 between = a.start - b.start;
        const double cosine = a.direction.dot(b.direction);
        const double along_a = a.direction.dot(between);
        const double along_b = b.direction.dot(between);
        const double sine2 = 1.0 - cosine * cosine;
        const double far = reach_ + room_;
        if (sine2 < parallel_sine2) {
            // Not farther than the distance of the lines at any place of a.
            const Vec3 start = between - along_b * b.direction;
            const Vec3 end = start + a.length * (a.direction - cosine * b.direction);
            return std::min(start.norm(), end.norm()) - (end - start).norm() >= far;
        }
        const double t = (cosine * along_b - along_a) / sine2;
        const double u = (along_b - cosine * along_a) / sine2;
        // A body whose points move by no more than the room turns by less than room / radius. The
        // products above, of lengths up to two diameters, then change by a few rooms each, and the
        // quotients by less than this. The distance of the lines changes to second order of it.
        const double slack = 20.0 * room_ / sine2;
        if (t < -slack || t > a.length + slack || u < -slack || u > b.length + slack) return true;
        if ((between + t * a.direction - u * b.direction).norm() >= far + slack * room_ / far)
            return true;
        return add(LoneFeature::Kind::edges, number_a, number_b);
    }
    bool has_one(LoneFeature& lone) const {
        if (count_ != 1) return false;
        lone.kind = kind_;
        lone.of_i = of_i_;
        lone.of_j = of_j_;
        return true;
    }

  private:
    bool add(LoneFeature::Kind kind, Index of_i, Index of_j) {
        kind_ = kind;
        of_i_ = of_i;
        of_j_ = of_j;
        return ++count_ == 1;
    }
    bool is_above(const ConvexShape& shape, Index face, const Vec3& x) const {
        const Index begin = shape.face_begin[face];
        const Index size = shape.face_begin[face + 1] - begin;
        for (Index k = 0; k < size; ++k) {
            const Vec3& a = shape.vertices[shape.face_vertices[begin + k]];
            const Vec3& b = shape.vertices[shape.face_vertices[begin + (k + 1) % size]];
            const double inside = shape.planes[face].normal.cross(b - a).dot(x - a);
            if (!(inside > 3.0 * room_ * (b - a).norm())) return false;
        }
        return true;
    }

    double reach_, room_;
    LoneFeature::Kind kind_ = LoneFeature::Kind::none;
    Index of_i_ = 0, of_j_ = 0;
    int count_ = 0;
};

bool add_contenders(const PlacedCore& i, const PlacedCore& j, const ConvexScratch& scratch,
                    Contenders& contenders) {
    for (const ConvexCap::Vertex& v : scratch.i.vertices)
        if (!contenders.add_vertex(i, v.number, j, LoneFeature::Kind::vertex_of_i)) return false;
    for (const ConvexCap::Vertex& v : scratch.j.vertices)
        if (!contenders.add_vertex(j, v.number, i, LoneFeature::Kind::vertex_of_j)) return false;
    for (const ConvexCap::ClippedEdge& a : scratch.i.edges) {
        const EdgeLine line = line_of(i, a.number);
        for (const ConvexCap::ClippedEdge& b : scratch.j.edges)
            if (!contenders.add_edges(line, a.number, line_of(j, b.number), b.number)) return false;
    }
    return true;
}

}  // namespace

bool add_lone_feature(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                      FeatureSum& features, LoneFeature& lone, Leash& leash) {
    const LoneSide side_i{i, near.i, i.direction_in_body(-near.normal), 1.0};
    const LoneSide side_j{j, near.j, j.direction_in_body(near.normal), -1.0};
    const double room = leash_room(i, j);
    if (add_lone(side_i, side_j, near, room, features, lone)) {
        leash = leash_at(features.pair(), room);
        return true;
    }
    LoneFeature only_now;
    return add_lone(side_i, side_j, near, 0.0, features, only_now);
}

void look_for_lone_feature(const PlacedCore& i, const PlacedCore& j, const PairState& pair,
                           const NearCores& near, ConvexScratch& scratch, LoneFeature& lone,
                           Leash& leash) {
    if (lone.wait > 0) {
        --lone.wait;
        return;
    }
    const double reach = i.rounding + j.rounding;
    const double room = leash_room(i, j);
    collect_cap(i, -near.normal, near.deepest + room, near.i.vertex[0], scratch.i);
    collect_cap(j, near.normal, near.deepest + room, near.j.vertex[0], scratch.j);
    Contenders contenders(reach, room);
    if (add_contenders(i, j, scratch, contenders) && contenders.has_one(lone)) {
        leash = leash_at(pair, room);
    } else {
        lone.wait = 32;
    }
}

double lone_overlap(const PlacedCore& i, const PlacedCore& j, const LoneFeature& lone,
                    const Vec3& normal) {
    if (lone.kind == LoneFeature::Kind::none) return 0.0;
    const double reach = i.rounding + j.rounding;
    if (lone.kind != LoneFeature::Kind::edges) {
        const double height = vertex_at_face(i, j, lone).distance.distance;
        return height > 0.0 ? reach - height : 0.0;
    }
    const EdgeLine a = line_of(i, lone.of_i);
    const EdgeLine b = line_of(j, lone.of_j);
    const Vec3 across = a.direction.cross(b.direction);
    const double sine2 = across.squaredNorm();
    if (sine2 < least_sine2) return 0.0;
    const double along = across.dot(a.start - b.start);
    // From b to a along the normal, or the edges have passed through each other.
    if (along * across.dot(normal) <= 0.0) return 0.0;
    return reach - std::abs(along) / std::sqrt(sine2);
}

void add_known_feature(const PlacedCore& i, const PlacedCore& j, const LoneFeature& lone,
                       const Vec3& normal, FeatureSum& features) {
    if (lone.kind == LoneFeature::Kind::edges) {
        const NearCores near{normal, features.deepest(), false, {}, {}};
        add_line_pair(line_of(i, lone.of_i), line_of(j, lone.of_j), near, i.rounding, j.rounding,
                      features);
        return;
    }
    const VertexAtFace at = vertex_at_face(i, j, lone);
    const double sign = lone.kind == LoneFeature::Kind::vertex_of_i ? 1.0 : -1.0;
    add_vertex_at(at.of_vertex, at.x, at.of_face, at.distance, sign, features);
}

}  // namespace dem::runtime
