// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/outlets/outlet.hpp"

namespace dem::runtime {

namespace {

double height(const HalfSpace& space, const Vec3& x) {
    return space.normal.dot(x - space.point);
}

}  // namespace

bool holds(const Outlet& outlet, const Vec3& x) {
    if (const auto* space = std::get_if<HalfSpace>(&outlet.place)) return height(*space, x) < 0.0;
    if (const auto* box = std::get_if<BoxRegion>(&outlet.place)) return contains(*box, x);
    return contains(std::get<CylinderRegion>(outlet.place), x);
}

bool may_hold(const Outlet& outlet, const Region& region) {
    if (const auto* space = std::get_if<HalfSpace>(&outlet.place))
        return -support(region, -space->normal) < space->normal.dot(space->point);
    const auto* box = std::get_if<BoxRegion>(&outlet.place);
    const Aabb own = box != nullptr ? box->box : bounds(std::get<CylinderRegion>(outlet.place));
    return overlaps(own, bounds(region));
}

}  // namespace dem::runtime
