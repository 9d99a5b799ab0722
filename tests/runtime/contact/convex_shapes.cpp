// SPDX-License-Identifier: BSD-3-Clause
#include "tests/runtime/contact/convex_shapes.hpp"

#include "common/shapes/mass_properties.hpp"
#include "common/shapes/support_map.hpp"

#include <algorithm>
#include <cmath>

namespace dem::test {

namespace {

constexpr double crown = 2e-4;  // half-angle of crowned flats [rad]

double direction_measure(double n_r, double n_z) {
    return n_z / (n_r + std::abs(n_z));
}

SrShape sr_shape(SupportMap map, double top, double max_radius, double bounding, double volume) {
    SrShape s;
    s.is_convex = true;
    s.bottom_z = -top;
    s.top_z = top;
    s.max_radius = max_radius;
    s.bounding_radius = bounding;
    s.equivalent_diameter = equivalent_diameter(volume);
    s.major_axis_length = 2.0 * std::max(top, max_radius);
    s.support = std::move(map);
    return s;
}

/// Crowned arc between (r, -z) and (r, z): the band of a cylinder.
SupportPiece crowned_band(double r, double z) {
    const double radius = z / std::sin(crown);
    return {r - radius * std::cos(crown), 0.0, radius, radius};
}

}  // namespace

SupportMap support_map(std::vector<SupportPiece> pieces, std::vector<double> piece_end) {
    constexpr std::uint32_t buckets = 64;
    std::vector<std::uint32_t> first(buckets + 1);
    for (std::uint32_t k = 0; k <= buckets; ++k) {
        const double q = 2.0 * k / buckets - 1.0;
        const auto it = std::lower_bound(piece_end.begin(), piece_end.end(), q);
        first[k] =
            static_cast<std::uint32_t>(std::min(it, piece_end.end() - 1) - piece_end.begin());
    }
    SupportMap map{std::move(pieces), std::move(piece_end), std::move(first)};
    map.longest_radius = longest_radius(map);
    return map;
}

InverseInertia SolidBody::inverse(double density) const {
    return {1.0 / (density * volume), (density * moments_per_density).cwiseInverse()};
}

SolidBody spheroid(double a, double c) {
    SolidBody body;
    body.volume = 4.0 / 3.0 * pi * a * a * c;
    const double across = body.volume * (a * a + c * c) / 5.0;
    body.moments_per_density = {across, across, 0.4 * body.volume * a * a};
    body.shape =
        sr_shape(support_map({{0.0, 0.0, a, c}}, {1.0}), c, a, std::max(a, c), body.volume);
    return body;
}

SolidBody tablet() {
    const double rb = 5.675e-3;
    const double half = 2.0e-3;
    const double hc = 1.23e-3;
    const double cap = (rb * rb + hc * hc) / (2.0 * hc);
    const double edge = std::asin(rb / cap);  // angle of the cap's rim from the axis
    const double q_cap = direction_measure(std::sin(edge), std::cos(edge));
    const double q_band = direction_measure(std::cos(crown), std::sin(crown));
    const double center = half + hc - cap;
    SolidBody body;
    // Closed forms of METHODS 2 at rho = 1191.3 kg/m^3.
    body.volume = 5.311042e-7;
    body.moments_per_density = Vec3(6.228876e-9, 6.228876e-9, 9.392900e-9) / 1191.3;
    body.shape = sr_shape(support_map({{0.0, -center, cap, cap},
                                       {rb, -half, 0.0, 0.0},
                                       crowned_band(rb, half),
                                       {rb, half, 0.0, 0.0},
                                       {0.0, center, cap, cap}},
                                      {-q_cap, -q_band, q_band, q_cap, 1.0}),
                          half + hc, rb, std::hypot(rb, half), body.volume);
    return body;
}

SolidBody cylinder(double radius, double height) {
    const double half = 0.5 * height;
    const double face = radius / std::sin(crown);
    const double q_face = direction_measure(std::sin(crown), std::cos(crown));
    const double q_band = direction_measure(std::cos(crown), std::sin(crown));
    const double center = half - face * std::cos(crown);
    SolidBody body;
    body.volume = pi * radius * radius * height;
    const double across = body.volume * (3.0 * radius * radius + height * height) / 12.0;
    body.moments_per_density = {across, across, 0.5 * body.volume * radius * radius};
    body.shape = sr_shape(support_map({{0.0, -center, face, face},
                                       {radius, -half, 0.0, 0.0},
                                       crowned_band(radius, half),
                                       {radius, half, 0.0, 0.0},
                                       {0.0, center, face, face}},
                                      {-q_face, -q_band, q_band, q_face, 1.0}),
                          half, radius, std::hypot(radius, half), body.volume);
    return body;
}

}  // namespace dem::test
