// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/solids/make_convex.hpp"
#include "tests/support/sample_convex.hpp"

#include <vector>

namespace dem::test {

using namespace runtime;
using namespace shapegen;

struct Combination {
    const char* name;
    ConvexSolid a, b;
};

/// The eight combinations of [GC] Sec. 6.2; bodies of about `size` [m], those with edges rounded by
/// a hundredth of it.
inline std::vector<Combination> combinations(double size) {
    const double r = 0.01 * size;
    const auto ball = make_convex_sphere(0.5 * size);
    const auto egg = make_ellipsoid(size * Vec3(0.7, 0.5, 0.35));
    const auto cylinder = make_cylinder(0.45 * size, 0.9 * size, r);
    const auto tetrahedron = rounded_hull(tetrahedron_corners(1.3 * size), r);
    const auto cube = make_cuboid(Vec3::Constant(0.8 * size), r);
    return {{"sphere - sphere", ball, ball},
            {"ellipsoid - ellipsoid", egg, egg},
            {"cylinder - cylinder", cylinder, cylinder},
            {"tetrahedron - tetrahedron", tetrahedron, tetrahedron},
            {"cube - cube", cube, cube},
            {"cube - sphere", cube, ball},
            {"cube - cylinder", cube, cylinder},
            {"ellipsoid - tetrahedron", egg, tetrahedron}};
}

}  // namespace dem::test
