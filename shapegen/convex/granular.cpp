// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/granular.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"
#include "common/random.hpp"
#include "common/shapes/convex_moments.hpp"
#include "shapegen/convex/convex_display.hpp"
#include "shapegen/convex/core_scale.hpp"
#include "shapegen/convex/exact_hull.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {

namespace {

using Kind = GranularOptions::Kind;
using Base = GranularOptions::Base;

constexpr int fewest_corners = 5;
constexpr int most_sand_corners = 20;
constexpr double sand_aspect_ratio = 3.0;  // of the prolate ellipsoid, [GC 9]
/// Few: at the minimum of the energy all grains of equal count would be alike.
constexpr int relaxing_rounds = 10;
constexpr int most_draws = 1000;
constexpr double most_deviation = 0.1;  // of the rounded surface from the drawn one, in d_eq

/// To the surface of the ellipsoid along the line through its center.
Vec3 on_ellipsoid(const Vec3& p, const Vec3& axes) {
    return p / p.cwiseQuotient(axes).norm();
}

/// Moves points on an ellipsoid as charges of one sign would move, each at most a quarter of the
/// mean spacing in a round.
void relax(std::vector<Vec3>& points, const Vec3& axes) {
    const double radius = math::cbrt(axes.prod());
    const double spacing = radius * std::sqrt(4.0 * pi / static_cast<double>(points.size()));
    std::vector<Vec3> forces(points.size());
    for (int round = 0; round < relaxing_rounds; ++round) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            Vec3 force = Vec3::Zero();
            for (std::size_t j = 0; j < points.size(); ++j) {
                if (j == i) continue;
                const Vec3 apart = points[i] - points[j];
                const double distance = std::max(apart.norm(), 1e-3 * spacing);
                force += apart * square(spacing) / cube(distance);
            }
            const Vec3 normal = points[i].cwiseQuotient(axes.cwiseProduct(axes)).normalized();
            forces[i] = force - normal.dot(force) * normal;
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double push = forces[i].norm();
            if (push == 0.0) continue;
            const double step = spacing * std::min(0.1 * push, 0.25);
            points[i] = on_ellipsoid(points[i] + forces[i] * (step / push), axes);
        }
    }
}

std::vector<Vec3> sand_corners(const GranularOptions& options, Random& random) {
    const double count = random.uniform(fewest_corners, most_sand_corners + 1);
    const double radius = 0.5 * options.size;
    const double thin = radius / math::cbrt(sand_aspect_ratio);
    const Vec3 axes = options.base == Base::sphere ? Vec3(radius, radius, radius)
                                                   : Vec3(thin, thin, sand_aspect_ratio * thin);
    std::vector<Vec3> points(static_cast<std::size_t>(count));
    for (Vec3& p : points) p = random.direction().cwiseProduct(axes);
    relax(points, axes);
    return points;
}

/// [GC 8.1.2]; `size` stands for the mean length of 6 mm.
std::vector<Vec3> woodchip_corners(const GranularOptions& options, Random& random) {
    const double unit = options.size / 6.0;
    const double half_length = 0.5 * unit * random.uniform(5.0, 7.0);
    std::vector<Vec3> points;
    for (const bool is_upper : {true, false}) {
        const double radius =
            unit * (is_upper ? random.uniform(0.4, 0.7) : random.uniform(1.0, 1.3));
        for (int k = 0; k < 4; ++k) {
            const double angle = random.uniform(0.0, 2.0 * pi);
            points.emplace_back(radius * math::cos(angle), radius * math::sin(angle),
                                is_upper ? half_length : -half_length);
        }
    }
    return points;
}

/// A solid around its center of mass.
struct Centered {
    ConvexPolyhedron solid;
    double volume;
    double depth;  ///< from the center to the nearest face [m]
};

Centered centered_hull(const std::vector<Vec3>& corners) {
    Centered result{exact_hull(corners), 0.0, 0.0};
    const ConvexMoments m = convex_moments(rounded_around(result.solid, 0.0));
    for (Vec3& v : result.solid.vertices) v -= m.first / m.volume;
    result.volume = m.volume;
    result.depth = -surface_distance(rounded_around(result.solid, 0.0), Vec3::Zero()).distance;
    return result;
}

/// A core for the hull with a vertex for each of its own: the point nearest to it of the hull with
/// its planes moved inwards. (All of that would have more: where more than three planes meet, they
/// no longer meet in one point.)
ConvexPolyhedron core_of(const ConvexPolyhedron& hull, double rounding) {
    if (rounding == 0.0) return hull;
    const ConvexShape inner = rounded_around(eroded(hull, rounding, exact_hull), 0.0);
    std::vector<Vec3> nearest;
    for (const Vec3& v : hull.vertices) {
        const SurfaceDistance d = surface_distance(inner, v);
        nearest.emplace_back(v - d.distance * d.normal);
    }
    return exact_hull(nearest);
}

/// Largest distance from the surface of the polyhedron to that of the rounded body, both in the
/// same frame: where a corner stands out, or a face of the body.
double deviation(const ConvexShape& shape, const ConvexPolyhedron& solid) {
    double largest = 0.0;
    for (const Vec3& v : solid.vertices)
        largest = std::max(largest, surface_distance(shape, v).distance);
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        const Vec3 n = solid.normal(f);
        largest = std::max(largest, extent(shape, n) - solid.offset(f, n));
    }
    return largest;
}

Grain rounded_grain(const Centered& hull, double rounding) {
    ConvexPolyhedron core = core_of(hull.solid, rounding);
    const double scale = rounding > 0.0 ? core_scale(core, rounding, hull.volume) : 1.0;
    for (Vec3& v : core.vertices) v *= scale;
    Grain grain;
    grain.solid = with_mass_properties(rounded_around(core, rounding));
    const MassProperties& mass = grain.solid.mass_properties;
    grain.solid.rounding_loss = 1.0 - mass.volume / hull.volume;
    ConvexPolyhedron drawn = hull.solid;
    const Mat3 to_body = mass.principal_axes.toRotationMatrix().transpose();
    for (Vec3& v : drawn.vertices) v = to_body * (v - mass.center_of_mass);
    grain.display_mesh = display_mesh(drawn);
    grain.display_mesh.max_deviation = deviation(grain.solid.shape, drawn);
    return grain;
}

}  // namespace

Grain make_grain(const GranularOptions& options, std::uint64_t index) {
    Random random(options.seed, index);
    const Rounding rounding = options.rounding.value_or(Rounding{});
    for (int draw = 0; draw < most_draws; ++draw) {
        const std::vector<Vec3> corners = options.kind == Kind::sand
                                              ? sand_corners(options, random)
                                              : woodchip_corners(options, random);
        try {
            const Centered hull = centered_hull(corners);
            const double radius = rounding.radius(hull.volume);
            if (!(hull.depth > std::max(2.0 * radius, 1e-3 * options.size))) continue;
            Grain grain = rounded_grain(hull, radius);
            if (grain.display_mesh.max_deviation <=
                most_deviation * equivalent_diameter(hull.volume)) {
                grain.redrawn = draw;
                return grain;
            }
        } catch (const Error&) {
            continue;  // points in a plane, or nearly
        }
    }
    throw Error("--rounding", "no hull of " + std::to_string(most_draws) + " for grain " +
                                  std::to_string(index) +
                                  " is thick enough for it, expected a smaller one");
}

}  // namespace dem::shapegen
