// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/wall_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

void index_wall(WallMesh& mesh) {
    mesh.normals.clear();
    mesh.normals.reserve(mesh.triangles.size());
    mesh.bounds = {};
    std::vector<std::array<std::uint32_t, 2>> sides;
    sides.reserve(6 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3& a = mesh.corner(t, 0);
        mesh.normals.push_back((mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).normalized());
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = mesh.triangles[t][k];
            const std::uint32_t to = mesh.triangles[t][(k + 1) % 3];
            sides.push_back({from, to});
            sides.push_back({to, from});
            mesh.bounds.extend(mesh.vertices[from]);
        }
    }
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    mesh.fan_begin.assign(mesh.vertices.size() + 1, 0);
    mesh.fan.clear();
    mesh.fan.reserve(sides.size());
    for (const auto& [from, to] : sides) {
        ++mesh.fan_begin[from + 1];
        mesh.fan.push_back(to);
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.fan_begin[v + 1] += mesh.fan_begin[v];
    mesh.least_bends.assign(mesh.blends.size() + 1, WallMesh::sharp);
    for (std::uint32_t h = 0; h < mesh.bends.size(); ++h) {
        const double bend = std::abs(mesh.bends[h]);
        if (bend < level_bend || !mesh.is_smooth(h)) continue;
        double& least = mesh.least_bends[mesh.patches[h / 3]];
        least = std::min(least, bend);
        mesh.least_bends.back() = std::min(mesh.least_bends.back(), bend);
    }
}

WallMesh scaled(const WallMesh& mesh, double scale) {
    WallMesh result = mesh;
    std::vector<Vec3> vertices(mesh.vertices.begin(), mesh.vertices.end());
    for (Vec3& v : vertices) v *= scale;
    std::vector<WallMesh::Box> boxes(mesh.boxes.begin(), mesh.boxes.end());
    for (WallMesh::Box& box : boxes) {
        box.lower *= scale;
        box.upper *= scale;
    }
    std::vector<double> blends(mesh.blends.begin(), mesh.blends.end());
    for (double& blend : blends) blend *= scale;
    result.vertices = std::move(vertices);
    result.boxes = std::move(boxes);
    result.blends = std::move(blends);
    index_wall(result);
    return result;
}

TrianglePoint nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ax = x - a;
    const double d1 = ab.dot(ax);
    const double d2 = ac.dot(ax);
    if (d1 <= 0.0 && d2 <= 0.0) return {a, 0};
    const Vec3 bx = x - b;
    const double d3 = ab.dot(bx);
    const double d4 = ac.dot(bx);
    if (d3 >= 0.0 && d4 <= d3) return {b, 1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + d1 / (d1 - d3) * ab, 3};
    const Vec3 cx = x - c;
    const double d5 = ab.dot(cx);
    const double d6 = ac.dot(cx);
    if (d6 >= 0.0 && d5 <= d6) return {c, 2};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + d2 / (d2 - d6) * ac, 5};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 4};
    const double sum = va + vb + vc;
    return {a + vb / sum * ab + vc / sum * ac, TrianglePoint::inside};
}

namespace {

double squared_distance(const WallMesh& mesh, std::uint32_t t, const Vec3& x) {
    const Vec3 q =
        nearest_on_triangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), x).point;
    return (x - q).squaredNorm();
}

/// Squared distance from the nearest triangle of the leaf that is found by going to the nearest of
/// the boxes below each: a bound that spares most of the tree.
double first_bound(const WallMesh& mesh, const Vec3& x) {
    std::uint32_t b = 0;
    while (mesh.boxes[b].count == 0 && mesh.boxes[b].next > b + 1) {
        std::uint32_t best = b + 1;
        for (std::uint32_t c = b + 1; c < mesh.boxes[b].next; c = mesh.boxes[c].next)
            if (squared_distance(mesh.boxes[c], x) < squared_distance(mesh.boxes[best], x))
                best = c;
        b = best;
    }
    double nearest2 = infinite;
    const WallMesh::Box& leaf = mesh.boxes[b];
    for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t)
        nearest2 = std::min(nearest2, squared_distance(mesh, t, x));
    return nearest2;
}

}  // namespace

double distance_within(const WallMesh& mesh, const Vec3& x, double most) {
    const auto count = static_cast<std::uint32_t>(mesh.boxes.size());
    double nearest2 = square(most);
    if (squared_distance(mesh.boxes[0], x) >= nearest2) return most;
    nearest2 = std::min(nearest2, first_bound(mesh, x));
    for (std::uint32_t b = 0; b < count;) {
        const WallMesh::Box& box = mesh.boxes[b];
        if (squared_distance(box, x) >= nearest2) {
            b = box.next;
            continue;
        }
        for (std::uint32_t t = box.first; t < box.first + box.count; ++t)
            nearest2 = std::min(nearest2, squared_distance(mesh, t, x));
        ++b;
    }
    return std::sqrt(nearest2);
}

namespace {

/// Whether a segment meets a box.
bool meets(const WallMesh::Box& box, const Vec3& a, const Vec3& way) {
    double enter = 0.0;
    double leave = 1.0;
    for (int k = 0; k < 3; ++k) {
        if (way[k] == 0.0) {
            if (a[k] < box.lower[k] || a[k] > box.upper[k]) return false;
            continue;
        }
        const double low = (box.lower[k] - a[k]) / way[k];
        const double high = (box.upper[k] - a[k]) / way[k];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave * (1.0 + 1e-12) + 1e-12;
}

/// Six times the volume of the tetrahedron a, b, p, q, seen along the segment from a to b: its sign
/// tells on which side of the line the edge from p to q passes. The order of p and q changes
/// nothing but the sign, so that no gap opens between neighbors.
double passing(const Vec3& way, const Vec3& p, const Vec3& q) {
    return way.dot(p.cross(q));
}

bool crosses(const WallMesh& mesh, std::uint32_t t, const Vec3& a, const Vec3& b) {
    const Vec3 p = mesh.corner(t, 0) - a;
    const Vec3 q = mesh.corner(t, 1) - a;
    const Vec3 r = mesh.corner(t, 2) - a;
    const Vec3& n = mesh.normals[t];
    const double from = -p.dot(n);
    const double to = (b - a).dot(n) + from;
    if ((from > 0.0) == (to > 0.0)) return false;
    const Vec3 way = b - a;
    const double u = passing(way, p, q);
    const double v = passing(way, q, r);
    const double w = passing(way, r, p);
    return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

}  // namespace

std::uint32_t first_crossed(const WallMesh& mesh, const Vec3& a, const Vec3& b) {
    const auto count = static_cast<std::uint32_t>(mesh.boxes.size());
    const Vec3 way = b - a;
    for (std::uint32_t n = 0; n < count;) {
        const WallMesh::Box& box = mesh.boxes[n];
        if (!meets(box, a, way)) {
            n = box.next;
            continue;
        }
        for (std::uint32_t t = box.first; t < box.first + box.count; ++t)
            if (crosses(mesh, t, a, b)) return t;
        ++n;
    }
    return static_cast<std::uint32_t>(mesh.triangles.size());
}

}  // namespace dem
