// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/placement_grid.hpp"

#include "common/random.hpp"

#include <set>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

// Radii over three decades, negative coordinates, cells far from the origin.
TEST(PlacementGrid, FindsExactlyTheSpheresThatOverlap) {
    Random random(3, 0);
    PlacementGrid grid;
    std::vector<std::pair<Vec3, double>> spheres;
    const auto draw = [&random] {
        const Vec3 center(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                          random.uniform(-1.0, 1.0));
        return std::pair(center, 1e-3 * std::pow(10.0, random.uniform(0.0, 3.0)));
    };
    for (int k = 0; k < 600; ++k) {
        const auto [center, radius] = draw();
        std::set<std::uint32_t> expected;
        for (std::uint32_t n = 0; n < spheres.size(); ++n) {
            const auto& [other, other_radius] = spheres[n];
            if ((other - center).norm() < radius + other_radius) expected.insert(n);
        }
        std::set<std::uint32_t> found;
        const bool stopped = grid.any_near(center, radius, [&found](std::uint32_t n) {
            found.insert(n);
            return false;
        });
        EXPECT_FALSE(stopped);
        EXPECT_EQ(found, expected);
        EXPECT_EQ(grid.any_near(center, radius, [](std::uint32_t) { return true; }),
                  !expected.empty());
        grid.add(center, radius);
        spheres.emplace_back(center, radius);
    }
    EXPECT_EQ(grid.size(), spheres.size());
}

}  // namespace
}  // namespace dem::runtime
