// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "runtime/files/hdf5_reader.hpp"
#include "runtime/run.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/sample_walls.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

class ResumedRun : public TemporaryFolder {
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
        scene.output.contacts = true;
        scene.output.wall_forces = WallForceColumns::faces;
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

    const std::filesystem::path directory_ = folder_ / "run";
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
    for (const char* name :
         {"history.csv", "final.csv", "frames.xdmf", "surfaces.xdmf", "contacts.xdmf"}) {
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
    EXPECT_EQ(surfaces.members("/topologies"),
              Hdf5Reader(directory_ / "whole/surfaces.h5").members("/topologies"));
    const Hdf5Reader contacts(directory_ / "parts/contacts.h5");
    const Hdf5Reader expected_contacts(directory_ / "whole/contacts.h5");
    std::uint64_t count = 0;
    for (const std::string& frame : expected.members("/frames")) {
        const std::string group = "/frames/" + frame;
        EXPECT_EQ(contacts.number(group, "hash"), expected_contacts.number(group, "hash"));
        count += contacts.number(group, "count");
    }
    EXPECT_GT(count, 5U);
}

// Neither the step at which a signal comes nor the one at which the heap is at rest was foreseen.
TEST_F(ResumedRun, TheLastFrameHasItsContactsHoweverTheRunEnds) {
    const volatile std::sig_atomic_t stop = SIGTERM;
    RunOptions options;
    options.stop_signal = &stop;
    EXPECT_EQ(run(pour(0.1, 1, "stopped"), options).end, RunResult::End::interrupted);
    options.resume = true;
    EXPECT_EQ(run(pour(0.1, 1, "stopped"), options).end, RunResult::End::interrupted);
    Scene resting = pour(20.0, 1, "resting");
    resting.insertions[0].count = 10;
    resting.output.frames_every = 1.0;
    resting.run.stop_at_rest = true;
    EXPECT_EQ(run(resting, {}).end, RunResult::End::at_rest);
    const Hdf5Reader frames(directory_ / "resting/frames.h5");
    const Hdf5Reader contacts(directory_ / "resting/contacts.h5");
    EXPECT_EQ(contacts.members("/frames"), frames.members("/frames"));
    const std::string last = "/frames/" + frames.members("/frames").back();
    EXPECT_GE(contacts.number(last, "count"), 10U);
}

TEST_F(ResumedRun, GoesOnSummingWhatIsDoneToTriangles) {
    const auto pour_on_plate = [&](double end_time, int threads, const char* folder) {
        Scene scene = pour(end_time, threads, folder);
        Wall plate;
        plate.name = "plate";
        plate.position = {0.0, 0.0, 2e-3};
        plate.shape = MeshWall{std::make_shared<const WallMesh>(
            sample::plate({-0.03, -0.03}, {0.03, 0.03}, 5, 5).wall())};
        scene.walls.push_back(plate);
        scene.output.wall_contacts = true;
        return scene;
    };
    run(pour_on_plate(0.15, 1, "whole"), {});
    run(pour_on_plate(0.093, 2, "parts"), {});
    Scene without = pour_on_plate(0.15, 2, "parts");
    without.output.wall_contacts = false;
    EXPECT_NE(resume_error(without).find("was made with another setting of wall_contacts"),
              std::string::npos);
    EXPECT_EQ(resume(pour_on_plate(0.15, 3, "parts")).end, RunResult::End::end_time);
    EXPECT_TRUE(text("parts/wall_contacts.xdmf") == text("whole/wall_contacts.xdmf"));
    const Hdf5Reader expected(directory_ / "whole/wall_contacts.h5");
    const Hdf5Reader found(directory_ / "parts/wall_contacts.h5");
    ASSERT_EQ(found.members("/frames"), expected.members("/frames"));
    for (const std::string& frame : expected.members("/frames"))
        EXPECT_EQ(found.number("/frames/" + frame, "hash"),
                  expected.number("/frames/" + frame, "hash"));
}

TEST_F(ResumedRun, GoesOnCountingWhatHasGoneOut) {
    const auto pour_out = [&](double end_time, int threads, const char* folder) {
        Scene scene = pour(end_time, threads, folder);
        scene.insertions[0].velocity = {0.0, 0.0, -1.0};
        scene.outlets.push_back({.name = "drain",
                                 .where = "test.ini:2",
                                 .place = BoxRegion{{{0.0, -1.0, -1.0}, {1.0, 1.0, 8e-3}}}});
        scene.outlets.push_back({.name = "gate",
                                 .where = "test.ini:3",
                                 .kind = Outlet::Kind::flow,
                                 .place = HalfSpace{{0.0, 0.0, 0.02}, {0.0, 0.0, -1.0}}});
        return scene;
    };
    const RunResult whole = run(pour_out(0.1, 2, "whole"), {});
    run(pour_out(0.047, 1, "parts"), {});
    const RunResult last = resume(pour_out(0.1, 3, "parts"));
    EXPECT_EQ(last.state_hash, whole.state_hash);
    EXPECT_LT(last.particles, 40U) << "somebody has gone";
    const std::string history = text("whole/history.csv");
    EXPECT_NE(history.find("removed,drain_bodies,drain_mass,drain_body_rate,drain_mass_rate,"
                           "gate_bodies"),
              std::string::npos);
    EXPECT_TRUE(text("parts/history.csv") == history);
    EXPECT_TRUE(text("parts/final.csv") == text("whole/final.csv"));
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
    EXPECT_NE(resume_error(measures).find("history.csv: found other columns"), std::string::npos);
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
    EXPECT_NE(message.find("history.csv: found rows changed since they were written"),
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

}  // namespace
}  // namespace dem::runtime
