// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/convex_display.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/convex/exact_hull.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {

namespace {

constexpr std::size_t most_corners = 1000;  // of faces that are drawn exactly
constexpr std::size_t most_points = 10'000;
constexpr int most_rounds = 30;

/// Points on a surface of revolution about z.
class RingPoints {
  public:
    explicit RingPoints(double tolerance) : tolerance_(tolerance) {}

    /// Chords of an arc that leave it by the tolerance at most.
    int chords(double radius, double angle) const {
        if (radius == 0.0) return 1;
        const double half = math::acos(std::max(1.0 - tolerance_ / radius, 0.7));
        return std::max(1, static_cast<int>(std::ceil(0.5 * angle / half)));
    }

    /// A part of a torus, or of a sphere where `tube_center` is zero: polar angles begin .. end of
    /// a circle of radius `tube` around (tube_center, z).
    void arc(double tube_center, double z, double tube, double begin, double end) {
        const int steps = chords(tube, end - begin);
        for (int i = 0; i <= steps; ++i) {
            const double angle = begin + (end - begin) * i / steps;
            ring(tube_center + tube * math::sin(angle), z + tube * math::cos(angle));
            if (tube == 0.0) return;
        }
    }

    void ring(double radius, double z) {
        if (radius < 1e-12 * std::abs(z)) {
            points.emplace_back(0.0, 0.0, z);
            return;
        }
        const int steps = std::max(8, chords(radius, 2.0 * pi));
        for (int i = 0; i < steps; ++i) {
            const double angle = 2.0 * pi * i / steps;
            points.emplace_back(radius * math::cos(angle), radius * math::sin(angle), z);
        }
    }

    std::vector<Vec3> points;

  private:
    double tolerance_;
};

/// Around a point or a segment.
std::vector<Vec3> capsule_points(const ConvexShape& shape, double tolerance) {
    const Vec3 along = shape.vertices.back() - shape.vertices[0];
    const double half = 0.5 * along.norm();
    const Vec3 center = 0.5 * (shape.vertices[0] + shape.vertices.back());
    RingPoints rings(tolerance);
    rings.arc(0.0, half, shape.rounding, 0.0, 0.5 * pi);
    rings.arc(0.0, -half, shape.rounding, 0.5 * pi, pi);
    const Quat turn =
        half > 0.0 ? Quat::FromTwoVectors(Vec3::UnitZ(), along) : Quat(Quat::Identity());
    for (Vec3& p : rings.points) p = center + turn * p;
    return rings.points;
}

std::vector<Vec3> round_points(const ConvexShape& shape, double tolerance) {
    const StoredVec3& s = shape.size;
    const double high = shape.low + s.z;
    RingPoints rings(tolerance);
    switch (shape.core) {
        case ConvexShape::Core::polyhedron:
            return capsule_points(shape, tolerance);
        case ConvexShape::Core::ellipsoid: {
            const double largest = std::max({s.x, s.y, s.z});
            RingPoints unit(tolerance / largest);
            unit.arc(0.0, 0.0, 1.0, 0.0, pi);
            for (Vec3& p : unit.points) {
                const Vec3 on_core(s.x * p.x(), s.y * p.y(), s.z * p.z());
                const Vec3 normal(p.x() / s.x, p.y() / s.y, p.z() / s.z);
                p = on_core + shape.rounding * normal.normalized();
            }
            return unit.points;
        }
        case ConvexShape::Core::cylinder:
            rings.arc(s.x, high, shape.rounding, 0.0, 0.5 * pi);
            rings.arc(s.x, shape.low, shape.rounding, 0.5 * pi, pi);
            return rings.points;
        case ConvexShape::Core::cone: {
            const double side = math::atan2(s.z, s.x);  // polar angle of the normal of the side
            rings.arc(0.0, high, shape.rounding, 0.0, side);
            rings.arc(s.x, shape.low, shape.rounding, side, pi);
            return rings.points;
        }
    }
    return {};
}

Vec3 surface_point(const ConvexShape& shape, const Vec3& normal) {
    return core_support(shape, normal).position + shape.rounding * normal;
}

/// Every corner of every face, moved outwards with it: flat faces stay flat. Of a polyhedron with
/// many faces, only a few points to begin with.
std::vector<Vec3> polyhedron_points(const ConvexShape& shape) {
    std::vector<Vec3> points;
    if (shape.face_vertices.size() <= most_corners) {
        for (std::size_t f = 0; f < shape.face_count(); ++f)
            for (std::uint32_t k = shape.face_begin[f]; k < shape.face_begin[f + 1]; ++k)
                points.emplace_back(shape.vertices[shape.face_vertices[k]] +
                                    shape.rounding * shape.planes[f].normal);
        return points;
    }
    for (const int z : {-1, 0, 1}) {
        for (const int y : {-1, 0, 1}) {
            for (const int x : {-1, 0, 1}) {
                const Vec3 direction(x, y, z);
                if (!direction.isZero())
                    points.push_back(surface_point(shape, direction.normalized()));
            }
        }
    }
    return points;
}

/// How far the body rises above a face of a hull of its points [m].
double rise(const ConvexShape& shape, const ConvexPolyhedron& hull, std::size_t face) {
    const Vec3 n = hull.normal(face);
    return extent(shape, n) - hull.offset(face, n);
}

/// Adds the support points of all faces that the body rises above, until it rises above none
/// (sandwich algorithm).
void refine(const ConvexShape& shape, double tolerance, std::vector<Vec3>& points) {
    for (int round = 0; round < most_rounds && points.size() < most_points; ++round) {
        const ConvexPolyhedron hull = exact_hull(points);
        const std::size_t before = points.size();
        for (std::size_t f = 0; f < hull.faces.size(); ++f)
            if (rise(shape, hull, f) > tolerance)
                points.push_back(surface_point(shape, hull.normal(f)));
        if (points.size() == before) return;
    }
}

}  // namespace

DisplayMesh display_mesh(const ConvexPolyhedron& solid) {
    DisplayMesh mesh;
    mesh.vertices = solid.vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& face : solid.faces)
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            triangles.push_back({face[0], face[k], face[k + 1]});
    mesh.triangles = std::move(triangles);
    return mesh;
}

DisplayMesh convex_display_mesh(const ConvexShape& shape, double tolerance) {
    const bool has_faces = shape.face_count() > 0;
    std::vector<Vec3> points =
        has_faces ? polyhedron_points(shape) : round_points(shape, tolerance);
    if (has_faces) refine(shape, tolerance, points);
    const ConvexPolyhedron hull = exact_hull(points);
    DisplayMesh mesh = display_mesh(hull);
    for (std::size_t f = 0; f < hull.faces.size(); ++f)
        mesh.max_deviation = std::max(mesh.max_deviation, rise(shape, hull, f));
    return mesh;
}

}  // namespace dem::shapegen
