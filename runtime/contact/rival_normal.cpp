// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/rival_normal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem {

namespace {

/// Distance of a support point from the axis of its body [m].
double radius_of(const SupportSample& s, const Vec3& n, const Vec3& axis) {
    return s.point(n).cross(axis).norm();
}

/// Directions from which the descent leads to the minima beside a known one.
class Starts {
  public:
    /// Those that one body offers, along its meridian through its outward normal m: the middle of
    /// the fan of each edge on the way, and the flat or cap behind it, up to a length of `reach`
    /// [m] to either side. `sign`: 1 for i, -1 for j.
    void add_meridian(const SrSupport& body, const Vec3& m, double sign, double reach) {
        const double u = m.dot(body.axis);
        const Vec3 off_axis = m - u * body.axis;
        const double n_r = off_axis.norm();
        if (n_r <= SrSupport::pole) return;
        const Meridian meridian{body.map, off_axis / n_r, body.axis, sign};
        const auto here = static_cast<int>(support_piece(body.map, direction_measure(n_r, u)));
        if (meridian.is_edge(here)) add(meridian.middle(here));
        for (const int step : {-1, 1}) {
            double length = 0.0;
            for (int k = here + step; meridian.has(k) && length < reach; k += step) {
                length += meridian.length(k);
                add(meridian.entrance(k, step));
            }
        }
    }
    const Vec3* begin() const { return directions_.data(); }
    const Vec3* end() const { return directions_.data() + count_; }

  private:
    /// One half of a profile in space.
    struct Meridian {
        const SupportMap& map;
        Vec3 outward, axis;
        double sign;

        bool has(int k) const { return k >= 0 && k < static_cast<int>(map.pieces.size()); }
        const SupportPiece& piece(int k) const { return map.pieces[static_cast<std::size_t>(k)]; }
        double low(int k) const {
            return k == 0 ? -1.0 : map.piece_end[static_cast<std::size_t>(k) - 1];
        }
        double high(int k) const { return map.piece_end[static_cast<std::size_t>(k)]; }
        bool is_edge(int k) const { return longest_radius(piece(k)) == 0.0; }
        double length(int k) const { return shortest_radius(piece(k)) * (high(k) - low(k)); }
        Vec3 direction(double q) const {
            const Vec2 n = Vec2(1.0 - std::abs(q), q).normalized();
            return sign * (n.x() * outward + n.y() * axis);
        }
        Vec3 middle(int k) const { return direction(0.5 * (low(k) + high(k))); }
        /// Of a flat and of an edge the middle, of a cap a place near the edge before it.
        Vec3 entrance(int k, int step) const {
            constexpr double depth = 0.02;
            if (is_edge(k) || high(k) - low(k) < depth) return middle(k);
            return direction(step > 0 ? low(k) + 0.5 * depth : high(k) - 0.5 * depth);
        }
    };
    void add(const Vec3& n) {
        if (count_ < directions_.size()) directions_[count_++] = n;
    }

    std::array<Vec3, 32> directions_;
    std::size_t count_ = 0;
};

}  // namespace

bool is_least_by_crossing(const NormalProbe& p, const SrSupport& i, const SrSupport& j,
                          const Vec3& d) {
    const double distance = d.norm();
    const double inner = i.map.bounds.inner_radius + j.map.bounds.inner_radius;
    // Minima as low as p.f lie within an angle from d whose cosine is `nearest`; p.n itself does.
    const double nearest = (inner - p.f) / distance;
    if (nearest >= 1.0) return true;
    if (!(nearest > -1.0)) return false;
    const double here = std::min(1.0, p.n.dot(d) / distance);
    const double farthest =
        here * nearest - std::sqrt(std::max(0.0, (1.0 - square(here)) * (1.0 - square(nearest))));
    const double r_i = radius_of(p.i, p.n, i.axis);
    const double r_j = radius_of(p.j, -p.n, j.axis);
    const double sine2 = 1.0 - square(p.i.meridian.dot(p.j.meridian));
    const double sum = r_i + r_j;
    const double least =
        0.5 * (sum - std::sqrt(std::max(0.0, square(sum) - 4.0 * r_i * r_j * sine2)));
    return least * (1.0 + farthest) >= 2.0 * p.f;
}

std::optional<NormalProbe> rival_normal(const NormalProbe& p, const SrSupport& i,
                                        const SrSupport& j, const Vec3& d, double highest) {
    constexpr double same_place = 1e-4;  // [rad]
    Starts starts;
    const double reach = 4.0 * p.f;
    starts.add_meridian(i, p.n, 1.0, reach);
    starts.add_meridian(j, -p.n, -1.0, reach);
    std::optional<NormalProbe> lowest;
    for (const Vec3& start : starts) {
        const NormalProbe found = common_normal(i, j, d, start);
        if (found.f > highest || (lowest && found.f >= lowest->f)) continue;
        if ((found.n - p.n).squaredNorm() < square(same_place)) continue;
        lowest = found;
    }
    return lowest;
}

}  // namespace dem
