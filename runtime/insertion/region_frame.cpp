// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/region_frame.hpp"

#include "runtime/contact/pairs/touch.hpp"

namespace dem::runtime {

RegionFrame::RegionFrame(const Region& region) {
    if (const auto* box = std::get_if<BoxRegion>(&region)) {
        axes_ = Mat3::Identity();
        corner_ = box->box.lower;
        size_ = box->box.upper - box->box.lower;
        return;
    }
    const auto& cylinder = std::get<CylinderRegion>(region);
    const Vec3 along = cylinder.to - cylinder.from;
    axes_ = orientation_towards(along).toRotationMatrix();
    radius_ = cylinder.radius;
    size_ = {2.0 * radius_, 2.0 * radius_, along.norm()};
    corner_ = cylinder.from - radius_ * (axes_.col(0) + axes_.col(1));
}

RegionFrame::Reach RegionFrame::reach(const ParticleTemplate& shape,
                                      const Quat& orientation) const {
    Reach r;
    for (int k = 0; k < 3; ++k) {
        r.above[k] = extent(shape, orientation, axes_.col(k));
        r.below[k] = extent(shape, orientation, -axes_.col(k));
    }
    return r;
}

bool RegionFrame::contains(const ParticleTemplate& shape, const BodyPlacement& body) const {
    const Reach r = reach(shape, body.orientation);
    const Vec3 local = axes_.transpose() * Vec3(body.position - corner_);
    return (local.array() >= r.below.array()).all() &&
           (local.array() <= (size_ - r.above).array()).all() && is_within_side(shape, body);
}

bool RegionFrame::is_within_side(const ParticleTemplate& shape, const BodyPlacement& body) const {
    if (radius_ == 0.0) return true;
    const Vec3 local = axes_.transpose() * Vec3(body.position - corner_);
    const double radial = (local.head<2>() - Vec2::Constant(radius_)).norm();
    if (radial + shape.bounding_radius <= radius_) return true;
    if (radial >= radius_) return false;
    PairState pair;
    pair.displacement = at({radius_, radius_, 0.0}) - body.position;
    pair.i.orientation = body.orientation;
    pair.j.orientation = Quat(axes_);
    return !touches(shape, WallShape(CylinderWall{.radius = radius_}), pair);
}

std::optional<Vec3> RegionFrame::sample(Random& random, const ParticleTemplate& shape,
                                        const Quat& orientation) const {
    const Reach r = reach(shape, orientation);
    const Vec3 room = size_ - r.below - r.above;
    // One draw per axis, z first, whatever the outcome: a try always costs the same random numbers.
    Vec3 u;
    for (const int axis : {2, 1, 0}) u[axis] = random.uniform();
    if ((room.array() < 0.0).any()) return std::nullopt;
    BodyPlacement body;
    body.orientation = orientation;
    body.position = at(r.below + u.cwiseProduct(room));
    if (!is_within_side(shape, body)) return std::nullopt;
    return body.position;
}

}  // namespace dem::runtime
