// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/surface_distance.hpp"

#include "common/shapes/sdf_quadtree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace dem {
namespace {

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
    const double length = v.norm();
    return length > 0.0 ? Vec3(v / length) : otherwise;
}

/// Calls visit(sphere) for each sphere with a point within `reach` of x.
template <class Visit>
void visit_near(const Clump& clump, const Vec3& x, double reach, const Visit& visit) {
    const ClumpLevels levels(clump.spheres.size(), {clump.balls.data(), clump.balls.size()});
    const auto is_far = [&](const auto& ball) {
        return (ball.center() - x).squaredNorm() > square(ball.radius + reach);
    };
    visit_spheres({clump.spheres.data(), clump.spheres.size()}, levels, is_far,
                  [&](std::uint32_t k) {
                      if (!is_far(clump.spheres[k])) visit(clump.spheres[k]);
                  });
}

bool holds(const Clump& clump, const Vec3& x) {
    bool is_held = false;
    visit_near(clump, x, 0.0, [&](const ClumpSphere&) { is_held = true; });
    return is_held;
}

/// The circle in which two spheres meet, if they do.
struct Circle {
    Vec3 center, axis;  ///< axis: unit, from the first sphere to the second
    double radius;
};
std::optional<Circle> meeting_circle(const ClumpSphere& a, const ClumpSphere& b) {
    const Vec3 between = b.center() - a.center();
    const double d = between.norm();
    if (d >= a.radius + b.radius || d <= std::abs(a.radius - b.radius)) return std::nullopt;
    const double along = (square(d) + square(a.radius) - square(b.radius)) / (2.0 * d);
    const Vec3 axis = between / d;
    return Circle{a.center() + along * axis, axis,
                  std::sqrt(std::max(square(a.radius) - square(along), 0.0))};
}

/// The point of the surface of a union of spheres that is nearest to a point inside: the nearest
/// one of a sphere, of a circle where two meet, or a corner where three meet, that no other sphere
/// holds.
class NearestFromInside {
  public:
    NearestFromInside(const Clump& clump, const Vec3& x) : x_(x) {
        // No surface point is nearer than that of the deepest sphere. Spheres of which all points
        // are farther than the best one so far neither offer a nearer one nor hold it.
        double reach = 1.01 * depth_in_deepest(clump);
        for (;;) {
            spheres_.clear();
            visit_near(clump, x, reach, [&](const ClumpSphere& s) { spheres_.push_back(s); });
            tolerance_ = 1e-10 * largest_extent();
            best_ = infinite;
            search();
            if (best_ <= reach || spheres_.size() == clump.spheres.size()) break;
            reach = std::min(2.0 * reach, best_);
        }
    }

    SurfaceDistance answer() const { return {-best_, unit_or(point_ - x_, normal_)}; }

  private:
    double depth_in_deepest(const Clump& clump) const {
        double depth = 0.0;
        visit_near(clump, x_, 0.0, [&](const ClumpSphere& s) {
            depth = std::max(depth, s.radius - (x_ - s.center()).norm());
        });
        return std::max(depth, 1e-9 * clump.largest_radius);
    }
    double largest_extent() const {
        double extent = 0.0;
        for (const ClumpSphere& s : spheres_)
            extent = std::max(extent, (s.center() - x_).norm() + s.radius);
        return extent;
    }

    bool is_exposed(const Vec3& p) const {
        return std::none_of(spheres_.begin(), spheres_.end(), [&](const ClumpSphere& s) {
            return (p - s.center()).norm() < s.radius - tolerance_;
        });
    }
    void offer(const Vec3& p, const Vec3& normal) {
        const double distance = (p - x_).norm();
        if (distance >= best_ || !is_exposed(p)) return;
        best_ = distance;
        point_ = p;
        normal_ = normal;
    }

    void search() {
        for (const ClumpSphere& s : spheres_) {
            const Vec3 way = unit_or(x_ - s.center(), Vec3::UnitX());
            offer(s.center() + s.radius * way, way);
        }
        for (std::size_t i = 0; i < spheres_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) search_circle(i, j);
    }

    void search_circle(std::size_t i, std::size_t j) {
        const auto circle = meeting_circle(spheres_[i], spheres_[j]);
        if (!circle) return;
        const Vec3 off = x_ - circle->center;
        const double height = off.dot(circle->axis);
        const Vec3 in_plane = off - height * circle->axis;
        const double nearest = std::sqrt(square(height) + square(in_plane.norm() - circle->radius));
        if (nearest >= best_) return;
        const Vec3 way = unit_or(in_plane, circle->axis.unitOrthogonal());
        const Vec3 p = circle->center + circle->radius * way;
        offer(p, unit_or(p - spheres_[i].center(), way));
        for (std::size_t k = 0; k < j; ++k) offer_corners(*circle, spheres_[k]);
    }

