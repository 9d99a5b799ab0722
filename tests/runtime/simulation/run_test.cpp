// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/run.hpp"

#include "common/error.hpp"
#include "runtime/files/body_table.hpp"
#include "runtime/output/folder_lock.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace dem::runtime {
namespace {

class Run : public TemporaryFolder {
  protected:
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

    const std::filesystem::path directory_ = folder_ / "run";
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

TEST_F(Run, IsNotAtRestBeforeItsWallsHaveBegunToMove) {
    Scene scene = bouncing_sphere();
    scene.run.end_time = 10.0;
    scene.run.stop_at_rest = true;
    scene.walls[0].motion.pieces = {{.kind = MotionPiece::Kind::translate,
                                     .velocity = {0.0, 0.0, 1e-3},
                                     .from = 1.5,
                                     .until = 1.6}};
    const RunResult result = run(std::move(scene), {});
    EXPECT_EQ(result.end, RunResult::End::at_rest);
    EXPECT_GT(result.time, 1.5);
    EXPECT_LT(result.time, 2.5);
}

TEST_F(Run, EndsWhereABodyRocksInPlaceUndamped) {
    Scene scene = scenes::one_material({2e6, 1250.0, 0.5, 0.4});
    scenes::add_kind(scene, scenes::candy(0));
    scene.walls = {scenes::plane({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0})};
    BodyPlacement body;
    body.position = {0.0, 0.0, 0.012};
    body.orientation = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
    scene.insertions.push_back(scenes::placed({body}));
    scene.run.end_time = 10.0;
    scene.run.stop_at_rest = true;
    scene.run.threads = 1;
    scene.output.directory = directory_.string();
    scene.output.picture = false;
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.end, RunResult::End::at_rest);
    EXPECT_EQ(result.reason, "bodies rock in place");
    EXPECT_LT(result.time, 5.0);
    // Not while it rolls away.
    scene.kinds.clear();
    scene.shapes.clear();
    scenes::add_kind(scene, scenes::sphere(5e-3));
    scene.insertions[0].placements[0].velocity = {0.02, 0.0, 0.0};
    scene.run.end_time = 5.0;
    scene.output.directory = (folder_ / "rolls").string();
    EXPECT_EQ(run(scene, {}).end, RunResult::End::end_time);
}

TEST_F(Run, ComputesAMeasureWhenItsOwnIntervalIsDue) {
    Scene scene = bouncing_sphere();
    scene.measures = {{"rare", MeasureSettings::Kind::contacts, 0.02},
                      {"usual", MeasureSettings::Kind::contacts, std::nullopt}};
    scene.run.end_time = 0.0501;
    run(std::move(scene), {});
    const auto history = lines("history.csv");
    ASSERT_EQ(history.size(), 1U + 12U);
    EXPECT_TRUE(history[0].ends_with(",rare_coordination,usual_coordination"));
    for (std::size_t row = 0; row < 12; ++row) {
        // Rows at 0, 5, 10, ... 50 ms and at the end, which has everything.
        const std::string& line = history[row + 1];
        const auto last = line.rfind(',');
        const bool is_empty = line[last - 1] == ',';
        EXPECT_EQ(is_empty, row % 4 != 0 && row != 11) << line;
        EXPECT_LT(last, line.size() - 1) << line;
    }
}

TEST_F(Run, CountsMeasuresAndFilesApartFromTheSteps) {
    Scene scene = bouncing_sphere();
    const RunResult result = run(scene, {});
    EXPECT_GT(result.measure_time, 0.0);
    EXPECT_GT(result.output_time, 0.0);
    const double steps = 1e-6 * result.microseconds_per_particle_step * 10000.0;
    EXPECT_NEAR(steps + result.measure_time + result.output_time, result.wall_time, 1e-9);
    EXPECT_NE(text("run/summary.json").find("\"measure_time\": "), std::string::npos);
}

TEST_F(Run, IsInterruptedAndKeepsWhatItHas) {
    const volatile std::sig_atomic_t stop = SIGTERM;
    RunOptions options;
    options.stop_signal = &stop;
    const RunResult result = run(bouncing_sphere(), options);
    EXPECT_EQ(result.end, RunResult::End::interrupted);
    EXPECT_EQ(result.reason, "SIGTERM");
    EXPECT_EQ(result.steps, 0U);
    EXPECT_EQ(lines("history.csv").size(), 1U + 1U);
    EXPECT_TRUE(std::filesystem::exists(directory_ / "final.csv"));
}

TEST_F(Run, ThatFailsEndsWithTheStateBefore) {
    Scene scene = bouncing_sphere();
    scene.run.domain = Aabb{Vec3(-1.0, -1.0, 0.01), Vec3(1.0, 1.0, 1.0)};
    const std::string message = message_of<Error>([&] { run(scene, {}); });
    // Free fall through 10 mm in steps of 10 us.
    EXPECT_NE(message.find("step 4516, time 0.04516 s: particle 0 has left the domain"),
              std::string::npos)
        << message;
    const std::string summary = text("run/summary.json");
    EXPECT_NE(summary.find("\"end\": \"failed\""), std::string::npos) << summary;
    EXPECT_NE(summary.find("has left the domain"), std::string::npos) << summary;
    const auto history = lines("history.csv");
    ASSERT_EQ(history.size(), 1U + 10U + 1U);
    EXPECT_TRUE(history.back().starts_with("0.04515")) << history.back();
    const auto final_state = text("run/final.csv");

    Scene shorter = bouncing_sphere();
    shorter.run.end_time = 0.04515;
    shorter.output.directory = (folder_ / "shorter").string();
    run(std::move(shorter), {});
    EXPECT_TRUE(text("shorter/final.csv") == final_state) << "the step that failed was taken back";

    RunOptions resume;
    resume.resume = true;
    EXPECT_EQ(message_of<Error>([&] { run(scene, resume); }), message) << "goes on from there";
    EXPECT_TRUE(text("run/final.csv") == final_state);
}

TEST_F(Run, ThatFailsEndsWithFiniteNumbers) {
    Scene scene = bouncing_sphere();
    ContactLaw law = scene.laws.at(0, 0);
    law.damping = std::numeric_limits<double>::quiet_NaN();
    scene.laws.set(0, 0, law);
    // The first contact makes a velocity that is no number, which spoils the position a step later.
    const std::string message = message_of<Error>([&] { run(scene, {}); });
    EXPECT_NE(message.find("not a number"), std::string::npos) << message;
    const auto bodies = read_body_table(directory_ / "final.csv");
    ASSERT_EQ(bodies.size(), 1U);
    EXPECT_NEAR(bodies[0].velocity.z(), -std::sqrt(2.0 * 9.81 * 0.015), 1e-3);
    EXPECT_NEAR(bodies[0].position.z(), 5e-3, 1e-5);
}

TEST_F(Run, RefusesAFolderWithResults) {
    std::filesystem::create_directories(directory_);
    std::ofstream(directory_ / "final.csv") << "of an earlier run\n";
    EXPECT_NE(message_of<Error>([&] { run(bouncing_sphere(), {}); }).find("--force"),
              std::string::npos);
    EXPECT_EQ(lines("final.csv"), std::vector<std::string>{"of an earlier run"});
    RunOptions options;
    options.force = true;
    EXPECT_EQ(run(bouncing_sphere(), options).steps, 10000U);
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

TEST_F(Run, KeepsOthersOutOfItsFolder) {
    {
        const FolderLock lock(directory_);
        std::string message;
        try {
            run(bouncing_sphere(), {});
        } catch (const Error& error) {
            message = error.what();
        }
        EXPECT_NE(message.find("another demrun (process " + std::to_string(getpid()) + ")"),
                  std::string::npos)
            << message;
        EXPECT_FALSE(std::filesystem::exists(directory_ / "history.csv"));
    }
    EXPECT_FALSE(std::filesystem::exists(directory_)) << "made for a run that wrote nothing";
    std::filesystem::create_directories(directory_);
    std::ofstream(directory_ / ".demrun.lock") << "1";  // of a run that was killed
    EXPECT_EQ(run(bouncing_sphere(), {}).steps, 10000U);
}

}  // namespace
}  // namespace dem::runtime
