// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/region.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"

#include <algorithm>
#include <sstream>

namespace dem::runtime {

namespace {

/// Rounding of the case file's decimals, relative to the sizes compared.
constexpr double tolerance = 1e-9;

/// Points whose convex hull is the region: the corners, or points on the rims (360 of them: a hull
/// too small by 4e-5 of the radius, and bodies are tested exactly later).
std::vector<Vec3> hull(const Region& region) {
    std::vector<Vec3> points;
    if (const auto* box = std::get_if<BoxRegion>(&region)) {
        for (int k = 0; k < 8; ++k) {
            const Vec3 upper_here((k & 1) != 0, (k & 2) != 0, (k & 4) != 0);
            points.push_back(box->box.lower +
                             upper_here.cwiseProduct(box->box.upper - box->box.lower));
        }
        return points;
    }
    const auto& cylinder = std::get<CylinderRegion>(region);
    const Vec3 axis = (cylinder.to - cylinder.from).normalized();
    const Vec3 u = axis.unitOrthogonal();
    const Vec3 v = axis.cross(u);
    constexpr int rim_points = 360;
    for (int k = 0; k < rim_points; ++k) {
        const double phi = 2.0 * pi * k / rim_points;
        const Vec3 radial = cylinder.radius * (math::cos(phi) * u + math::sin(phi) * v);
        points.push_back(cylinder.from + radial);
        points.push_back(cylinder.to + radial);
    }
    return points;
}

/// How far the region reaches into the wall [m]; <= 0: not at all.
double depth(const Region& region, const Wall& wall, double time) {
    const WallFrame frame = wall_state(wall, time).frame();
    const double start = frame.axis.dot(frame.origin);
    const double low = -support(region, -frame.axis) - start;
    const double high = support(region, frame.axis) - start;
    return std::visit(
        [&]<class Shape>(const Shape& shape) {
            if (!shape.confines(low, high)) return 0.0;
            if constexpr (FieldWall<Shape>) {
                return shape.with_field(frame, 0.0, [&](const auto& field) {
                    double deepest = 0.0;
                    for (const Vec3& point : hull(region))
                        deepest = std::max(deepest, -field.sample(point).distance);
                    return deepest;
                });
            } else {
                return 0.0;
            }
        },
        wall.shape);
}

}  // namespace

void check_region(const InsertionGroup& group, const std::vector<Wall>& walls,
                  const std::optional<Aabb>& domain) {
    const Aabb box = bounds(group.region);
    if (domain && !(domain->contains(box.lower) && domain->contains(box.upper))) {
        throw Error(group.where, "the region of [particles." + group.name +
                                     "] reaches out of the domain, expected it inside");
    }
    const double size = (box.upper - box.lower).norm() + box.upper.norm() + box.lower.norm();
    for (const Wall& wall : walls) {
        const double reach = depth(group.region, wall, group.start);
        if (reach <= tolerance * size) continue;
        std::ostringstream message;
        message << "the region of [particles." << group.name << "] reaches " << reach * 1e3
                << " mm into wall '" << wall.name << "', expected it inside the walls";
        throw Error(group.where, message.str());
    }
}

}  // namespace dem::runtime
