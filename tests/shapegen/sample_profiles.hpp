// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile.hpp"

#include <cmath>
#include <string>
#include <vector>

/// Profiles made by hand, so that these tests do not depend on the reader of profile files [m].
namespace dem::test {

using namespace shapegen;

inline Profile labeled(std::vector<ProfileSegment> segments) {
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < segments.size(); ++i) labels.push_back("part " + std::to_string(i));
    return {std::move(segments), std::move(labels)};
}

inline Profile spheroid(double a, double c) {
    return labeled({EllipseArc{Vec2(0, 0), a, c, -0.5 * pi, 0.5 * pi}});
}

inline Profile candy() {
    return spheroid(6.585e-3, 3.395e-3);
}

inline Profile cylinder(double radius, double height) {
    const double h = 0.5 * height;
    return labeled({LineSegment{Vec2(0, -h), Vec2(radius, -h)},
                    LineSegment{Vec2(radius, -h), Vec2(radius, h)},
                    LineSegment{Vec2(radius, h), Vec2(0, h)}});
}

/// The bi-convex tablet of [SR 3.1].
inline Profile tablet() {
    const double r = 5.675e-3;
    const double h = 2.0e-3;
    const double cap = 1.23e-3;
    const double sphere = (r * r + cap * cap) / (2.0 * cap);
    const double half_angle = std::asin(r / sphere);
    const double z = h + cap - sphere;
    return labeled({EllipseArc{Vec2(0, -z), sphere, sphere, -0.5 * pi, -0.5 * pi + half_angle},
                    LineSegment{Vec2(r, -h), Vec2(r, h)},
                    EllipseArc{Vec2(0, z), sphere, sphere, 0.5 * pi - half_angle, 0.5 * pi}});
}

/// A disc with a rounded groove around it: not convex, with concave corners.
inline Profile grooved() {
    return labeled({LineSegment{Vec2(0, -2e-3), Vec2(4e-3, -2e-3)},
                    LineSegment{Vec2(4e-3, -2e-3), Vec2(4e-3, -1e-3)},
                    EllipseArc{Vec2(4e-3, 0), 1e-3, 1e-3, 1.5 * pi, 0.5 * pi},
                    LineSegment{Vec2(4e-3, 1e-3), Vec2(4e-3, 2e-3)},
                    LineSegment{Vec2(4e-3, 2e-3), Vec2(0, 2e-3)}});
}

struct NamedProfile {
    std::string name;
    Profile profile;
};

inline std::vector<NamedProfile> all_profiles() {
    return {{"sphere", spheroid(2e-3, 2e-3)},
            {"candy", candy()},
            {"needle", spheroid(1e-3, 5e-3)},
            {"cylinder", cylinder(3e-3, 4e-3)},
            {"coin", cylinder(10e-3, 1e-3)},
            {"tablet", tablet()},
            {"grooved", grooved()}};
}

}  // namespace dem::test
