// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/solid_fraction.hpp"

#include "common/math/elementary.hpp"
#include "common/shapes/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem::runtime {
namespace {

constexpr int point_count = 40'000;

/// Points that fill a layer of a vessel evenly, in rising height: a Hammersley set with the
/// two-dimensional sequence of Roberts, whose steps are powers of 1/1.3247 (x^3 = x + 1).
struct VesselPoints {
    std::vector<Vec3> points;           ///< world [m]
    std::vector<double> from_the_wall;  ///< distance from the nearest side wall [m]

    VesselPoints(const Vessel& vessel, const Layer& layer) {
        const Vec3 bottom =
            vessel.center +
            (vessel.floor + layer.bottom - vessel.center.dot(vessel.up)) * vessel.up;
        const Vec3 other = vessel.up.cross(vessel.side);
        for (int n = 0; n < point_count; ++n) {
            const double u = std::fmod(0.5 + 0.7548776662466927 * n, 1.0);
            const double v = std::fmod(0.5 + 0.5698402909980532 * n, 1.0);
            const double w = (n + 0.5) / point_count;
            const Vec2 place =
                vessel.shape == Vessel::Shape::box ? in_box(vessel, u, v) : in_circle(vessel, u, v);
            points.push_back(bottom + place.x() * vessel.side + place.y() * other +
                             w * (layer.top - layer.bottom) * vessel.up);
        }
    }

  private:
    Vec2 in_circle(const Vessel& vessel, double u, double v) {
        const double r = vessel.radius * std::sqrt(u);
        from_the_wall.push_back(vessel.radius - r);
        return {r * math::cos(2.0 * pi * v), r * math::sin(2.0 * pi * v)};
    }
    Vec2 in_box(const Vessel& vessel, double u, double v) {
        const double depth = vessel.cross_section / vessel.width;
        Vec2 place((u - 0.5) * vessel.width, (v - 0.5) * depth);
        from_the_wall.push_back(
            std::min(0.5 * vessel.width - std::abs(place.x()), 0.5 * depth - std::abs(place.y())));
        return place;
    }
};

}  // namespace

double mean_diameter(const Particles& particles, const Scene& scene) {
    double sum = 0.0;
    for (const std::uint32_t kind : particles.kind) {
        sum += equivalent_diameter(scene.shapes[scene.kinds[kind].shape].mass_properties.volume);
    }
    return sum / static_cast<double>(particles.size());
}

SolidFraction solid_fraction(const Particles& particles, const Scene& scene, const Vessel& vessel,
                             const Layer& layer) {
    SolidFraction result;
    const double height = layer.top - layer.bottom;
    if (particles.size() == 0 || !(height > 0.0)) return result;
    const VesselPoints vessel_points(vessel, layer);
    const std::vector<Vec3>& points = vessel_points.points;
    std::vector<double> density(points.size(), 0.0);  // 0: no particle there
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const BodyKind& kind = scene.kinds[particles.kind[i]];
        const ParticleTemplate& shape = scene.shapes[kind.shape];
        const Vec3& center = particles.position[i];
        const Quat to_body = particles.orientation[i].conjugate();
        const double middle = center.dot(vessel.up) - vessel.floor - layer.bottom;
        const auto number = [&](double z) {
            return static_cast<std::size_t>(std::clamp(z / height, 0.0, 1.0) * point_count);
        };
        const std::size_t last =
            std::min(number(middle + shape.bounding_radius) + 1, points.size());
        for (std::size_t n = number(middle - shape.bounding_radius); n < last; ++n) {
            const Vec3 off = points[n] - center;
            if (density[n] > 0.0 || off.squaredNorm() > square(shape.bounding_radius)) continue;
            if (is_inside(shape, to_body * off))
                density[n] = kind.mass / shape.mass_properties.volume;
        }
    }
    const double diameter = mean_diameter(particles, scene);
    double mass = 0.0;  // times points per volume
    std::size_t near_wall = 0;
    std::size_t solid_near_wall = 0;
    std::size_t solid_core = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        const bool is_near = vessel_points.from_the_wall[n] < diameter;
        near_wall += is_near ? 1U : 0U;
        (is_near ? solid_near_wall : solid_core) += density[n] > 0.0 ? 1U : 0U;
        mass += density[n];
    }
    const auto share = [](std::size_t part, std::size_t whole) {
        return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
    };
    result.overall = share(solid_near_wall + solid_core, points.size());
    result.bulk_density = mass / static_cast<double>(points.size());
    result.near_wall = share(solid_near_wall, near_wall);
    result.core = share(solid_core, points.size() - near_wall);
    return result;
}

}  // namespace dem::runtime
