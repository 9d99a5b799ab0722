// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/convex_moments.hpp"

#include "common/math/elementary.hpp"
#include "common/math/quadrature.hpp"

#include <cmath>
#include <vector>

namespace dem {

namespace {

using Index = std::uint32_t;

Mat3 outer(const Vec3& a, const Vec3& b) {
    return a * b.transpose();
}
Mat3 symmetric(const Vec3& a, const Vec3& b) {
    return outer(a, b) + outer(b, a);
}

/// Integrals of 1, y, y y^T over a flat or straight piece of the core, or 1, u, u u^T over the
/// directions in which the rounding leaves it.
struct Piece {
    double size = 0.0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
};

/// Adds the points y + s u, 0 <= s <= r, y of a piece of dimension 2 - power and u of its
/// directions, each with the volume s^power ds dy du.
void add_layer(ConvexMoments& m, const Piece& y, const Piece& u, double r, int power) {
    const double r_power = math::pow(r, power);
    const auto over = [&](int k) { return r_power * math::pow(r, k + 1) / (power + k + 1); };
    m.volume += over(0) * y.size * u.size;
    m.first += over(0) * u.size * y.first + over(1) * y.size * u.first;
    m.second += over(0) * u.size * y.second + over(1) * symmetric(y.first, u.first) +
                over(2) * y.size * u.second;
    m.area += r_power * y.size * u.size;
    m.surface_first += r_power * (u.size * y.first + r * y.size * u.first);
    m.surface_second += r_power * (u.size * y.second.trace() + 2.0 * r * y.first.dot(u.first) +
                                   square(r) * y.size * u.second.trace());
}

// ---- Polyhedra.

Piece triangle_piece(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const Vec3 s = a + b + c;
    return {area, area / 3.0 * s,
            area / 12.0 * (outer(a, a) + outer(b, b) + outer(c, c) + outer(s, s))};
}

void add_face(ConvexMoments& m, const ConvexShape& shape, Index face) {
    const Index begin = shape.face_begin[face];
    const Vec3& n = shape.planes[face].normal;
    const Piece direction{1.0, n, outer(n, n)};
    const Vec3& a = shape.vertices[shape.face_vertices[begin]];
    for (Index k = begin + 1; k + 1 < shape.face_begin[face + 1]; ++k) {
        const Vec3& b = shape.vertices[shape.face_vertices[k]];
        const Vec3& c = shape.vertices[shape.face_vertices[k + 1]];
        add_layer(m, triangle_piece(a, b, c), direction, shape.rounding, 0);
        // The tetrahedron between the triangle and the origin.
        const Vec3 s = a + b + c;
        const double volume = a.dot(b.cross(c)) / 6.0;
        m.volume += volume;
        m.first += 0.25 * volume * s;
        m.second += volume / 20.0 * (outer(a, a) + outer(b, b) + outer(c, c) + outer(s, s));
    }
}

/// Directions on the great circle from a to b (unit, normal to the edge).
Piece arc_piece(const Vec3& a, const Vec3& b) {
    const double angle = math::atan2(a.cross(b).norm(), a.dot(b));
    const Vec3 middle = (a + b).normalized();
    const Vec3 across = (b - a).normalized();
    const double half_sine = 0.5 * math::sin(angle);
    return {angle, 2.0 * math::sin(0.5 * angle) * middle,
            (0.5 * angle + half_sine) * outer(middle, middle) +
                (0.5 * angle - half_sine) * outer(across, across)};
}

void add_edge(ConvexMoments& m, const ConvexShape& shape, const ConvexShape::Edge& edge) {
    const Vec3& p = shape.vertices[edge.from];
    const Vec3& q = shape.vertices[edge.to];
    const double length = (q - p).norm();
    const Vec3 s = p + q;
    const Piece line{length, 0.5 * length * s,
                     length / 6.0 * (outer(p, p) + outer(q, q) + outer(s, s))};
    Piece around;
    if (edge.left == ConvexShape::Edge::no_face) {
        const Vec3 e = (q - p) / length;
        around = {2.0 * pi, Vec3::Zero(), pi * (Mat3::Identity() - outer(e, e))};
    } else {
        around = arc_piece(shape.planes[edge.left].normal, shape.planes[edge.right].normal);
    }
    add_layer(m, line, around, shape.rounding, 1);
}

/// Normals of the faces around a vertex, counter-clockwise seen from outside.
std::vector<Vec3> normals_around(const ConvexShape& shape, Index vertex) {
    std::vector<Vec3> normals;
    const Index begin = shape.neighbor_begin[vertex];
    const Index count = shape.neighbor_begin[vertex + 1] - begin;
    const auto edge = [&](Index k) { return shape.edges[shape.neighbor_edges[begin + k]]; };
    // The face at the left of an edge that leaves the vertex is at the right of the next one.
    const auto left = [&](const ConvexShape::Edge& e) {
        return e.from == vertex ? e.left : e.right;
    };
    const auto right = [&](const ConvexShape::Edge& e) {
        return e.from == vertex ? e.right : e.left;
    };
    Index face = left(edge(0));
    for (Index step = 0; step < count; ++step) {
        normals.push_back(shape.planes[face].normal);
        for (Index k = 0; k < count; ++k) {
            if (right(edge(k)) == face) {
                face = left(edge(k));
                break;
            }
        }
    }
    return normals;
}

/// Directions in the spherical polygon with these corners. With Omega its area, e its sides, nu the
/// outward normals of their planes and l their lengths, Gauss' theorem on the cone gives
///     int n = -1/2 sum l_e nu_e,   int n n^T = 1/3 (Omega 1 - sum nu_e (int_e u)^T).
Piece cone_piece(const std::vector<Vec3>& corners) {
    Piece cone;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const Vec3& a = corners[0];
        const Vec3& b = corners[k];
        const Vec3& c = corners[k + 1];
        cone.size += 2.0 * math::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    cone.second = cone.size * Mat3::Identity();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3& a = corners[k];
        const Vec3& b = corners[(k + 1) % corners.size()];
        const Vec3 outward = -a.cross(b).normalized();
        const Piece arc = arc_piece(a, b);
        cone.first -= 0.5 * arc.size * outward;
        cone.second -= outer(outward, arc.first);
    }
    cone.second /= 3.0;
    return cone;
}

Piece vertex_cone(const ConvexShape& shape, Index vertex) {
    if (shape.vertices.size() == 1)
        return {4.0 * pi, Vec3::Zero(), 4.0 / 3.0 * pi * Mat3::Identity()};
    if (shape.vertices.size() == 2) {
        const Vec3 e = (shape.vertices[vertex] - shape.vertices[1 - vertex]).normalized();
        return {2.0 * pi, pi * e, 2.0 / 3.0 * pi * Mat3::Identity()};
    }
    return cone_piece(normals_around(shape, vertex));
}

ConvexMoments of_polyhedron(const ConvexShape& shape) {
    ConvexMoments m;
    for (Index f = 0; f < shape.face_count(); ++f) add_face(m, shape, f);
    if (shape.rounding == 0.0) return m;
    for (const ConvexShape::Edge& edge : shape.edges) add_edge(m, shape, edge);
    for (Index v = 0; v < shape.vertices.size(); ++v) {
        const Vec3& x = shape.vertices[v];
        add_layer(m, {1.0, x, outer(x, x)}, vertex_cone(shape, v), shape.rounding, 2);
    }
    return m;
}

// ---- Solids of revolution about z.

using ProfileIntegrals = Integrals<7>;

/// What a point (r, z) of the profile contributes, moving by (dr, dz).
ProfileIntegrals profile_part(double r, double z, double dr, double dz) {
    const double length = math::hypot(dr, dz);
    const double r2 = r * r;
    ProfileIntegrals p;
    p << r2 * dz, r2 * z * dz, r2 * z * z * dz, r2 * r2 * dz, r * length, r * z * length,
        r * (r2 + z * z) * length;
    return p;
}

/// Sum over the pieces of a profile, from the lower end of the axis to the upper one.
struct ProfileSum {
    ProfileIntegrals sum = ProfileIntegrals::Zero();

