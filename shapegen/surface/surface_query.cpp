// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/surface/surface_query.hpp"

#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dem::shapegen {
namespace {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = ExactKernel::Point_2;
using Point3 = ExactKernel::Point_3;

Point2 flat(const Vec3& p) {
    return {p.x(), p.y()};
}
Point3 solid(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

/// +1 or -1 when the edge from a to b, seen along z, passes the ray to +x from p upwards or
/// downwards. The lower end belongs to the edge, the upper does not, and an edge through p counts
/// as left of it: as if p were moved by an infinitesimal step along +y and a smaller one along +x.
/// Both triangles of an edge ask the same exact predicate, so nothing is counted twice or missed.
int crossing(const Vec3& a, const Vec3& b, const Vec3& p) {
    const bool a_below = a.y() <= p.y();
    const bool b_below = b.y() <= p.y();
    if (a_below == b_below) return 0;
    const Vec3& low = a_below ? a : b;
    const Vec3& high = a_below ? b : a;
    if (CGAL::orientation(flat(low), flat(high), flat(p)) != CGAL::LEFT_TURN) return 0;
    return a_below ? 1 : -1;
}

}  // namespace

SurfaceQuery::SurfaceQuery(TriangleMesh mesh) : mesh_(std::move(mesh)), tree_(mesh_) {}

bool SurfaceQuery::is_inside(const Vec3& p) const {
    // The winding number of the surface around p: the ray along +z leaves the solid through
    // triangles that are counter-clockwise seen from above, and enters it through the others.
    int winding = 0;
    bool is_on_surface = false;
    tree_.visit_above(p, [&](std::uint32_t index) {
        const auto& triangle = mesh_.triangles[index];
        const Vec3& a = mesh_.vertices[triangle[0]];
        const Vec3& b = mesh_.vertices[triangle[1]];
        const Vec3& c = mesh_.vertices[triangle[2]];
        const int turn = crossing(a, b, p) + crossing(b, c, p) + crossing(c, a, p);
        const bool may_hold_p = p.z() >= std::min({a.z(), b.z(), c.z()});
        if (turn == 0 && !may_hold_p) return;
        const auto side = CGAL::orientation(solid(a), solid(b), solid(c), solid(p));
        if (side == CGAL::COPLANAR && may_hold_p &&
            !CGAL::collinear(solid(a), solid(b), solid(c)) &&
            ExactKernel::Triangle_3(solid(a), solid(b), solid(c)).has_on(solid(p)))
            is_on_surface = true;
        // The orientation is positive above a triangle that turns counter-clockwise.
        if (turn != 0 && static_cast<int>(side) * turn < 0) winding += turn;
    });
    return is_on_surface || winding > 0;
}

double SurfaceQuery::signed_distance(const Vec3& p) const {
    const double unsigned_distance = distance(p);
    return is_inside(p) ? -unsigned_distance : unsigned_distance;
}

}  // namespace dem::shapegen
