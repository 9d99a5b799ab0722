// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/hull_by_force.hpp"

#include "common/math/aabb.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace dem::test {

namespace {

using Index = std::uint32_t;
using Face = std::vector<Index>;

/// Counter-clockwise about the normal, the lowest number first.
Face in_order(Face face, std::span<const Vec3> points, const Vec3& normal) {
    const Vec3& origin = points[face[0]];
    // Seen from a corner of a convex face the others lie within half a turn.
    std::sort(face.begin() + 1, face.end(), [&](Index p, Index q) {
        return normal.dot((points[p] - origin).cross(points[q] - origin)) > 0.0;
    });
    return face;
}

/// The points in the plane through three of them, rising; none where a point lies above.
Face face_through(std::span<const Vec3> points, const Vec3& origin, const Vec3& normal,
                  double flat) {
    Face face;
    for (Index p = 0; p < points.size(); ++p) {
        const double height = normal.dot(points[p] - origin);
        if (height > flat) return {};
        if (height >= -flat) face.push_back(p);
    }
    return face;
}

/// The plane through three points that lie nearly on a line may miss others of their face.
bool is_part_of_another(const Face& face, const std::map<Face, Vec3>& normals) {
    return std::any_of(normals.begin(), normals.end(), [&](const auto& other) {
        return other.first.size() > face.size() &&
               std::includes(other.first.begin(), other.first.end(), face.begin(), face.end());
    });
}

/// Without the points that are on no face.
ConvexPolyhedron numbered_anew(std::vector<Face> faces, std::span<const Vec3> points) {
    std::vector<bool> is_corner(points.size());
    for (const Face& face : faces)
        for (const Index p : face) is_corner[p] = true;
    ConvexPolyhedron hull;
    std::vector<Index> number(points.size());
    for (Index p = 0; p < points.size(); ++p) {
        number[p] = static_cast<Index>(hull.vertices.size());
        if (is_corner[p]) hull.vertices.push_back(points[p]);
    }
    for (Face& face : faces)
        for (Index& p : face) p = number[p];
    std::sort(faces.begin(), faces.end());
    hull.faces = std::move(faces);
    return hull;
}

}  // namespace

ConvexPolyhedron hull_by_force(std::span<const Vec3> points) {
    Aabb box;
    for (const Vec3& p : points) box.extend(p);
    const double extent = (box.upper - box.lower).norm();
    const double flat = 1e-9 * extent;
    std::map<Face, Vec3> normals;
    for (Index a = 0; a < points.size(); ++a) {
        for (Index b = a + 1; b < points.size(); ++b) {
            for (Index c = b + 1; c < points.size(); ++c) {
                const Vec3 cross = (points[b] - points[a]).cross(points[c] - points[a]);
                if (cross.norm() < flat * extent) continue;  // no plane to speak of
                for (const Vec3& normal : {cross.normalized(), Vec3(-cross.normalized())}) {
                    const Face face = face_through(points, points[a], normal, flat);
                    if (face.size() >= 3) normals.emplace(face, normal);
                }
            }
        }
    }
    std::vector<Face> faces;
    for (const auto& [face, normal] : normals)
        if (!is_part_of_another(face, normals)) faces.push_back(in_order(face, points, normal));
    return numbered_anew(std::move(faces), points);
}

}  // namespace dem::test