    void line(const Vec2& a, const Vec2& b) {
        const Vec2 way = b - a;
        sum += integrate_panel<7>(
            [&](double t) {
                const Vec2 p = a + t * way;
                return profile_part(p.x(), p.y(), way.x(), way.y());
            },
            0.0, 1.0);
    }
    /// Angles from the r axis.
    void arc(const Vec2& center, double radius, double from, double to) {
        sum += integrate_panel<7>(
            [&](double t) {
                const double dr = radius * math::cos(t);
                const double dz = radius * math::sin(t);
                return profile_part(center.x() + dr, center.y() + dz, -dz, dr);
            },
            from, to);
    }
};

ConvexMoments of_revolution(const ConvexShape& shape) {
    const double r = shape.rounding;
    const double radius = shape.size.x;
    const double low = shape.low;
    const double high = low + shape.size.z;
    ProfileSum profile;
    profile.line({0.0, low - r}, {radius, low - r});
    if (shape.core == ConvexShape::Core::cylinder) {
        profile.arc({radius, low}, r, -0.5 * pi, 0.0);
        profile.line({radius + r, low}, {radius + r, high});
        profile.arc({radius, high}, r, 0.0, 0.5 * pi);
        profile.line({radius, high + r}, {0.0, high + r});
    } else {
        const double angle = math::atan2(radius, shape.size.z);
        const Vec2 off = r * Vec2(math::cos(angle), math::sin(angle));
        profile.arc({radius, low}, r, -0.5 * pi, angle);
        profile.line(Vec2(radius, low) + off, Vec2(0.0, high) + off);
        profile.arc({0.0, high}, r, angle, 0.5 * pi);
    }
    const ProfileIntegrals& s = profile.sum;
    ConvexMoments m;
    m.volume = pi * s[0];
    m.first.z() = pi * s[1];
    m.second.diagonal() << 0.25 * pi * s[3], 0.25 * pi * s[3], pi * s[2];
    m.area = 2.0 * pi * s[4];
    m.surface_first.z() = 2.0 * pi * s[5];
    m.surface_second = 2.0 * pi * s[6];
    return m;
}

// ---- Ellipsoids.

using EllipsoidIntegrals = Integrals<6>;

/// Area, |x|^2, and the volume and x_i^2 of the layer of the rounding, per area of the unit sphere
/// that the ellipsoid is the image of.
EllipsoidIntegrals ellipsoid_part(const ConvexShape& shape, const Vec3& u) {
    const Vec3 a = shape.size;
    const double product2 = square(a.prod());
    const Vec3 x = a.cwiseProduct(u);
    const Vec3 gradient = u.cwiseQuotient(a);
    const double q2 = gradient.squaredNorm();
    const double q = std::sqrt(q2);
    const Vec3 n = gradient / q;
    const double stretch = a.prod() * q;
    const double curvatures = (a.squaredNorm() - x.squaredNorm()) / (product2 * q2 * q);
    const double gauss = 1.0 / (product2 * q2 * q2);
    const auto layer = [&](double s) { return 1.0 + s * (curvatures + s * gauss); };
    const double r = shape.rounding;
    EllipsoidIntegrals part = EllipsoidIntegrals::Zero();
    if (r > 0.0) {
        part = integrate_panel<6>(
            [&](double s) {
                const Vec3 y = x + s * n;
                EllipsoidIntegrals p;
                p << 0.0, 0.0, 1.0, y.x() * y.x(), y.y() * y.y(), y.z() * y.z();
                return EllipsoidIntegrals(layer(s) * p);
            },
            0.0, r);
    }
    part[0] = layer(r);
    part[1] = layer(r) * (x + r * n).squaredNorm();
    return stretch * part;
}

ConvexMoments of_ellipsoid(const ConvexShape& shape) {
    // One octant of eight.
    const EllipsoidIntegrals s =
        8.0 * integrate<6>(
                  [&](double z) {
                      const double across = std::sqrt(1.0 - z * z);
                      return integrate<6>(
                          [&](double phi) {
                              return ellipsoid_part(
                                  shape, {across * math::cos(phi), across * math::sin(phi), z});
                          },
                          0.0, 0.5 * pi);
                  },
                  0.0, 1.0);
    const Vec3 a = shape.size;
    const double volume = 4.0 / 3.0 * pi * a.prod();
    ConvexMoments m;
    m.volume = volume + s[2];
    m.second = (0.2 * volume * a.cwiseProduct(a) + Vec3(s[3], s[4], s[5])).asDiagonal();
    m.area = s[0];
    m.surface_second = s[1];
    return m;
}

}  // namespace

ConvexMoments convex_moments(const ConvexShape& shape) {
    if (shape.is_polyhedron()) return of_polyhedron(shape);
    return shape.core == ConvexShape::Core::ellipsoid ? of_ellipsoid(shape) : of_revolution(shape);
}

}  // namespace dem
