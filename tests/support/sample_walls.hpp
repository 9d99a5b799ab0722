// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "shapegen/wall/make_wall.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <tuple>
#include <utility>

/// Surfaces of triangles for tests of walls, made in code.
namespace dem::sample {

using shapegen::TriangleSoup;

constexpr double usual_crease = 25.0 * pi / 180.0;

/// A soup whose corners in the same place are one point.
class Surface {
  public:
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        soup_.triangles.push_back({point(a), point(b), point(c)});
    }
    /// Two triangles, counter-clockwise seen from the front.
    void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        add(a, b, c);
        add(a, c, d);
    }
    const TriangleSoup& soup() const { return soup_; }
    WallMesh wall(double crease = usual_crease) const {
        return shapegen::make_wall(soup_, crease).mesh;
    }

  private:
    std::uint32_t point(const Vec3& p) {
        const auto next = static_cast<std::uint32_t>(soup_.points.size());
        const auto [entry, is_new] = points_.try_emplace(std::tuple(p.x(), p.y(), p.z()), next);
        if (is_new) soup_.points.push_back(p);
        return entry->second;
    }
    TriangleSoup soup_;
    std::map<std::tuple<double, double, double>, std::uint32_t> points_;
};

/// A rectangle at z = 0 of columns x rows quads, its front towards +z.
inline Surface plate(const Vec2& lower, const Vec2& upper, int columns, int rows) {
    Surface surface;
    const auto at = [&](int i, int k) {
        return Vec3(lower.x() + (upper.x() - lower.x()) * i / columns,
                    lower.y() + (upper.y() - lower.y()) * k / rows, 0.0);
    };
    for (int i = 0; i < columns; ++i)
        for (int k = 0; k < rows; ++k)
            surface.add_quad(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
    return surface;
}

/// The six faces of a box, fronts inwards.
inline Surface box_inside(const Vec3& l, const Vec3& u) {
    const auto at = [&](int x, int y, int z) {
        return Vec3(x == 0 ? l.x() : u.x(), y == 0 ? l.y() : u.y(), z == 0 ? l.z() : u.z());
    };
    Surface s;
    s.add_quad(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0));
    s.add_quad(at(0, 0, 1), at(0, 1, 1), at(1, 1, 1), at(1, 0, 1));
    s.add_quad(at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1));
    s.add_quad(at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0));
    s.add_quad(at(0, 0, 0), at(0, 0, 1), at(1, 0, 1), at(1, 0, 0));
    s.add_quad(at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1));
    return s;
}

/// The side of a cylinder about z, `facets` flat strips whose edges lie on it, fronts inwards.
inline Surface tube(double radius, double low, double high, int facets) {
    Surface surface;
    const auto at = [&](int k, double z) {
        const auto [sine, cosine] = math::sin_cos(2.0 * pi * (k % facets) / facets);
        return Vec3(radius * cosine, radius * sine, z);
    };
    for (int k = 0; k < facets; ++k)
        surface.add_quad(at(k, low), at(k, high), at(k + 1, high), at(k + 1, low));
    return surface;
}

/// A regular tetrahedron of edge length `edge` about the origin, fronts outwards.
inline Surface tetrahedron_outside(double edge) {
    const double s = edge / std::sqrt(8.0);
    const std::array<Vec3, 4> v = {Vec3(s, s, s), Vec3(s, -s, -s), Vec3(-s, s, -s),
                                   Vec3(-s, -s, s)};
    Surface surface;
    surface.add(v[0], v[1], v[2]);
    surface.add(v[0], v[3], v[1]);
    surface.add(v[0], v[2], v[3]);
    surface.add(v[1], v[3], v[2]);
    return surface;
}

/// Two plates along y that meet at x = 0 and rise by `bend` together, as a valley seen from +z (a
/// ridge for a negative one) [rad].
inline Surface valley(double bend, double half_width, double length) {
    const auto [sine, cosine] = math::sin_cos(0.5 * bend);
    const Vec3 out(half_width * cosine, 0.0, half_width * sine);
    const Vec3 back(-out.x(), 0.0, out.z());
    const Vec3 y(0.0, 0.5 * length, 0.0);
    Surface surface;
    surface.add_quad(-y, out - y, out + y, y);
    surface.add_quad(back - y, -y, y, back + y);
    return surface;
}

}  // namespace dem::sample
