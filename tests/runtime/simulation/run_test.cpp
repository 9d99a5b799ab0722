// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/run.hpp"

#include "common/error.hpp"
#include "formats/body_table.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace dem {
namespace {

class Run : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        directory_ =
            std::filesystem::temp_directory_path() / (std::string("run_test_") + test->name());
        std::filesystem::remove_all(directory_);
    }
    void TearDown() override { std::filesystem::remove_all(directory_); }

    Scene bouncing_sphere() const {
        Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.4});
        scenes::add_kind(scene, scenes::sphere(5e-3));
        BodyPlacement body;
        body.position = {0.0, 0.0, 0.02};
        scene.insertions.push_back(scenes::placed({body}));
        scenes::add_vessel(scene, 0.05);
        scene.measures = {{"height", MeasureSettings::Kind::fill_height, 0.01},
                          {"density", MeasureSettings::Kind::solid_fraction, 0.01}};
        scene.run.end_time = 0.1;
        scene.run.time_step = 1e-5;
        scene.run.threads = 1;
        scene.output.directory = directory_.string();
        scene.output.frames_every = 0.02;
        scene.output.history_every = 0.005;
        return scene;
    }

    std::vector<std::string> lines(const char* name) const {
        std::ifstream in(directory_ / name);
        std::vector<std::string> result;
        for (std::string line; std::getline(in, line);) result.push_back(line);
        return result;
    }

    std::filesystem::path directory_;
};

TEST_F(Run, WritesEverythingThatIsDue) {
    const RunResult result = run(bouncing_sphere(), {});
    EXPECT_EQ(result.end, RunResult::End::end_time);
    EXPECT_EQ(result.steps, 10000U);
    EXPECT_DOUBLE_EQ(result.time, 0.1);
    const auto history = lines("history.csv");
    ASSERT_EQ(history.size(), 1U + 21U);
    EXPECT_NE(history[0].find("height_highest,height_top_ten,height_surface,density"),
              std::string::npos);
    EXPECT_EQ(history[2].substr(0, 10), "0.005,500,");
    EXPECT_EQ(read_body_table(directory_ / "final.csv").size(), 1U);
    for (const char* name : {"frames.h5", "frames.xdmf", "summary.json"}) {
        EXPECT_TRUE(std::filesystem::exists(directory_ / name)) << name;
    }
}

TEST_F(Run, EndsAtRest) {
    Scene scene = bouncing_sphere();
    scene.run.end_time = 10.0;
    scene.run.stop_at_rest = true;
    const RunResult result = run(std::move(scene), {});
    EXPECT_EQ(result.end, RunResult::End::at_rest);
    EXPECT_LT(result.time, 1.0);
}

TEST_F(Run, IsInterruptedAfterAStepAndKeepsWhatItHas) {
    const volatile std::sig_atomic_t stop = 1;
    RunOptions options;
    options.stop_requested = &stop;
    const RunResult result = run(bouncing_sphere(), options);
    EXPECT_EQ(result.end, RunResult::End::interrupted);
    EXPECT_EQ(result.steps, 1U);
    EXPECT_EQ(lines("history.csv").size(), 3U);
    EXPECT_TRUE(std::filesystem::exists(directory_ / "final.csv"));
}

TEST_F(Run, ThatFailsKeepsTheRowsBeforeAndLeavesNoFinalState) {
    std::filesystem::create_directories(directory_);
    std::ofstream(directory_ / "final.csv") << "of an earlier run\n";
    Scene scene = bouncing_sphere();
    scene.run.domain = Aabb{Vec3(-1.0, -1.0, 0.01), Vec3(1.0, 1.0, 1.0)};
    EXPECT_THROW(run(std::move(scene), {}), Error);
    EXPECT_EQ(lines("history.csv").size(), 1U + 10U);
    EXPECT_FALSE(std::filesystem::exists(directory_ / "final.csv"));
}

TEST_F(Run, RefusesAFolderThatCannotBeMade) {
    std::ofstream(directory_) << "a file is in the way\n";
    EXPECT_THROW(run(bouncing_sphere(), {}), Error);
}

TEST_F(Run, RefusesASolidFractionWithoutAVessel) {
    Scene scene = bouncing_sphere();
    scene.walls.clear();
    EXPECT_THROW(run(std::move(scene), {}), Error);
}

}  // namespace
}  // namespace dem
