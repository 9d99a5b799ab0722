// SPDX-License-Identifier: BSD-3-Clause
#include "tests/runtime/contact/convex_shapes.hpp"

#include "common/shapes/mass_properties.hpp"
#include "common/shapes/support_bounds.hpp"
#include "common/shapes/support_map.hpp"

#include <algorithm>
#include <cmath>

namespace dem::test {

using namespace runtime;

namespace {

constexpr double crown = 2e-4;  // half-angle of crowned flats [rad]

/// Arc between two corners that turns by twice the crown.
SupportPiece crowned_flat(const Vec2& from, const Vec2& to) {
    const double radius = 0.5 * (to - from).norm() / std::sin(crown);
    const Vec2 along = (to - from).normalized();
    const Vec2 center = 0.5 * (from + to) - radius * std::cos(crown) * Vec2(along.y(), -along.x());
    return {center.x(), center.y(), radius, radius};
}

/// Volume and moments of a body of revolution whose squared radius is a polynomial of degree two in
/// pieces: three points of Gauss are exact.
class RingSums {
  public:
    template <class SquaredRadius>
    void add(double from, double to, const SquaredRadius& r2) {
        const double reach = std::sqrt(0.6);
        for (int k = -1; k <= 1; ++k) {
            const double z = 0.5 * (from + to) + 0.5 * k * reach * (to - from);
            const double slice = (k == 0 ? 8.0 : 5.0) / 18.0 * (to - from) * pi * r2(z);
            volume_ += slice;
            first_ += slice * z;
            about_z_ += 0.5 * slice * r2(z);
            squared_z_ += slice * z * z;
        }
    }
    /// With the center of mass moved to the origin.
    SolidBody body(std::vector<SupportPiece> pieces, std::vector<double> ends,
                   const std::vector<Vec2>& corners) const {
        const double center = first_ / volume_;
        for (SupportPiece& p : pieces) p.center_z -= center;
        SolidBody body;
        body.volume = volume_;
        const double across = 0.5 * about_z_ + squared_z_ - volume_ * square(center);
        body.moments_per_density = {across, across, about_z_};
        SrShape& s = body.shape;
        s.is_convex = true;
        s.bottom_z = corners.front().y() - center;
        s.top_z = corners.back().y() - center;
        for (const Vec2& c : corners) {
            s.max_radius = std::max(s.max_radius, c.x());
            s.bounding_radius = std::max(s.bounding_radius, std::hypot(c.x(), c.y() - center));
        }
        s.equivalent_diameter = equivalent_diameter(volume_);
        s.major_axis_length = std::max(s.top_z - s.bottom_z, 2.0 * s.max_radius);
        s.support = support_map(std::move(pieces), std::move(ends));
        return body;
    }

  private:
    double volume_ = 0.0, first_ = 0.0, about_z_ = 0.0, squared_z_ = 0.0;
};

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
    SupportMap map{std::move(pieces), std::move(piece_end), std::move(first), {}};
    map.bounds = support_bounds(map);
    return map;
}

InverseInertia SolidBody::inverse(double density) const {
    return {1.0 / (density * volume), (density * moments_per_density).cwiseInverse()};
}

SolidBody spheroid(double a, double c) {
    RingSums sums;
    sums.add(-c, c, [&](double z) { return square(a) * (1.0 - square(z / c)); });
    return sums.body({{0.0, 0.0, a, c}}, {1.0}, {{0.0, -c}, {a, 0.0}, {0.0, c}});
}

SolidBody tablet(double band_radius, double band_height, double cap_height) {
    const double rb = band_radius;
    const double half = 0.5 * band_height;
    const double hc = cap_height;
    const double cap = (rb * rb + hc * hc) / (2.0 * hc);
    const double edge = std::asin(rb / cap);  // angle of the cap's rim from the axis
    const double q_cap = direction_measure(std::sin(edge), std::cos(edge));
    const double q_band = direction_measure(std::cos(crown), std::sin(crown));
    const double center = half + hc - cap;
    RingSums sums;
    const auto of_cap = [&](double z) { return square(cap) - square(std::abs(z) - center); };
    sums.add(-half - hc, -half, of_cap);
    sums.add(-half, half, [&](double) { return square(rb); });
    sums.add(half, half + hc, of_cap);
    return sums.body({{0.0, -center, cap, cap},
                      {rb, -half, 0.0, 0.0},
                      crowned_flat({rb, -half}, {rb, half}),
                      {rb, half, 0.0, 0.0},
                      {0.0, center, cap, cap}},
                     {-q_cap, -q_band, q_band, q_cap, 1.0},
                     {{0.0, -half - hc}, {rb, -half}, {rb, half}, {0.0, half + hc}});
}

SolidBody revolved(const std::vector<Vec2>& corners) {
    const double sine = std::sin(crown);
    const double cosine = std::cos(crown);
    std::vector<SupportPiece> pieces;
    std::vector<double> ends;
    const auto add = [&](const SupportPiece& piece, const Vec2& last_normal) {
        pieces.push_back(piece);
        ends.push_back(direction_measure(last_normal.x(), last_normal.y()));
    };
    const auto add_corner = [&](const Vec2& x, const Vec2& last_normal) {
        add({x.x(), x.y(), 0.0, 0.0}, last_normal);
    };
    const Vec2& lowest = corners.front();
    const Vec2& highest = corners.back();
    if (lowest.x() > 0.0) {
        const double a = lowest.x() / sine;
        add({0.0, lowest.y() + a * cosine, a, a}, {sine, -cosine});
    }
    RingSums sums;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const Vec2& from = corners[k];
        const Vec2& to = corners[k + 1];
        const Vec2 along = (to - from).normalized();
        const Vec2 normal(along.y(), -along.x());
        add_corner(from, cosine * normal - sine * along);
        add(crowned_flat(from, to), cosine * normal + sine * along);
        if (from.y() == to.y()) continue;
        sums.add(from.y(), to.y(), [&](double z) {
            return square(from.x() + (to.x() - from.x()) * (z - from.y()) / (to.y() - from.y()));
        });
    }
    add_corner(highest, highest.x() > 0.0 ? Vec2(sine, cosine) : Vec2(0.0, 1.0));
    if (highest.x() > 0.0) {
        const double a = highest.x() / sine;
        add({0.0, highest.y() - a * cosine, a, a}, {0.0, 1.0});
    }
    return sums.body(std::move(pieces), std::move(ends), corners);
}

}  // namespace dem::test
