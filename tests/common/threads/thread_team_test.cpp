// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/thread_team.hpp"

#include "common/random.hpp"
#include "common/threads/available_cores.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>

namespace dem {
namespace {

TEST(ThreadTeam, DoesEveryElementOnceWhateverTheSizes) {
    for (const int most : {1, 2, 3, 8}) {
        ThreadTeam team(most);
        const ThreadTeam::InForce together(&team);
        Random random(1, static_cast<std::uint64_t>(most));
        for (int loop = 0; loop < 1000; ++loop) {
            team.use(1 + static_cast<int>(random.uniform() * most));
            const auto count = static_cast<std::size_t>(1000.0 * random.uniform());
            const auto grain = static_cast<std::size_t>(1.0 + 40.0 * random.uniform());
            std::vector<int> done(count, 0);
            share_each(count, grain, [&](std::size_t k) { ++done[k]; });
            ASSERT_EQ(done, std::vector<int>(count, 1)) << most << " threads, grain " << grain;
        }
    }
}

TEST(ThreadTeam, GivesEveryThreadASlotOfItsOwn) {
    ThreadTeam team(4);
    const ThreadTeam::InForce together(&team);
    for (int loop = 0; loop < 100; ++loop) {
        std::vector<std::size_t> sums(team_size_in_force(), 0);
        std::vector<std::thread::id> threads(sums.size());
        std::atomic<bool> is_mixed = false;
        share_loop(1000, 1, [&](const LoopPart& part) {
            for (std::size_t k = part.begin; k < part.end; ++k) sums[part.worker] += k;
            std::thread::id& owner = threads[part.worker];
            if (owner == std::thread::id()) owner = std::this_thread::get_id();
            if (owner != std::this_thread::get_id()) is_mixed = true;
        });
        std::size_t sum = 0;
        for (const std::size_t s : sums) sum += s;
        EXPECT_EQ(sum, 999U * 1000U / 2U);
        EXPECT_FALSE(is_mixed);
        EXPECT_EQ(threads[0], std::this_thread::get_id());
    }
}

TEST(ThreadTeam, HelpersComeAgainAfterTheySlept) {
    ThreadTeam team(2);
    const ThreadTeam::InForce together(&team);
    for (int pause = 0; pause < 3; ++pause) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        // The caller waits in its own part until the helper has one, too.
        std::atomic<bool> has_helper_come = false;
        share_loop(2, 1, [&](const LoopPart& part) {
            if (part.worker == 1) has_helper_come = true;
            while (!has_helper_come) std::this_thread::yield();
        });
        EXPECT_TRUE(has_helper_come);
    }
}

TEST(ThreadTeam, ThrowsTheErrorOfTheLowestElementAfterAllParts) {
    ThreadTeam team(3);
    const ThreadTeam::InForce together(&team);
    for (int loop = 0; loop < 200; ++loop) {
        std::atomic<int> parts = 0;
        try {
            share_loop(300, 1, [&](const LoopPart& part) {
                ++parts;
                for (std::size_t k = part.begin; k < part.end; ++k)
                    if (k % 100 == 57) throw std::runtime_error(std::to_string(k));
            });
            FAIL();
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "57");
        }
        EXPECT_GE(parts, 3 * 16);
        share_each(300, 1, [&](std::size_t) { ++parts; });  // the next loop is none the worse
    }
}

TEST(ThreadTeam, LoopsWithinALoopAreNotShared) {
    ThreadTeam team(3);
    const ThreadTeam::InForce together(&team);
    std::atomic<int> sum = 0;
    share_each(50, 1, [&](std::size_t) {
        const std::thread::id outer = std::this_thread::get_id();
        share_each(50, 1, [&](std::size_t) {
            if (std::this_thread::get_id() == outer) ++sum;
        });
    });
    EXPECT_EQ(sum, 2500);
}

TEST(ThreadTeam, WithoutOneInForceTheCallerDoesAllInOnePart) {
    EXPECT_EQ(team_size_in_force(), 1U);
    int parts = 0;
    share_loop(1000, 1, [&](const LoopPart& part) {
        ++parts;
        EXPECT_EQ(part.begin, 0U);
        EXPECT_EQ(part.end, 1000U);
    });
    EXPECT_EQ(parts, 1);
    share_loop(0, 1, [&](const LoopPart&) { ++parts; });
    EXPECT_EQ(parts, 1);
}

TEST(AvailableCores, AreThoseOfTheAffinityMask) {
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
    EXPECT_GE(available_cores(), 1);
    EXPECT_LE(available_cores(), CPU_COUNT(&before));
    int first = 0;
    while (!CPU_ISSET(first, &before)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(available_cores(), 1);
    EXPECT_EQ(ThreadTeam(0).most(), 1);
    ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}

}  // namespace
}  // namespace dem
