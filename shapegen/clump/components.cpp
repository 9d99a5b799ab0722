// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/components.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace dem::shapegen {

namespace {

/// Sets of indices that are joined until they are disjoint no more.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count), sets_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    void join(std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = root(i);
        const std::uint32_t b = root(j);
        if (a == b) return;
        parent_[std::max(a, b)] = std::min(a, b);
        --sets_;
    }

    std::size_t count() const { return sets_; }

  private:
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    std::vector<std::uint32_t> parent_;
    std::size_t sets_;
};

bool touches(const Vec3& p, double radius_p, const Vec3& q, double radius_q) {
    constexpr double rounding = 1e-9;
    return (p - q).squaredNorm() <= square((1.0 + rounding) * (radius_p + radius_q));
}

}  // namespace

std::size_t component_count(const Clump& clump) {
    const auto spheres = clump.spheres.span();
    const ClumpLevels levels(spheres.size(), clump.balls.span());
    DisjointSets pieces(spheres.size());
    for (std::uint32_t i = 0; i < spheres.size(); ++i) {
        const Vec3 center = spheres[i].center();
        const double radius = spheres[i].radius;
        visit_spheres(
            spheres, levels,
            [&](const Clump::Ball& ball) {
                return !touches(center, radius, ball.center(), ball.radius);
            },
            [&](std::uint32_t k) {
                if (k < i && touches(center, radius, spheres[k].center(), spheres[k].radius))
                    pieces.join(i, k);
            });
    }
    return pieces.count();
}

}  // namespace dem::shapegen
