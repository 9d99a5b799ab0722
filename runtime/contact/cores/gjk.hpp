// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/shapes/convex_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

/// Distance of two convex cores by the algorithm of Gilbert, Johnson and Keerthi, as the distance
/// of the origin from the difference i - j of the two sets (docs/contact-convex.md, "Distance of
/// cores").
namespace dem::runtime {

/// A point of the difference: a of i, b of j.
struct SimplexPoint {
    Vec3 w;  ///< a - b
    Vec3 a, b;
    std::uint32_t vertex_a, vertex_b;
};

/// Up to four points whose hull is searched, with the weights of its point nearest to the origin.
struct Simplex {
    std::array<SimplexPoint, 4> point;
    std::array<double, 4> weight;
    int count = 0;

    Vec3 nearest() const {
        Vec3 v = weight[0] * point[0].w;
        for (int k = 1; k < count; ++k)
            v += weight[static_cast<std::size_t>(k)] * point[static_cast<std::size_t>(k)].w;
        return v;
    }
};

/// Keeps those points of the simplex that its point nearest to the origin lies between, with its
/// weights. Returns false when the origin is inside.
bool reduce(Simplex& simplex);

/// How a support point is found again when its body has moved: the vertex of a polyhedron, of other
/// cores a direction in the frame of the body. Whatever the digits of the direction, the point lies
/// on the core.
struct SupportKey {
    std::uint32_t vertex = 0;
    std::array<float, 3> direction{};
};

/// What a pair keeps of its last search: the direction and the simplex. All zero: nothing.
struct SearchStart {
    StoredVec3 direction;  ///< unit, from j towards i
    std::uint64_t count = 0;
    std::array<SupportKey, 3> a{}, b{};
};

struct CoreDistance {
    bool overlaps = false;        ///< the cores do: then nothing else is known
    double distance = 0.0;        ///< [m]
    double proven = 0.0;          ///< lower bound of it, along the normal [m]
    Vec3 normal = Vec3::UnitZ();  ///< unit, from j towards i
    Vec3 point_i, point_j;        ///< nearest points; of parallel faces, some
    int evaluations = 0;          ///< of support points
    Simplex simplex;              ///< that the search ended with
};

namespace gjk {

/// Bound of the error of the distance, relative to the size of the bodies: support points and their
/// products are rounded to a few 1e-16 of it.
inline constexpr double tolerance = 2e-14;
inline constexpr int most_evaluations = 128;

template <class CoreI, class CoreJ>
SimplexPoint support(const CoreI& i, const CoreJ& j, const Vec3& direction, std::uint32_t start_a,
                     std::uint32_t start_b) {
    const CorePoint a = i.support(direction, start_a);
    const CorePoint b = j.support(-direction, start_b);
    return {a.position - b.position, a.position, b.position, a.vertex, b.vertex};
}

inline bool holds(const Simplex& simplex, const SimplexPoint& p) {
    for (int k = 0; k < simplex.count; ++k)
        if (simplex.point[static_cast<std::size_t>(k)].w == p.w) return true;
    return false;
}

template <class CoreI, class CoreJ>
Simplex first_simplex(const CoreI& i, const CoreJ& j, const SearchStart& start,
                      const Vec3& direction) {
    Simplex s;
    if constexpr (CoreI::has_keys && CoreJ::has_keys) {
        for (std::size_t k = 0; k < start.count; ++k) {
            const Vec3 a = i.recalled(start.a[k]);
            const Vec3 b = j.recalled(start.b[k]);
            s.point[k] = {a - b, a, b, start.a[k].vertex, start.b[k].vertex};
        }
        s.count = static_cast<int>(start.count);
    }
    if (s.count == 0 || !reduce(s)) {
        s.point[0] = support(i, j, -direction, 0, 0);
        s.weight[0] = 1.0;
        s.count = 1;
    }
    return s;
}

}  // namespace gjk

/// Distance of two cores. `start`: what a search a moment ago left, or a direction alone. `error`:
/// of the distance, as much as is of no concern [m]; rounding is added. Ends after finitely many
/// steps: each takes a point that lessens the distance by more than rounding, else the simplex
/// before it stands.
template <class CoreI, class CoreJ>
CoreDistance core_distance(const CoreI& i, const CoreJ& j, const SearchStart& start, double error) {
    CoreDistance result;
    const double rounding = gjk::tolerance * (i.size + j.size);
    Simplex s = gjk::first_simplex(i, j, start, start.direction);
    Vec3 v = s.nearest();
    double v2 = v.squaredNorm();
    for (;;) {
        const double length = std::sqrt(v2);
        if (length <= 10.0 * rounding) {
            result.overlaps = true;
            result.simplex = s;
            return result;
        }
        if (result.evaluations == gjk::most_evaluations) break;
        const SimplexPoint& last = s.point[0];
        const SimplexPoint p = gjk::support(i, j, -v, last.vertex_a, last.vertex_b);
        ++result.evaluations;
        const double proven = v.dot(p.w) / length;
        result.proven = proven;
        if (length - proven <= error + rounding || gjk::holds(s, p)) break;
        Simplex next = s;
        next.point[static_cast<std::size_t>(next.count++)] = p;
        if (!reduce(next)) {
            result.overlaps = true;
            result.simplex = next;
            return result;
        }
        const Vec3 nearer = next.nearest();
        const double nearer2 = nearer.squaredNorm();
        if (!(nearer2 < v2)) break;
        s = next;
        v = nearer;
        v2 = nearer2;
    }
    result.distance = std::sqrt(v2);
    result.normal = v / result.distance;
    result.point_i = result.point_j = Vec3::Zero();
    for (int k = 0; k < s.count; ++k) {
        const auto n = static_cast<std::size_t>(k);
        result.point_i += s.weight[n] * s.point[n].a;
        result.point_j += s.weight[n] * s.point[n].b;
    }
    result.simplex = s;
    return result;
}

/// What to start from in the next step.
template <class CoreI, class CoreJ>
SearchStart next_start(const CoreI& i, const CoreJ& j, const CoreDistance& found) {
    SearchStart start;
    start.direction = found.normal;
    if (found.overlaps) return start;
    if constexpr (CoreI::has_keys && CoreJ::has_keys) {
        start.count = static_cast<std::uint64_t>(found.simplex.count);
        for (std::size_t k = 0; k < start.count; ++k) {
            const SimplexPoint& p = found.simplex.point[k];
            start.a[k] = i.key(p.a, p.vertex_a);
            start.b[k] = j.key(p.b, p.vertex_b);
        }
    }
    return start;
}

}  // namespace dem::runtime
