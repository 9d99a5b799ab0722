// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/mesh/triangle_mesh.hpp"

#include "shapegen/solids/principal_axes.hpp"

namespace dem::shapegen {
namespace {

struct Vertices {
    Vec3 a, b, c;
};

Vertices corners(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle,
                 const Vec3& origin) {
    return {mesh.vertices[triangle[0]] - origin, mesh.vertices[triangle[1]] - origin,
            mesh.vertices[triangle[2]] - origin};
}

/// Integrals over the solid of 1, x and x x^T, x from an origin.
struct VolumeMoments {
    double volume = 0.0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
};

/// Over the tetrahedron (0, a, b, c) of volume V: integral of x = V/4 (a + b + c), of x x^T =
/// V/20 (a a^T + b b^T + c c^T + s s^T) with s = a + b + c.
VolumeMoments volume_moments(const TriangleMesh& mesh, const Vec3& origin) {
    VolumeMoments m;
    for (const auto& triangle : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, triangle, origin);
        const Vec3 s = a + b + c;
        const double volume = a.dot(b.cross(c)) / 6.0;
        m.volume += volume;
        m.first += 0.25 * volume * s;
        m.second += volume / 20.0 *
                    (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
    return m;
}

/// Keeps the tetrahedra small for a mesh far from its frame's origin.
Vec3 middle(const TriangleMesh& mesh) {
    if (mesh.vertices.empty()) return Vec3::Zero();
    const Aabb box = bounding_box(mesh);
    return 0.5 * (box.lower + box.upper);
}

}  // namespace

Aabb bounding_box(const TriangleMesh& mesh) {
    Aabb box;
    for (const Vec3& vertex : mesh.vertices) box.extend(vertex);
    return box;
}

double surface_area(const TriangleMesh& mesh) {
    double area = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, triangle, Vec3::Zero());
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    return area;
}

double enclosed_volume(const TriangleMesh& mesh) {
    const Vec3 origin = middle(mesh);
    double volume = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, triangle, origin);
        volume += a.dot(b.cross(c)) / 6.0;
    }
    return volume;
}

MassProperties mass_properties(const TriangleMesh& mesh) {
    // About the middle first, then about the center of mass: no difference of large moments.
    const Vec3 origin = middle(mesh);
    const VolumeMoments rough = volume_moments(mesh, origin);
    const Vec3 center = origin + rough.first / rough.volume;
    const VolumeMoments m = volume_moments(mesh, center);
    const Mat3 inertia = m.second.trace() * Mat3::Identity() - m.second;
    return principal_mass_properties(m.volume, center, inertia);
}

double mean_squared_surface_distance(const TriangleMesh& mesh, const Vec3& center) {
    double area = 0.0;
    double sum = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, triangle, center);
        const double triangle_area = 0.5 * (b - a).cross(c - a).norm();
        area += triangle_area;
        // The mean of |x|^2 over a triangle.
        sum += triangle_area / 12.0 *
               (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + (a + b + c).squaredNorm());
    }
    return sum / area;
}

}  // namespace dem::shapegen
