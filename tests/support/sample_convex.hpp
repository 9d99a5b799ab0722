// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"
#include "shapegen/solids/make_convex.hpp"
#include "tests/support/hull_by_force.hpp"

#include <string>
#include <utility>
#include <vector>

namespace dem::test {

using namespace shapegen;

/// `count` random points on an ellipsoid.
inline std::vector<Vec3> random_points(std::size_t count, const Vec3& semi_axes,
                                       std::uint64_t seed) {
    Random random(seed, count);
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < count; ++k)
        points.emplace_back(random.direction().cwiseProduct(semi_axes));
    return points;
}

/// The hull of a few points, rounded.
inline ConvexSolid rounded_hull(std::span<const Vec3> points, double rounding) {
    return make_convex_polyhedron(points, rounding, hull_by_force);
}

inline ConvexSolid random_polyhedron(std::size_t count, std::uint64_t seed, double rounding) {
    return rounded_hull(random_points(count, {1.0, 1.2, 0.8}, seed), rounding);
}

/// Corners of a regular tetrahedron of this edge length.
inline std::vector<Vec3> tetrahedron_corners(double edge) {
    const double h = 0.5 * edge / std::sqrt(2.0);
    return {{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}};
}

/// One or more of every kind, of sizes around one.
inline std::vector<std::pair<std::string, ConvexSolid>> convex_solids() {
    std::vector<std::pair<std::string, ConvexSolid>> solids;
    solids.emplace_back("sphere", make_convex_sphere(0.7));
    solids.emplace_back("capsule", make_capsule(0.4, 2.0));
    solids.emplace_back("rounded disc", make_rounded_disc(1.0, 0.3));
    solids.emplace_back("ellipsoid", make_ellipsoid({1.2, 0.8, 0.5}));
    solids.emplace_back("spheroid", make_ellipsoid({0.5, 0.5, 1.1}));
    solids.emplace_back("cylinder", make_cylinder(0.6, 1.4, 0.05));
    solids.emplace_back("cone", make_cone(0.8, 1.5, 0.06));
    solids.emplace_back("cuboid", make_cuboid({1.0, 1.4, 0.6}, 0.04));
    solids.emplace_back("tetrahedron", rounded_hull(tetrahedron_corners(1.5), 0.03));
    solids.emplace_back("grain", random_polyhedron(20, 1, 0.02));
    return solids;
}

}  // namespace dem::test
