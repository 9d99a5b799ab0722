// SPDX-License-Identifier: BSD-3-Clause
#include "common/progress.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace dem {
namespace {

TEST(Progress, QuietPrintsNothing) {
    std::ostringstream out;
    double now = 0.0;
    {
        Progress progress(out, Progress::Style::quiet, "run", 10.0, [&] { return now; });
        for (; now < 100.0; now += 1.0) progress.update(now / 10.0);
        progress.finish();
    }
    EXPECT_EQ(out.str(), "");
}

TEST(Progress, LinesComeAtEveryTenthHoweverOftenItIsUpdated) {
    std::ostringstream out;
    double now = 0.0;
    Progress progress(out, Progress::Style::lines, "run", 1000.0, [&] { return now; });
    for (int i = 0; i <= 1000; ++i) {
        now = 0.01 * i;
        progress.update(i);
    }
    progress.finish("150 particles");
    const std::string text = out.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_NE(text.find("run  50.0 %, 5 s, about 5 s left\n"), std::string::npos) << text;
    EXPECT_NE(text.find("run done in 10 s, 150 particles\n"), std::string::npos) << text;
}

TEST(Progress, SlowWorkIsReportedEveryMinute) {
    std::ostringstream out;
    double now = 0.0;
    Progress progress(out, Progress::Style::lines, "run", 1e6, [&] { return now; });
    for (int i = 1; i <= 600; ++i) {
        now = i;
        progress.update(i);
    }
    const std::string text = out.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

TEST(Progress, TheEstimateFollowsAChangeOfPace) {
    std::ostringstream out;
    double now = 0.0;
    double done = 0.0;
    Progress progress(out, Progress::Style::terminal, "run", 200.0, [&] { return now; });
    // 10 per second for 10 s, then 1 per second for 60 s: 40 remain, 40 s at the present pace (18 s
    // by the average since the start).
    for (int i = 0; i < 700; ++i) {
        now += 0.1;
        done += now <= 10.0 ? 1.0 : 0.1;
        progress.update(done);
    }
    EXPECT_NE(out.str().find("about 40 s left", out.str().rfind('\r')), std::string::npos)
        << out.str().substr(out.str().rfind('\r'));
}

TEST(Progress, TheFirstEstimateOfResumedWorkIsOfMoreThanAStep) {
    for (const auto style : {Progress::Style::lines, Progress::Style::terminal}) {
        std::ostringstream out;
        double now = 0.0;
        Progress progress(out, style, "run", 1000.0, [&] { return now; });
        now = 5.0;  // reading
        progress.begin_at(486.0);
        // The first step takes as long as a hundred later ones, which say what is left.
        now += 0.1;
        for (double done = 487.0; done <= 600.0; done += 1.0, now += 0.001) progress.update(done);
        EXPECT_EQ(out.str().find("51 s left"), std::string::npos) << out.str();
        EXPECT_NE(out.str().find("about 1 s left"), std::string::npos) << out.str();
    }
}

TEST(Progress, WorkOfUnevenStagesHasNoEstimate) {
    std::ostringstream out;
    double now = 0.0;
    Progress progress(out, Progress::Style::lines, "run", 1.0, [&] { return now; });
    progress.leave_out_estimate();
    now = 5.0;
    progress.update(0.5, "fitting");
    EXPECT_EQ(out.str(), "run  50.0 %, 5 s, fitting\n");
}

TEST(Progress, TheTerminalLineIsWipedAndEnded) {
    std::ostringstream out;
    double now = 0.0;
    {
        Progress progress(out, Progress::Style::terminal, "run", 10.0, [&] { return now; });
        now = 1.0;
        progress.update(5.0, "a long note");
        now = 2.0;
        progress.update(6.0);
    }
    const std::string text = out.str();
    const std::size_t second = text.rfind('\r');
    EXPECT_EQ(text.size() - second, second + 1) << "as wide as the first, then a line end";
    EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, DurationsReadWell) {
    EXPECT_EQ(format_duration(0.2), "0 s");
    EXPECT_EQ(format_duration(59.4), "59 s");
    EXPECT_EQ(format_duration(200.0), "3 min 20 s");
    EXPECT_EQ(format_duration(7500.0), "2 h 05 min");
}

}  // namespace
}  // namespace dem
