// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/clump.hpp"

#include "common/error.hpp"
#include "common/random.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace dem {
namespace {

std::vector<ClumpSphere> random_spheres(std::size_t count, std::uint64_t seed) {
    Random random(seed, count);
    std::vector<ClumpSphere> spheres;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 c = random.uniform(0.0, 1.0) * random.direction();
        spheres.push_back({c.x(), c.y(), c.z(), random.uniform(0.01, 0.2), 1.0});
    }
    return spheres;
}

bool is_less(const ClumpSphere& a, const ClumpSphere& b) {
    return std::lexicographical_compare(&a.x, &a.x + 4, &b.x, &b.x + 4);
}

TEST(Clump, KeepsTheSpheresAndBoundsEveryRunOfThem) {
    for (const std::size_t count : {1, 2, 7, 8, 9, 63, 64, 65, 511, 513, 5000}) {
        std::vector<ClumpSphere> given = random_spheres(count, 1);
        const Clump clump = make_clump(given);
        const ClumpLevels levels(count, clump.balls.span());
        ASSERT_EQ(levels.ball_count(), clump.balls.size());
        for (std::uint32_t level = 1; level <= levels.top(); ++level) {
            for (std::uint32_t k = 0; k < count; ++k) {
                const Clump::Ball& ball = levels.ball(level, k);
                ASSERT_LE(
                    (clump.spheres[k].center() - ball.center()).norm() + clump.spheres[k].radius,
                    ball.radius);
            }
        }
        std::vector<ClumpSphere> kept(clump.spheres.begin(), clump.spheres.end());
        std::sort(kept.begin(), kept.end(), is_less);
        std::sort(given.begin(), given.end(), is_less);
        for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(kept[k].center(), given[k].center());
    }
}

TEST(Clump, IsTheSameForAnyOrderOfItsSpheres) {
    std::vector<ClumpSphere> spheres = random_spheres(300, 2);
    const Clump a = make_clump(spheres);
    std::reverse(spheres.begin(), spheres.end());
    const Clump b = make_clump(spheres);
    for (std::size_t k = 0; k < a.spheres.size(); ++k)
        ASSERT_EQ(a.spheres[k].center(), b.spheres[k].center());
}

TEST(Clump, AVisitFindsWhatAWalkOverAllSpheresFindsAndLooksAtFew) {
    const Clump clump = make_clump(random_spheres(4000, 3));
    const ClumpLevels levels(clump.spheres.size(), clump.balls.span());
    Random random(3, 1);
    std::size_t looked_at = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3 x = 1.3 * random.direction();
        const double reach = 0.1;
        std::vector<std::uint32_t> found, expected;
        const auto gap = [&](const auto& s) { return (s.center() - x).norm() - s.radius; };
        visit_spheres(
            clump.spheres.span(), levels,
            [&](const Clump::Ball& ball) { return gap(ball) > reach; },
            [&](std::uint32_t k) {
                ++looked_at;
                if (gap(clump.spheres[k]) < reach) found.push_back(k);
            });
        for (std::uint32_t k = 0; k < clump.spheres.size(); ++k)
            if (gap(clump.spheres[k]) < reach) expected.push_back(k);
        EXPECT_EQ(found, expected);
    }
    EXPECT_LT(looked_at, 50U * 4000U / 10U);
}

TEST(Clump, NeedsASphereAndTakesNoMoreThanItCanNumber) {
    EXPECT_THROW(make_clump({}), Error);
    EXPECT_THROW(make_clump(random_spheres(65536, 4)), Error);
    EXPECT_EQ(make_clump(random_spheres(65535, 4)).spheres.size(), 65535U);
}

}  // namespace
}  // namespace dem
