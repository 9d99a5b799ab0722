// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex/make_oblong.hpp"

#include "common/math/elementary.hpp"
#include "common/shapes/convex_moments.hpp"
#include "shapegen/convex/exact_hull.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// Symbols: r radius of the round tablet, h height of its band, c of a cap; the cap is a part of a
// sphere of radius R = (r^2 + c^2) / 2c that a cone of half-angle alpha about its center cuts out,
// r = R sin(alpha); l = length - width, by which the round tablet is moved.
namespace dem::shapegen {

namespace {

/// x - sin(x) without cancellation, for x in [0, pi].
double minus_sine(double x) {
    double term = cube(x) / 6.0;
    double sum = 0.0;
    for (int k = 4; std::abs(term) > 1e-17 * std::abs(sum); k += 2) {
        sum += term;
        term *= -square(x) / (k * (k + 1.0));
    }
    return sum;
}

struct Cap {
    double radius, sphere, half_angle;

    explicit Cap(const OblongTablet& t)
        : radius(0.5 * t.width),
          sphere((square(radius) + square(t.cap_height)) / (2.0 * t.cap_height)),
          half_angle(2.0 * math::atan(t.cap_height / radius)) {}

    /// Area that an arc of the cap encloses with its chord [m^2].
    double segment() const { return 0.5 * square(sphere) * minus_sine(2.0 * half_angle); }
    /// Distance from the axis and height above the band where the normal leans by an angle [m].
    Vec2 at(double angle) const {
        // cos(angle) - cos(half_angle) as a product keeps its digits on flat caps.
        return {sphere * math::sin(angle), 2.0 * sphere * math::sin(0.5 * (half_angle + angle)) *
                                               math::sin(0.5 * (half_angle - angle))};
    }
};

/// Half width and height above the band of the outlines that the facets of a cap go through, the
/// rim first. The number of facets from rim to rim is odd: a flat one lies on top.
std::vector<Vec2> cap_outlines(const OblongTablet& t) {
    if (t.cap_height == 0.0) return {{0.5 * t.width, 0.0}};
    const Cap cap(t);
    // As near to the cap as the sides are to the half circles: 1 - cos(x) = 2 sin^2(x / 2).
    const double sagitta = cap.radius * square(math::sin(0.25 * pi / t.sides));
    int facets = 3;
    while (cap.sphere * square(math::sin(0.5 * cap.half_angle / facets)) > sagitta) facets += 2;
    std::vector<Vec2> outlines;
    for (int k = 0; 2 * k < facets; ++k)
        outlines.push_back(cap.at(cap.half_angle * (facets - 2 * k) / facets));
    // The rim to the last digit; the facet on top as high as the cap.
    const double stretch = t.cap_height / outlines.back().y();
    for (Vec2& outline : outlines) outline.y() *= stretch;
    outlines.front() = {cap.radius, 0.0};
    return outlines;
}

/// Corners of the polyhedron before its length and width are stretched.
std::vector<Vec3> corners(const OblongTablet& t) {
    const double half = 0.5 * (t.length - t.width);
    std::vector<Vec3> points;
    for (const Vec2& outline : cap_outlines(t)) {
        for (int i = 0; i <= t.sides; ++i) {
            const double angle = pi * (static_cast<double>(i) / t.sides - 0.5);
            // The ends of the half circles lie on the straight sides exactly.
            const double cosine = i == 0 || i == t.sides ? 0.0 : math::cos(angle);
            const double x = half + outline.x() * cosine;
            const double y = outline.x() * math::sin(angle);
            const double z = 0.5 * t.band_height + outline.y();
            for (const double side : {x, -x})
                for (const double level : {z, -z}) points.emplace_back(side, y, level);
        }
    }
    return points;
}

std::vector<Vec3> stretched_corners(const OblongTablet& t) {
    std::vector<Vec3> points = corners(t);
    const double found = convex_moments(rounded_around(exact_hull(points), 0.0)).volume;
    const double stretch = std::sqrt(volume(t) / found);
    for (Vec3& p : points) p.head<2>() *= stretch;
    return points;
}

/// Points of a quarter of the outline of the smooth tablet, four for each facet of the cap:
/// distance from the axis and height.
std::vector<Vec2> outline_samples(const OblongTablet& t) {
    const double r = 0.5 * t.width;
    const double h = 0.5 * t.band_height;
    std::vector<Vec2> samples{{r, 0.0}, {r, h}};
    if (t.cap_height == 0.0) return samples;
    const Cap cap(t);
    const std::size_t steps = 4 * cap_outlines(t).size();
    for (std::size_t k = 0; k < steps; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(steps);
        samples.emplace_back(cap.at(part * cap.half_angle) + Vec2(0.0, h));
    }
    return samples;
}

}  // namespace

double volume(const OblongTablet& t) {
    const double r = 0.5 * t.width;
    const double c = t.cap_height;
    const double caps = pi * c * (3.0 * square(r) + square(c)) / 3.0;
    const double segments = c > 0.0 ? 2.0 * Cap(t).segment() : 0.0;
    // A body moved along x sweeps out its projection along x, beside its own volume.
    const double projection = 2.0 * r * t.band_height + segments;
    return pi * square(r) * t.band_height + caps + (t.length - t.width) * projection;
}

ConvexSolid make_oblong(const OblongTablet& tablet, double rounding) {
    return make_convex_polyhedron(stretched_corners(tablet), rounding, exact_hull);
}

double facet_error(const OblongTablet& t) {
    const ConvexShape facets = rounded_around(exact_hull(stretched_corners(t)), 0.0);
    const double half = 0.5 * (t.length - t.width);
    const int steps = 2 * t.sides;  // four for each facet of a quarter circle
    double largest = 0.0;
    for (const Vec2& p : outline_samples(t)) {
        for (int i = 0; i <= steps; ++i) {
            const double angle = 0.5 * pi * i / steps;
            const Vec3 x(half + p.x() * math::cos(angle), p.x() * math::sin(angle), p.y());
            largest = std::max(largest, std::abs(surface_distance(facets, x).distance));
        }
    }
    return largest;
}

}  // namespace dem::shapegen
