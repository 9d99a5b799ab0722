// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/team_size.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

// On a machine made of formulas: wall time of a step by the number of threads and the time [s].

namespace dem {
namespace {

using Machine = std::function<double(int threads, double now)>;

struct Course {
    double time = 0.0;        ///< of all steps [s]
    double time_alone = 0.0;  ///< that the same steps take with one thread [s]
    double mean_size = 0.0;   ///< by time
    int steps = 0;
};

/// Steps for some seconds; `team` goes on from one course to the next.
Course run(TeamSize& team, double seconds, const Machine& machine) {
    Course course;
    double size_time = 0.0;
    while (course.time < seconds) {
        const int size = team.next();
        const double step = machine(size, course.time);
        team.step_took(step);
        course.time += step;
        course.time_alone += machine(1, course.time);
        size_time += size * step;
        ++course.steps;
    }
    course.mean_size = size_time / course.time;
    return course;
}

Machine idle(double step, double per_thread = 0.0) {
    return [=](int threads, double) { return step / threads + per_thread * (threads - 1); };
}

TEST(TeamSize, AnIdleMachineGivesTheWholeTeam) {
    for (const double step : {20e-6, 2e-3, 0.3}) {
        for (const int most : {2, 3, 8, 24}) {
            TeamSize team(most);
            run(team, 2.0 + 100.0 * step, idle(step));  // at first it tries
            const Course course = run(team, 20.0, idle(step));
            // Trials cost 3 %.
            EXPECT_LT(course.time * most, 1.035 * course.time_alone) << step << " s, " << most;
        }
    }
}

TEST(TeamSize, StaysAtOneThreadWhereMoreDoNotHelp) {
    TeamSize team(8);
    const Course course = run(team, 20.0, idle(100e-6, 55e-6));
    EXPECT_LT(course.mean_size, 1.1);
    EXPECT_LT(course.time, 1.03 * course.time_alone);
}

TEST(TeamSize, FindsTheBestSizeInBetween) {
    // step / n + (n - 1) * cost is least at n = 4.
    TeamSize team(16);
    run(team, 2.0, idle(1.6e-3, 100e-6));
    const Course course = run(team, 20.0, idle(1.6e-3, 100e-6));
    EXPECT_LT(course.time / course.steps, 1.1 * 700e-6);
}

// What spinning threads do to each other beside busy neighbors, and worse.
TEST(TeamSize, TrialsCostAtMostThreePercentHoweverSlowTheyAre) {
    for (const double slowdown : {1.2, 2.0, 15.0, 1000.0}) {
        for (const double step : {100e-6, 3e-3}) {
            TeamSize team(2);
            const Course course = run(team, 200.0, [=](int threads, double) {
                return threads == 1 ? step : slowdown * step;
            });
            EXPECT_LT(course.time, 1.035 * course.time_alone) << slowdown << " x " << step << " s";
        }
    }
}

TEST(TeamSize, NeighborsThatComeAndGoAreNoticedWithinASecond) {
    const Machine alone = idle(1e-3);
    const Machine crowded = [](int threads, double) { return threads == 1 ? 1e-3 : 3e-3; };
    for (const int most : {2, 8}) {
        TeamSize team(most);
        for (int change = 0; change < 5; ++change) {
            run(team, 1.0, crowded);
            EXPECT_LT(run(team, 2.0, crowded).mean_size, 1.1);
            run(team, 1.0, alone);
            EXPECT_GT(run(team, 2.0, alone).mean_size, 0.95 * most);
        }
    }
}

// Neighbors take the core for a time slice now and then, which hits every team.
TEST(TeamSize, NoiseCostsLessThanItGains) {
    Random random(1, 1);
    const auto step = [&](double work, double share) {
        double time = 0.0;
        for (double left = work; left > 0.0; left -= 50e-6) {
            time += std::min(left, 50e-6);
            if (random.uniform() < share * 50e-6 / 3e-3) time += 6e-3 * random.uniform();
        }
        return time;
    };
    // Two threads wait for each other: no faster, more often hit.
    TeamSize team(2);
    double with_team = 0.0;
    double with_one = 0.0;
    while (with_team < 60.0) {
        const bool is_alone = team.next() == 1;
        const double time = is_alone ? step(160e-6, 1.0) : step(180e-6, 1.7);
        team.step_took(time);
        with_team += time;
        with_one += step(160e-6, 1.0);
    }
    EXPECT_LT(with_team, 1.12 * with_one);
}

}  // namespace
}  // namespace dem
