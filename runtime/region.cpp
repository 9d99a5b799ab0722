// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/region.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>

namespace dem::runtime {

double volume(const Region& region) {
    if (const auto* box = std::get_if<BoxRegion>(&region)) {
        return (box->box.upper - box->box.lower).prod();
    }
    const auto& cylinder = std::get<CylinderRegion>(region);
    return pi * square(cylinder.radius) * (cylinder.to - cylinder.from).norm();
}

Aabb bounds(const Region& region) {
    Aabb box;
    for (int k = 0; k < 3; ++k) {
        box.upper[k] = support(region, Vec3::Unit(k));
        box.lower[k] = -support(region, -Vec3::Unit(k));
    }
    return box;
}

double support(const Region& region, const Vec3& n) {
    if (const auto* box = std::get_if<BoxRegion>(&region)) {
        return n.cwiseProduct(box->box.lower).cwiseMax(n.cwiseProduct(box->box.upper)).sum();
    }
    const auto& cylinder = std::get<CylinderRegion>(region);
    const Vec3 axis = (cylinder.to - cylinder.from).normalized();
    return std::max(n.dot(cylinder.from), n.dot(cylinder.to)) +
           cylinder.radius * n.cross(axis).norm();
}

bool contains(const Region& region, const Vec3& x) {
    if (const auto* box = std::get_if<BoxRegion>(&region)) return box->box.contains(x);
    const auto& cylinder = std::get<CylinderRegion>(region);
    const Vec3 along = cylinder.to - cylinder.from;
    const Vec3 off = x - cylinder.from;
    const double length = along.norm();
    const double height = off.dot(along) / length;
    return height >= 0.0 && height <= length &&
           (off - height / length * along).squaredNorm() <= square(cylinder.radius);
}

}  // namespace dem::runtime
