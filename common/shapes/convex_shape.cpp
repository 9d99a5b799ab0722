// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/convex_shape.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace dem {

namespace {

using Edge = ConvexShape::Edge;
using Index = std::uint32_t;

std::size_t faces_of(const ConvexShape& shape) {
    return shape.face_begin.empty() ? 0 : shape.face_begin.size() - 1;
}

/// Face at the left of every directed edge.
std::map<std::pair<Index, Index>, Index> faces_by_edge(const ConvexShape& shape) {
    std::map<std::pair<Index, Index>, Index> result;
    for (Index f = 0; f < faces_of(shape); ++f) {
        const Index begin = shape.face_begin[f];
        const Index size = shape.face_begin[f + 1] - begin;
        for (Index k = 0; k < size; ++k) {
            const Index from = shape.face_vertices[begin + k];
            const Index to = shape.face_vertices[begin + (k + 1) % size];
            result[{from, to}] = f;
        }
    }
    return result;
}

std::vector<Edge> edges_of(const ConvexShape& shape) {
    std::vector<Edge> edges;
    const auto add = [&](Index from, Index to, Index left, Index right) {
        const Vec3 way = shape.vertices[to] - shape.vertices[from];
        edges.push_back({from, to, left, right, way.normalized(), way.norm()});
    };
    if (shape.vertices.size() == 2) add(0, 1, Edge::no_face, Edge::no_face);
    const auto faces = faces_by_edge(shape);
    for (const auto& [edge, left] : faces) {
        if (edge.first < edge.second)
            add(edge.first, edge.second, left, faces.at({edge.second, edge.first}));
    }
    return edges;
}

/// Plane of a face, through its farthest vertex.
ConvexShape::Plane plane_of(const ConvexShape& shape, Index face) {
    const Index begin = shape.face_begin[face];
    const Index end = shape.face_begin[face + 1];
    const auto vertex = [&](Index k) { return shape.vertices[shape.face_vertices[k]]; };
    const Vec3 origin = vertex(begin);
    Vec3 sum = Vec3::Zero();
    for (Index k = begin + 1; k + 1 < end; ++k)
        sum += (vertex(k) - origin).cross(vertex(k + 1) - origin);
    const Vec3 normal = sum.normalized();
    double offset = normal.dot(origin);
    for (Index k = begin; k < end; ++k) offset = std::max(offset, normal.dot(vertex(k)));
    return {normal, offset};
}

}  // namespace

void index_core(ConvexShape& shape) {
    if (!shape.is_polyhedron()) return;
    std::vector<ConvexShape::Plane> planes;
    for (Index f = 0; f < faces_of(shape); ++f) planes.push_back(plane_of(shape, f));
    const std::vector<Edge> edges = edges_of(shape);
    const std::size_t count = shape.vertices.size();
    std::vector<std::vector<std::pair<Index, Index>>> around(count);  // vertex, edge
    for (Index e = 0; e < edges.size(); ++e) {
        around[edges[e].from].emplace_back(edges[e].to, e);
        around[edges[e].to].emplace_back(edges[e].from, e);
    }
    std::vector<Index> begin{0};
    std::vector<Index> neighbors;
    std::vector<Index> neighbor_edges;
    for (auto& list : around) {
        std::sort(list.begin(), list.end());
        for (const auto& [vertex, edge] : list) {
            neighbors.push_back(vertex);
            neighbor_edges.push_back(edge);
        }
        begin.push_back(static_cast<Index>(neighbors.size()));
    }
    shape.planes = std::move(planes);
    shape.edges = edges;
    shape.neighbor_begin = std::move(begin);
    shape.neighbors = std::move(neighbors);
    shape.neighbor_edges = std::move(neighbor_edges);
}

bool is_closed_hull(const ConvexShape& shape) {
    const std::size_t count = shape.vertices.size();
    if (count <= 2) return count > 0 && faces_of(shape) == 0;
    const auto faces = faces_by_edge(shape);
    if (faces.size() != shape.face_vertices.size()) return false;  // an edge twice in one direction
    std::vector<std::vector<Index>> next(count);
    for (const auto& [edge, face] : faces) {
        if (edge.first == edge.second || faces.count({edge.second, edge.first}) == 0) return false;
        next[edge.first].push_back(edge.second);
    }
    if (count + faces_of(shape) != faces.size() / 2 + 2) return false;
    std::vector<bool> reached(count);
    std::vector<Index> stack{0};
    std::size_t found = 1;
    reached[0] = true;
    while (!stack.empty()) {
        const Index v = stack.back();
        stack.pop_back();
        for (const Index w : next[v]) {
            if (reached[w]) continue;
            reached[w] = true;
            ++found;
            stack.push_back(w);
        }
    }
    return found == count;
}

}  // namespace dem
