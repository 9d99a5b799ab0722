// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/run.hpp"

#include "common/error.hpp"
#include "runtime/files/body_table.hpp"
#include "runtime/files/hdf5_reader.hpp"
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
    scene.walls[0].motion.kind = WallMotion::Kind::translate;
    scene.walls[0].motion.velocity = {0.0, 0.0, 1e-3};
    scene.walls[0].motion.from = 1.5;
    scene.walls[0].motion.until = 1.6;
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

class ResumedRun : public Run {
  protected:
    // Bodies that come in batches, end in a heap and have a measure of their own interval.
    Scene pour(double end_time, int threads, const std::string& folder) const {
        Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.4});
        scenes::add_kind(scene, scenes::sphere(5e-3));
        InsertionGroup group;
        group.name = "balls";
        group.where = "test.ini:1";
        group.mode = InsertionGroup::Mode::batches;
        group.kinds = {0};
        group.count = 40;
        group.batch = 10;
        group.every = 0.02;
        group.region = CylinderRegion{{0.0, 0.0, 0.03}, {0.0, 0.0, 0.06}, 0.03};
        scene.insertions.push_back(group);
        scenes::add_vessel(scene, 0.03);
        scene.measures = {{"height", MeasureSettings::Kind::fill_height, 0.007}};
        scene.run.end_time = end_time;
        scene.run.time_step = 1e-5;
        scene.run.threads = threads;
        scene.case_lines = {"[run] seed = 1", "[contact] friction = 0.4"};
        scene.output.directory = (directory_ / folder).string();
        scene.output.frames_every = 0.01;
        scene.output.history_every = 0.0043;
        scene.output.surfaces = true;
        scene.output.picture = false;
        return scene;
    }
    RunResult resume(const Scene& scene) const {
        RunOptions options;
        options.resume = true;
        return run(scene, options);
    }
    std::string text(const std::filesystem::path& name) const {
        return TemporaryFolder::text(directory_ / name);
    }
    std::string resume_error(const Scene& scene) const {
        try {
            resume(scene);
        } catch (const Error& error) {
            return error.what();
        }
        return "fine";
    }
};

TEST_F(ResumedRun, LeavesTheFilesOfOneThatNeverStopped) {
    const RunResult whole = run(pour(0.1, 2, "whole"), {});
    run(pour(0.033, 1, "parts"), {});
    const auto checkpoint = directory_ / "parts/checkpoint.h5";
    std::filesystem::copy_file(checkpoint, directory_ / "early.h5");
    EXPECT_EQ(resume(pour(0.061, 3, "parts")).end, RunResult::End::end_time);
    // As if it had been killed before the next checkpoint: the files have more than that one says.
    std::filesystem::rename(directory_ / "early.h5", checkpoint);
    std::ofstream(directory_ / "parts/history.csv", std::ios::app) << "0.06,";
    const RunResult last = resume(pour(0.1, 2, "parts"));

    EXPECT_EQ(last.state_hash, whole.state_hash);
    EXPECT_EQ(last.steps, whole.steps);
    for (const char* name : {"history.csv", "final.csv", "frames.xdmf"}) {
        EXPECT_TRUE(text(std::filesystem::path("parts") / name) ==
                    text(std::filesystem::path("whole") / name))
            << name;
    }
    const Hdf5Reader expected(directory_ / "whole/frames.h5");
    const Hdf5Reader found(directory_ / "parts/frames.h5");
    EXPECT_EQ(found.members("/frames"), expected.members("/frames"));
    EXPECT_EQ(found.members("/points"), expected.members("/points"));
    const Hdf5Reader surfaces(directory_ / "parts/surfaces.h5");
    EXPECT_EQ(surfaces.members("/frames"), expected.members("/frames"));
}

TEST_F(ResumedRun, ToALaterEndKeepsTheIntervalsOfTheRunThatBegan) {
    const auto automatic = [&](double end_time, const char* folder) {
        Scene scene = pour(end_time, 1, folder);
        scene.output.frames_every.reset();
        scene.output.history_every.reset();
        scene.measures[0].every.reset();
        return scene;
    };
    run(automatic(0.03, "parts"), {});
    resume(automatic(0.07, "parts"));
    Scene whole = automatic(0.07, "whole");
    whole.output.frames_every = 0.03 / 100.0;
    whole.output.history_every = 0.03 / 1000.0;
    run(whole, {});
    for (const char* name : {"history.csv", "frames.xdmf"}) {
        EXPECT_TRUE(text(std::filesystem::path("parts") / name) ==
                    text(std::filesystem::path("whole") / name))
            << name;
    }
}