    /// The points of the circle on a third sphere.
    void offer_corners(const Circle& circle, const ClumpSphere& third) {
        const Vec3 off = third.center() - circle.center;
        const double height = off.dot(circle.axis);
        const Vec3 in_plane = off - height * circle.axis;
        const double distance = in_plane.norm();
        const double radius2 = square(third.radius) - square(height);  // of its cut with the plane
        if (radius2 <= 0.0 || distance <= 0.0) return;
        const double along =
            (square(distance) + square(circle.radius) - radius2) / (2.0 * distance);
        const double half2 = square(circle.radius) - square(along);
        if (half2 < 0.0) return;
        const Vec3 way = in_plane / distance;
        const Vec3 side = std::sqrt(half2) * circle.axis.cross(way);
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 p = circle.center + along * way + sign * side;
            offer(p, unit_or(p - third.center(), way));
        }
    }

    Vec3 x_;
    std::vector<ClumpSphere> spheres_;
    double tolerance_ = 0.0;
    double best_ = infinite;
    Vec3 point_ = Vec3::Zero();
    Vec3 normal_ = Vec3::UnitZ();
};

/// The nearest point of the profile, a line from sample to sample.
Vec2 nearest_on_profile(const SrShape& shape, const Vec2& x) {
    Vec2 best(shape.curvature[0].r, shape.curvature[0].z);
    double least = (x - best).squaredNorm();
    for (std::size_t i = 1; i < shape.curvature.size(); ++i) {
        const Vec2 a(shape.curvature[i - 1].r, shape.curvature[i - 1].z);
        const Vec2 along = Vec2(shape.curvature[i].r, shape.curvature[i].z) - a;
        const double length2 = along.squaredNorm();
        const double t = length2 > 0.0 ? std::clamp((x - a).dot(along) / length2, 0.0, 1.0) : 0.0;
        const Vec2 p = a + t * along;
        if ((x - p).squaredNorm() >= least) continue;
        least = (x - p).squaredNorm();
        best = p;
    }
    return best;
}

bool is_in_grid(const SdfQuadtree& sdf, double r, double z) {
    const double u = (r - sdf.origin_r) / sdf.base_size;
    const double v = (z - sdf.origin_z) / sdf.base_size;
    return u >= 0.0 && u <= sdf.cells_r && v >= 0.0 && v <= sdf.cells_z;
}

}  // namespace

SurfaceDistance surface_distance(const Sphere& sphere, const Vec3& x) {
    const double distance = x.norm();
    return {distance - sphere.radius, distance > 0.0 ? Vec3(x / distance) : Vec3::UnitZ()};
}

SurfaceDistance surface_distance(const SrShape& shape, const Vec3& x) {
    const double r = std::sqrt(square(x.x()) + square(x.y()));
    const Vec3 radial = r > 0.0 ? Vec3(x.x() / r, x.y() / r, 0.0) : Vec3::UnitX();
    const auto in_space = [&](double along_r, double along_z) -> Vec3 {
        return along_r * radial + along_z * Vec3::UnitZ();
    };
    const SdfSample here = interpolate(shape.sdf, r, x.z());
    if (std::abs(here.distance) <= shape.sdf.surface_band && is_in_grid(shape.sdf, r, x.z()))
        return {here.distance,
                unit_or(in_space(r > 0.0 ? here.d_dr : 0.0, here.d_dz), Vec3::UnitZ())};
    // Farther away the grid is coarser, and ends. Between two samples of the profile the surface
    // bulges out by what the field says there.
    const Vec2 chord = nearest_on_profile(shape, {r, x.z()});
    const SdfSample there = interpolate(shape.sdf, chord.x(), chord.y());
    const Vec2 p = chord - there.distance * Vec2(there.d_dr, there.d_dz).normalized();
    const Vec3 away = in_space(r - p.x(), x.z() - p.y());
    const double sign = here.distance < 0.0 ? -1.0 : 1.0;
    return {sign * away.norm(), sign * away.normalized()};
}

SurfaceDistance surface_distance(const Clump& clump, const Vec3& x) {
    if (holds(clump, x)) return NearestFromInside(clump, x).answer();
    SurfaceDistance best{infinite, Vec3::UnitZ()};
    const ClumpLevels levels(clump.spheres.size(), {clump.balls.data(), clump.balls.size()});
    visit_spheres(
        {clump.spheres.data(), clump.spheres.size()}, levels,
        [&](const Clump::Ball& ball) {
            return (ball.center() - x).norm() - ball.radius > best.distance;
        },
        [&](std::uint32_t k) {
            const ClumpSphere& s = clump.spheres[k];
            const Vec3 way = x - s.center();
            const double distance = way.norm() - s.radius;
            if (distance < best.distance) best = {distance, unit_or(way, Vec3::UnitZ())};
        });
    return best;
}

SurfaceDistance surface_distance(const ParticleTemplate& shape, const Vec3& x) {
    return std::visit([&](const auto& s) { return surface_distance(s, x); }, shape.shape);
}

bool is_inside(const ParticleTemplate& shape, const Vec3& x) {
    if (x.squaredNorm() > square(shape.bounding_radius)) return false;
    if (const auto* clump = std::get_if<Clump>(&shape.shape)) return holds(*clump, x);
    if (const auto* sr = std::get_if<SrShape>(&shape.shape))
        return interpolate(sr->sdf, std::sqrt(square(x.x()) + square(x.y())), x.z()).distance <=
               0.0;
    return surface_distance(shape, x).distance <= 0.0;
}

}  // namespace dem
