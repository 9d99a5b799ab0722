// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile.hpp"
#include "shapegen/profile/profile_curves.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Profiles built in code, in meters but of the size of one, for tests that need a shape of each
/// kind.
namespace dem::sample {

using namespace shapegen;

inline Profile make(std::vector<ProfileSegment> segments) {
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < segments.size(); ++i)
        labels.push_back("sample:" + std::to_string(i + 1));
    return {std::move(segments), std::move(labels)};
}

inline Profile sphere(double radius) {
    return make({EllipseArc{Vec2::Zero(), radius, radius, -0.5 * pi, 0.5 * pi}});
}

inline Profile spheroid(double a, double c) {
    return make({EllipseArc{Vec2::Zero(), a, c, -0.5 * pi, 0.5 * pi}});
}

inline Profile polygon(const std::vector<Vec2>& points) {
    std::vector<ProfileSegment> segments;
    for (std::size_t i = 1; i < points.size(); ++i)
        segments.push_back(LineSegment{points[i - 1], points[i]});
    return make(std::move(segments));
}

inline Profile cylinder(double radius, double height) {
    const double h = 0.5 * height;
    return polygon({{0, -h}, {radius, -h}, {radius, h}, {0, h}});
}

/// Bi-convex tablet: spherical caps of the given height on a band.
inline Profile tablet(double band_radius, double band_height, double cap_height) {
    const double h = 0.5 * band_height;
    const double cap_radius = (square(band_radius) + square(cap_height)) / (2.0 * cap_height);
    const double half = std::asin(band_radius / cap_radius);
    const Vec2 up(0.0, h + cap_height - cap_radius);
    return make({EllipseArc{-up, cap_radius, cap_radius, -0.5 * pi, -0.5 * pi + half},
                 LineSegment{{band_radius, -h}, {band_radius, h}},
                 EllipseArc{up, cap_radius, cap_radius, 0.5 * pi - half, 0.5 * pi}});
}

inline Profile spherocylinder(double radius, double cylinder_height) {
    const double h = 0.5 * cylinder_height;
    return make({EllipseArc{Vec2(0.0, -h), radius, radius, -0.5 * pi, 0.0},
                 LineSegment{{radius, -h}, {radius, h}},
                 EllipseArc{Vec2(0.0, h), radius, radius, 0.0, 0.5 * pi}});
}

inline Profile superquadric(double a, double c, double exponent) {
    const auto quarters = superquadric_quarters(a, c, exponent);
    return make({quarters[0], quarters[1]});
}

inline Profile peanut(double focus, double product_root) {
    return make({cassini_half(focus, product_root)});
}

inline Profile red_blood_cell(double diameter) {
    const double k = diameter / 7.82;
    return make({red_blood_cell_half(diameter, {0.81 * k, 7.83 * k, -4.39 * k})});
}

/// One of each kind.
inline std::vector<std::pair<std::string, Profile>> all() {
    return {{"sphere", sphere(1.0)},
            {"oblate", spheroid(6.585, 3.395)},
            {"prolate", spheroid(2.5, 5.0)},
            {"cylinder", cylinder(1.0, 3.0)},
            {"disc", cylinder(3.0, 0.5)},
            {"frustum", polygon({{0, 0}, {2, 0}, {1, 2}, {0, 2}})},
            {"cone", polygon({{0, 0}, {1, 0}, {0, 2}})},
            {"tablet", tablet(5.675, 4.0, 1.23)},
            {"spherocylinder", spherocylinder(1.0, 2.5)},
            {"superquadric 4", superquadric(1.0, 1.5, 4.0)},
            {"superquadric 8", superquadric(2.0, 0.8, 8.0)},
            {"superquadric 1.5", superquadric(1.0, 1.0, 1.5)},
            {"peanut", peanut(1.0, 1.1)},
            {"red blood cell", red_blood_cell(7.82)}};
}

}  // namespace dem::sample
