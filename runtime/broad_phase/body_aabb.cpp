// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/broad_phase/body_aabb.hpp"

#include "common/shapes/support_map.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace dem::runtime {

namespace {

// Largest and smallest z and largest r of the profile, from its samples and its nodes.
template <class Cylinder>
Cylinder bounding_cylinder(const SrShape& shape) {
    Cylinder c{shape.bottom_z, shape.top_z, shape.max_radius};
    double longest_step = 0.0;
    for (std::size_t k = 0; k < shape.curvature.size(); ++k) {
        const CurvatureSample& s = shape.curvature[k];
        c.low = std::min(c.low, s.z);
        c.high = std::max(c.high, s.z);
        if (k > 0) {
            longest_step = std::max(longest_step, s.arc_length - shape.curvature[k - 1].arc_length);
        }
    }
    // Between two samples the profile rises above both by at most half the arc between them.
    c.low -= 0.5 * longest_step;
    c.high += 0.5 * longest_step;
    return c;
}

// Extent of a convex shape along a direction that makes `cosine` with its axis.
double support_extent(const SrShape& shape, double cosine) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const SupportPoint p = support_point(shape.support, sine, cosine);
    return p.r * sine + p.z * cosine;
}

Aabb box_of(const ConvexShape& shape, const Vec3& position, const Quat& orientation) {
    const Mat3 to_body = orientation.toRotationMatrix().transpose();
    Aabb box{position, position};
    for (int k = 0; k < 3; ++k) {
        box.upper[k] += extent(shape, to_body.col(k));
        box.lower[k] -= extent(shape, -to_body.col(k));
    }
    return box;
}

Aabb box_of(const Clump& clump, const Vec3& position, const Quat& orientation) {
    const Mat3 to_world = orientation.toRotationMatrix();
    Aabb box{position, position};
    for (const ClumpSphere& s : clump.spheres) {
        const Vec3 center = position + to_world * s.center();
        box.lower = box.lower.cwiseMin(center - Vec3::Constant(s.radius));
        box.upper = box.upper.cwiseMax(center + Vec3::Constant(s.radius));
    }
    return box;
}

}  // namespace

BodyAabbs::BodyAabbs(const std::vector<ParticleTemplate>& shapes) : shapes_(&shapes) {
    for (const ParticleTemplate& shape : shapes) {
        const auto* sr = std::get_if<SrShape>(&shape.shape);
        cylinders_.push_back(sr != nullptr ? bounding_cylinder<Cylinder>(*sr) : Cylinder{});
    }
}

Aabb BodyAabbs::box(std::uint32_t shape, const Vec3& position, const Quat& orientation) const {
    const auto& geometry = (*shapes_)[shape].shape;
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
        const Vec3 half = Vec3::Constant(sphere->radius);
        return {position - half, position + half};
    }
    if (const auto* clump = std::get_if<Clump>(&geometry)) {
        return box_of(*clump, position, orientation);
    }
    if (const auto* convex = std::get_if<ConvexShape>(&geometry)) {
        return box_of(*convex, position, orientation);
    }
    const auto& sr = *std::get_if<SrShape>(&geometry);
    const Cylinder& cylinder = cylinders_[shape];
    const Vec3 axis = orientation * Vec3::UnitZ();
    Aabb box{position, position};
    for (int k = 0; k < 3; ++k) {
        const double cosine = std::clamp(axis[k], -1.0, 1.0);
        if (sr.is_convex) {
            box.upper[k] += support_extent(sr, cosine);
            box.lower[k] -= support_extent(sr, -cosine);
        } else {
            const double across = cylinder.radius * std::sqrt(1.0 - cosine * cosine);
            box.upper[k] += across + std::max(cylinder.high * cosine, cylinder.low * cosine);
            box.lower[k] -= across - std::min(cylinder.high * cosine, cylinder.low * cosine);
        }
    }
    return box;
}

}  // namespace dem::runtime