TEST_F(ResumedRun, ThatHadEndedDoesNothingMore) {
    Scene scene = pour(3.0, 1, "rest");
    scene.run.stop_at_rest = true;
    scene.insertions[0].count = 4;
    const RunResult first = run(scene, {});
    ASSERT_EQ(first.end, RunResult::End::at_rest);
    const std::string history = text("rest/history.csv");
    const RunResult again = resume(scene);
    EXPECT_EQ(again.end, RunResult::End::at_rest);
    EXPECT_EQ(again.steps, first.steps);
    EXPECT_EQ(again.state_hash, first.state_hash);
    EXPECT_EQ(text("rest/history.csv"), history);
}

TEST_F(ResumedRun, RefusesWhatItCannotContinueAndTouchesNothing) {
    EXPECT_NE(resume_error(pour(0.02, 1, "a")).find("checkpoint.h5: not found"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(directory_ / "a"));
    run(pour(0.02, 1, "a"), {});
    const std::string history = text("a/history.csv");

    Scene other = pour(0.04, 1, "a");
    other.case_lines[1] = "[contact] friction = 0.5";
    EXPECT_NE(resume_error(other).find("was made with '[contact] friction = 0.4' where the case "
                                       "now has '[contact] friction = 0.5'"),
              std::string::npos);
    Scene step = pour(0.04, 1, "a");
    step.run.time_step = 2e-5;
    EXPECT_NE(resume_error(step).find("another time step"), std::string::npos);
    Scene wall = pour(0.04, 1, "a");
    wall.walls.pop_back();
    EXPECT_NE(resume_error(wall).find("other lengths"), std::string::npos);
    EXPECT_EQ(text("a/history.csv"), history);

    Scene measures = pour(0.04, 1, "a");
    measures.measures.clear();
    EXPECT_NE(resume_error(measures).find("history.csv: other columns"), std::string::npos);
    // The same without running (demrun --resume --check).
    EXPECT_THROW(check_resume(other), Error);
    EXPECT_THROW(check_resume(step), Error);
    EXPECT_THROW(check_resume(pour(0.02, 1, "b")), Error);
    EXPECT_NO_THROW(check_resume(pour(0.04, 1, "a")));
    EXPECT_EQ(text("a/history.csv"), history);
}

TEST_F(ResumedRun, RefusesRowsThatWereChanged) {
    run(pour(0.03, 1, "a"), {});
    std::string history = text("a/history.csv");
    const std::size_t digit = history.find('\n') + 3;
    history[digit] = history[digit] == '1' ? '2' : '1';
    std::ofstream(directory_ / "a/history.csv") << history;
    const std::string message = resume_error(pour(0.04, 1, "a"));
    EXPECT_NE(message.find("history.csv: rows changed since they were written found"),
              std::string::npos)
        << message;
    EXPECT_EQ(text("a/history.csv"), history);
}

TEST_F(ResumedRun, RefusesFramesThatWereDamaged) {
    run(pour(0.03, 1, "a"), {});
    // The place of a body in the second frame, as the file holds it.
    const Hdf5Reader frames(directory_ / "a/frames.h5");
    const std::vector<std::byte> positions = frames.content("/frames/00000001/position");
    std::string file = text("a/frames.h5");
    const std::size_t place =
        file.find(std::string(reinterpret_cast<const char*>(positions.data()), positions.size()));
    ASSERT_NE(place, std::string::npos);
    file[place + 4] = static_cast<char>(file[place + 4] ^ 1);
    std::ofstream(directory_ / "a/frames.h5", std::ios::binary) << file;
    const std::string message = resume_error(pour(0.04, 1, "a"));
    EXPECT_NE(message.find("frames.h5: has a frame /frames/00000001 that was changed after it was "
                           "written, expected the frames before the checkpoint"),
              std::string::npos)
        << message;
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
