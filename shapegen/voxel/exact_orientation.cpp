// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/voxel/exact_orientation.hpp"

// clang's analyzer takes the small-number pool of this number type of CGAL for a wrong delete.
#ifdef __clang_analyzer__
#define CGAL_DO_NOT_USE_MPZF
#endif
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dem::shapegen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 point(const Vec2& p) {
    return {p.x(), p.y()};
}

Kernel::Point_3 point(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

}  // namespace

int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

}  // namespace dem::shapegen
