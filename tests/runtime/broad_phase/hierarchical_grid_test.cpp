// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/broad_phase/hierarchical_grid.hpp"

#include "common/random.hpp"
#include "common/threads/thread_team.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

std::vector<IdPair> by_comparing_all(const std::vector<Aabb>& boxes) {
    std::vector<IdPair> pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            if (overlaps(boxes[i], boxes[j])) pairs.push_back({i, j});
        }
    }
    return pairs;
}

// Boxes of extents spread over `decades` powers of ten in a cube of edge `edge` about `center`.
std::vector<Aabb> random_boxes(std::uint32_t count, double edge, double decades,
                               const Vec3& center) {
    std::vector<Aabb> boxes(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        Random random(7, i);
        const double size = std::pow(10.0, -decades * random.uniform());
        Vec3 middle, half;
        for (int a = 0; a < 3; ++a) {
            middle[a] = center[a] + edge * (random.uniform() - 0.5);
            half[a] = 0.5 * size * random.uniform(0.1, 1.0);
        }
        boxes[i] = {middle - half, middle + half};
    }
    return boxes;
}

TEST(HierarchicalGrid, FindsExactlyThePairsThatComparingAllFinds) {
    for (const double decades : {0.0, 0.3, 1.0, 3.0, 6.0}) {
        for (const Vec3& center : {Vec3(0.0, 0.0, 0.0), Vec3(-1e4, 3e3, 17.0)}) {
            const auto boxes = random_boxes(2000, decades > 2.0 ? 1.5 : 6.0, decades, center);
            const auto expected = by_comparing_all(boxes);
            EXPECT_GT(expected.size(), 100U);
            EXPECT_EQ(overlapping_pairs(boxes), expected) << "decades " << decades;
        }
    }
}

TEST(HierarchicalGrid, FindsBoxesThatTouchInOnePlaneOnly) {
    std::vector<Aabb> boxes;
    for (int x = 0; x < 6; ++x) {
        for (int y = 0; y < 6; ++y) {
            for (int z = 0; z < 6; ++z) {
                const Vec3 lower(x, y, z);
                boxes.push_back({lower, lower + Vec3::Ones()});
            }
        }
    }
    EXPECT_EQ(overlapping_pairs(boxes), by_comparing_all(boxes));
}

TEST(HierarchicalGrid, HandlesNoneOneAndPoints) {
    EXPECT_TRUE(overlapping_pairs({}).empty());
    std::vector<Aabb> boxes{{Vec3::Ones(), Vec3::Ones()}};
    EXPECT_TRUE(overlapping_pairs(boxes).empty());
    boxes.push_back(boxes[0]);
    boxes.push_back({Vec3::Zero(), Vec3::Zero()});
    EXPECT_EQ(overlapping_pairs(boxes), (std::vector<IdPair>{{0, 1}}));
    boxes.push_back({Vec3::Constant(-1e3), Vec3::Constant(1e3)});
    EXPECT_EQ(overlapping_pairs(boxes), by_comparing_all(boxes));
}

TEST(HierarchicalGrid, GivesTheSameForAnyNumberOfThreads) {
    const auto boxes = random_boxes(5000, 12.0, 1.0, Vec3::Zero());
    const auto serial = overlapping_pairs(boxes);
    for (const int threads : {1, 2, 3, 8}) {
        ThreadTeam team(threads);
        const ThreadTeam::InForce together(&team);
        EXPECT_EQ(overlapping_pairs(boxes), serial);
    }
}

}  // namespace
}  // namespace dem::runtime
