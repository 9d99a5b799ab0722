// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/solids/convex_polyhedron.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

namespace dem::shapegen {

Vec3 ConvexPolyhedron::normal(std::size_t face) const {
    // Newell's sum over the outline: no corner matters more than its size.
    const auto& f = faces[face];
    Vec3 sum = Vec3::Zero();
    const Vec3& origin = vertices[f[0]];
    for (std::size_t k = 1; k + 1 < f.size(); ++k)
        sum += (vertices[f[k]] - origin).cross(vertices[f[k + 1]] - origin);
    return sum.normalized();
}

double ConvexPolyhedron::offset(std::size_t face, const Vec3& n) const {
    double most = n.dot(vertices[faces[face][0]]);
    for (const std::uint32_t p : faces[face]) most = std::max(most, n.dot(vertices[p]));
    return most;
}

ConvexPolyhedron eroded(const ConvexPolyhedron& solid, double depth, const HullOfPoints& hull) {
    if (depth == 0.0) return solid;
    Vec3 center = Vec3::Zero();
    for (const Vec3& v : solid.vertices) center += v;
    center /= static_cast<double>(solid.vertices.size());
    // Polar dual about the center: planes n . x = c become points n / c, and back.
    std::vector<Vec3> dual;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        const Vec3 n = solid.normal(f);
        const double distance = solid.offset(f, n) - n.dot(center);
        least = std::min(least, distance);
        dual.push_back(n / (distance - depth));
    }
    if (!(least > depth)) {
        std::ostringstream message;
        message << "rounding radius " << depth << " m, expected less than " << least
                << " m, the distance from the center to the nearest face";
        throw Error("convex shape", message.str());
    }
    const ConvexPolyhedron polar = hull(dual);
    std::vector<Vec3> corners;
    for (std::size_t f = 0; f < polar.faces.size(); ++f) {
        const Vec3 m = polar.normal(f);
        corners.push_back(center + m / polar.offset(f, m));
    }
    return hull(corners);
}

}  // namespace dem::shapegen
