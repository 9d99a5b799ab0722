// SPDX-License-Identifier: BSD-3-Clause
// How runs end, and how they go on from there.
#include "runtime/files/hdf5_reader.hpp"
#include "tests/cli/demrun_fixture.hpp"

#include <algorithm>
#include <csignal>
#include <map>
#include <utility>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

namespace fs = std::filesystem;

TEST_F(Demrun, BodiesThatFoundNoRoomAreCountedAndFailTheRun) {
    const std::string pour =
        "case.ini --quiet --force --set particles.balls.insert=batches --set "
        "particles.balls.every=4ms "
        "--set particles.balls.batch=10 --set run.end_time=9ms --set particles.balls.count=";
    const Outcome crowd = demrun(pour + "120 --set particles.balls.batch=50");
    EXPECT_EQ(crowd.code, 1);
    EXPECT_TRUE(crowd.errors.starts_with("demrun: error: case.ini:10: [particles.balls]: "))
        << crowd.errors;
    EXPECT_NE(crowd.errors.find(" of 120 bodies were placed, "), std::string::npos) << crowd.errors;
    EXPECT_EQ(crowd.errors.find('\n'), crowd.errors.size() - 1) << crowd.errors;
    EXPECT_NE(content(folder_ / "case/summary.json").find("\"balls\": "), std::string::npos);
    EXPECT_TRUE(fs::exists(folder_ / "case/final.csv")) << "what was computed is kept";

    const Outcome early = demrun(pour +
                                 "20 --set run.end_time=0.5ms "
                                 "--set run.time_step=5us");
    EXPECT_EQ(early.code, 0) << "the second batch was not due";
    EXPECT_EQ(early.errors,
              "demrun: warning: case.ini:10: [particles.balls]: 10 of 20 bodies were placed, the "
              "others were not due by 0.0005 s\n");
}

/// A command that gets a signal once it has written a file, or after a minute.
std::string signalled(const std::string& signal, const std::string& file,
                      const std::string& command) {
    return "{ (for k in $(seq 1200); do [ -s " + file + " ] && break; sleep 0.05; done; kill -" +
           signal + " $(cat pid)) & sh -c 'echo $$ > pid; exec " + command + "'; }";
}

TEST_F(Demrun, ASignalEndsTheRunWithEverythingSavedAndItsOwnExitCode) {
    struct Signal {
        int number;
        const char* name;
    };
    for (const Signal& signal :
         {Signal{SIGINT, "INT"}, Signal{SIGTERM, "TERM"}, Signal{SIGHUP, "HUP"},
          Signal{SIGUSR1, "USR1"}, Signal{SIGUSR2, "USR2"}}) {
        fs::remove_all(folder_ / "case");
        const Outcome outcome =
            run_command(signalled(signal.name, "case/history.csv",
                                  program("demrun") + " case.ini --set run.end_time=1h"),
                        folder_);
        EXPECT_EQ(outcome.code, 128 + signal.number) << outcome.errors;
        EXPECT_NE(outcome.errors.find("interrupted at "), std::string::npos) << outcome.errors;
        EXPECT_FALSE(content(folder_ / "case/final.csv").empty());
        EXPECT_TRUE(fs::exists(folder_ / "case/checkpoint.h5"));
        const std::string summary = content(folder_ / "case/summary.json");
        EXPECT_NE(summary.find("\"end\": \"interrupted\",\n  \"reason\": \"SIG" +
                               std::string(signal.name)),
                  std::string::npos)
            << summary;
    }
}

TEST_F(Demrun, ALimitOnCpuTimeEndsTheRunLikeASignal) {
    // SIGXCPU after one second, and then every second.
    const Outcome outcome = run_command(
        "ulimit -S -t 1; " + program("demrun") + " case.ini --set run.end_time=1h", folder_);
    EXPECT_EQ(outcome.code, 128 + SIGXCPU) << outcome.errors;
    EXPECT_NE(content(folder_ / "case/summary.json").find("SIGXCPU"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder_ / "case/checkpoint.h5"));
}

TEST_F(Demrun, AnInterruptEndsALoopOverSeeds) {
    write("loop.sh", "for seed in 1 2 3; do\n  echo $seed >> seeds\n  " + program("demrun") +
                         " case.ini --quiet --set run.end_time=1h --set run.seed=$seed --out "
                         "run$seed\ndone\n");
    const Outcome outcome = run_command(
        signalled("INT", "run1/history.csv", "timeout --preserve-status 600 bash loop.sh"),
        folder_);
    EXPECT_EQ(outcome.code, 128 + SIGINT) << outcome.errors;
    EXPECT_EQ(content(folder_ / "seeds"), "1\n");
    EXPECT_TRUE(fs::exists(folder_ / "run1/final.csv"));
}

TEST_F(Demrun, ARunThatFailsKeepsItsLastGoodState) {
    const Outcome outcome = demrun(
        "case.ini --quiet --set 'wall.room.open=bottom' --set 'run.domain=box -1 -1 -0.02 1 1 1' "
        "--set run.end_time=1");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.errors.find("has left the domain at"), std::string::npos) << outcome.errors;
    EXPECT_EQ(outcome.errors.find('\n'), outcome.errors.size() - 1) << outcome.errors;
    for (const char* name : {"final.csv", "final.png", "checkpoint.h5"}) {
        EXPECT_TRUE(fs::exists(folder_ / "case" / name)) << name;
    }
    const std::string summary = content(folder_ / "case/summary.json");
    EXPECT_NE(summary.find("\"end\": \"failed\",\n  \"reason\": \"case.ini: step "),
              std::string::npos)
        << summary;
}

TEST_F(Demrun, WhatKilledRunsHadBegunToWriteIsRemoved) {
    fs::create_directories(folder_ / "case");
    for (const char* name : {"checkpoint.h5.part-123-0", "final.csv.part-9-1", "my.part-123-0"}) {
        write(std::string("case/") + name, "begun");
    }
    ASSERT_EQ(demrun("case.ini --quiet").code, 0);
    EXPECT_FALSE(fs::exists(folder_ / "case/checkpoint.h5.part-123-0"));
    EXPECT_FALSE(fs::exists(folder_ / "case/final.csv.part-9-1"));
    EXPECT_TRUE(fs::exists(folder_ / "case/my.part-123-0")) << "is none of a run";
}

TEST_F(Demrun, AnInterruptedRunIsResumedToTheSameEnd) {
    const std::string run = program("demrun") + " case.ini --quiet --set run.end_time=400ms ";
    ASSERT_EQ(run_command(run + "--threads 1 --out whole", folder_).code, 0);
    // However far it gets before the signal.
    const Outcome first = run_command(
        "{ " + run +
            "--out parts & while kill -0 $! && ! test -s parts/history.csv; do sleep 0.01; done; "
            "kill -TERM $!; wait $!; }",
        folder_);
    ASSERT_EQ(first.code, 128 + SIGTERM) << first.errors;
    ASSERT_TRUE(fs::exists(folder_ / "parts/checkpoint.h5"));
    const Outcome second = run_command(run + "--out parts --resume --threads 2", folder_);
    EXPECT_EQ(second.code, 0) << second.errors;
    for (const char* name : {"final.csv", "history.csv", "frames.xdmf"}) {
        EXPECT_TRUE(content(folder_ / "whole" / name) == content(folder_ / "parts" / name)) << name;
    }
    const Outcome other =
        demrun("case.ini --quiet --out parts --resume --set contact.friction=0.1");
    EXPECT_EQ(other.code, 1);
    EXPECT_EQ(other.errors,
              "demrun: error: parts/checkpoint.h5: was made with '[contact] friction = 0.3' where "
              "the case now has '[contact] friction = 0.1', expected no change but of end_time, "
              "stop, overlap_limit, threads, skin and [output]\n");
}

TEST_F(Demrun, AKilledRunIsResumedFromItsLastCheckpoint) {
    const std::string run = program("demrun") +
                            " case.ini --quiet --set run.end_time=200ms --set "
                            "output.checkpoint_every=50ms --set output.frames_every=1s --out ";
    ASSERT_EQ(run_command(run + "whole", folder_).code, 0);
    const Outcome killed = run_command(
        "{ " + run +
            "parts & while kill -0 $! && ! test -e parts/checkpoint.h5; do sleep 0.01; done; "
            "kill -9 $!; wait $!; }",
        folder_);
    ASSERT_NE(killed.code, 1) << killed.errors;
    const Outcome resumed = run_command(run + "parts --resume", folder_);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    for (const char* name : {"final.csv", "history.csv", "frames.xdmf"}) {
        EXPECT_TRUE(content(folder_ / "whole" / name) == content(folder_ / "parts" / name)) << name;
    }
}

TEST_F(Demrun, FramesThatWereDamagedAreOneLineAndNoCrash) {
    const std::string run = "case.ini --quiet --out parts --set output.frames_every=0.5ms ";
    ASSERT_EQ(demrun(run).code, 0);
    const std::string frames = content(folder_ / "parts/frames.h5");
    fs::remove(folder_ / "parts/summary.json");  // as if it had been killed at its end
    for (const double place : {0.5, 0.9, 0.99, 0.995, 0.998, 0.999, 0.9995, 0.9998}) {
        std::string damaged = frames;
        char& byte = damaged[static_cast<std::size_t>(place * static_cast<double>(frames.size()))];
        byte = static_cast<char>(byte ^ 0x55);
        write("parts/frames.h5", damaged);
        const Outcome outcome = demrun(run + "--resume --set run.end_time=20.2ms");
        if (outcome.code == 0) continue;  // it was in space that nothing uses
        EXPECT_EQ(outcome.code, 1) << place;
        EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
        EXPECT_NE(outcome.errors.find("parts/frames.h5: "), std::string::npos) << outcome.errors;
    }
}

TEST_F(Demrun, PipesInPlaceOfResultsAreNamedAndNotWaitedFor) {
    fs::create_directories(folder_ / "case");
    for (const char* name : {"history.csv", "frames.h5", "final.csv"}) {
        const std::string made = "rm -f case/*; mkfifo case/" + std::string(name);
        const Outcome outcome = run_command(
            made + "; timeout 10 " + program("demrun") + " case.ini --quiet --force", folder_);
        EXPECT_EQ(outcome.code, 1) << name;
        EXPECT_EQ(outcome.errors, "demrun: error: case/" + std::string(name) +
                                      ": is a pipe, expected a file of results or nothing\n");
    }
}

TEST_F(Demrun, ACheckpointBehindTheEndTimeIsAnError) {
    ASSERT_EQ(demrun("case.ini --quiet").code, 0);
    const Outcome outcome = demrun("case.ini --quiet --resume --set run.end_time=5ms");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(outcome.errors.starts_with(
        "demrun: error: case.ini: end_time 0.005 s is before the checkpoint at 0.02"))
        << outcome.errors;
}

TEST_F(Demrun, AKeyThatCameOrWentSinceTheCheckpointIsNamed) {
    ASSERT_EQ(demrun("case.ini --quiet").code, 0);
    EXPECT_NE(
        demrun("case.ini --quiet --resume --set run.seed=2")
            .errors.find("was made without '[run] seed = 2', which the case now has, expected"),
        std::string::npos);
    ASSERT_EQ(demrun("case.ini --quiet --force --set run.seed=2").code, 0);
    EXPECT_NE(
        demrun("case.ini --quiet --resume")
            .errors.find("was made with '[run] seed = 2', which the case no longer has, expected"),
        std::string::npos);
}

TEST_F(Demrun, AFullDiskIsOneLineAndKeepsWhatWasWritten) {
    struct Limit {
        int blocks;  // of 512 bytes or of a kilobyte, as the shell likes
        const char* frames_every;
        const char* what;
    };
    for (const Limit& limit : {Limit{40, "1ms", "frames.h5"}, Limit{300, "0.2ms", "frames.h5"},
                               Limit{300, "1s", "history.csv"}}) {
        const Outcome outcome = run_command(
            "trap '' XFSZ; ulimit -f " + std::to_string(limit.blocks) + "; " + program("demrun") +
                " case.ini --quiet --force --out full --set output.history_every=5us --set "
                "run.time_step=5us" +
                " --set output.frames_every=" + limit.frames_every,
            folder_);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(outcome.errors, std::string("demrun: error: full/") + limit.what +
                                      ": cannot write: File too large\n");
        EXPECT_TRUE(fs::exists(folder_ / "full/final.csv"));
        EXPECT_NE(content(folder_ / "full/summary.json").find("File too large"), std::string::npos);
        const auto is_part = [](const fs::directory_entry& entry) {
            return entry.path().string().find(".part-") != std::string::npos;
        };
        EXPECT_EQ(std::count_if(fs::directory_iterator(folder_ / "full"), {}, is_part), 0);
        if (limit.blocks == 40) continue;  // not even one frame
        EXPECT_TRUE(content(folder_ / "full/history.csv").ends_with('\n')) << "whole rows only";
        const Hdf5Reader frames(folder_ / "full/frames.h5");
        EXPECT_GT(frames.members("/frames").size(), 0U);
    }
}

TEST_F(Demrun, BodiesWithoutRoomAreTheReasonInTheSummary) {
    const std::string pour =
        "case.ini --quiet --set particles.balls.insert=batches --set particles.balls.every=4ms "
        "--set particles.balls.batch=50 --set run.end_time=9ms --set particles.balls.count=120";
    const Outcome crowd = demrun(pour);
    EXPECT_EQ(crowd.code, 1);
    const std::string summary = content(folder_ / "case/summary.json");
    const std::string line = crowd.errors.substr(15, crowd.errors.size() - 16);
    EXPECT_NE(summary.find("\"end\": \"failed\",\n  \"reason\": \"" + line + "\""),
              std::string::npos)
        << summary << line;
    const Outcome again = demrun(pour + " --resume");
    EXPECT_EQ(again.code, 1);
    EXPECT_EQ(again.errors, crowd.errors);
    EXPECT_EQ(content(folder_ / "case/summary.json"), summary);
}

TEST_F(Demrun, AFinishedRunIsLeftAsItIsByResume) {
    const std::string run = "case.ini --set output.surfaces=yes ";
    ASSERT_EQ(demrun(run + "--quiet").code, 0);
    const auto files = [&] {
        std::map<std::string, std::pair<fs::file_time_type, std::string>> all;
        for (const auto& entry : fs::directory_iterator(folder_ / "case")) {
            if (entry.path().filename() == ".demrun.lock") continue;
            all[entry.path().filename().string()] = {fs::last_write_time(entry),
                                                     content(entry.path())};
        }
        return all;
    };
    const auto before = files();
    EXPECT_GE(before.size(), 9U);
    const Outcome again = demrun(run + "--resume --threads 2");
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_TRUE(again.output.starts_with("case: the run is finished, 20 particles after "))
        << again.output;
    EXPECT_EQ(again.output.find('\n'), again.output.size() - 1) << again.output;
    EXPECT_EQ(again.errors, "");
    EXPECT_TRUE(files() == before);
    // What is missing is made again, and a later end goes on.
    fs::remove(folder_ / "case/final.csv");
    EXPECT_EQ(demrun(run + "--quiet --resume").code, 0);
    EXPECT_TRUE(content(folder_ / "case/final.csv") == before.at("final.csv").second);
    EXPECT_EQ(demrun(run + "--quiet --resume --set run.end_time=21ms").code, 0);
    EXPECT_FALSE(content(folder_ / "case/final.csv") == before.at("final.csv").second);
}

TEST_F(Demrun, AResultThatIsMissingOrNoFileIsNamedOnResume) {
    const std::string all = " --set output.surfaces=yes --set output.contacts=yes";
    ASSERT_EQ(demrun("case.ini --quiet" + all).code, 0);
    int end_time = 20;  // [ms]
    const auto resume_without = [&](const std::string& name) {
        ++end_time;
        fs::rename(folder_ / "case" / name, folder_ / name);
        fs::create_directory(folder_ / "case" / name);
        const std::string resume =
            "timeout 10 " + program("demrun") +
            " case.ini --quiet --resume --set run.end_time=" + std::to_string(end_time) + "ms" +
            all;
        const Outcome outcome = run_command(resume, folder_);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(outcome.errors.find('\n'), outcome.errors.size() - 1) << outcome.errors;
        EXPECT_TRUE(outcome.errors.starts_with("demrun: error: case/" + name +
                                               ": is a folder, expected the "))
            << outcome.errors;
        fs::remove(folder_ / "case" / name);
        const Outcome missing = run_command(resume, folder_);
        fs::rename(folder_ / name, folder_ / "case" / name);
        return missing.errors;
    };
    EXPECT_EQ(resume_without("history.csv"),
              "demrun: error: case/history.csv: no such file, expected the history of the run that "
              "is resumed\n");
    resume_without("surfaces.h5");
    resume_without("contacts.h5");
}

TEST_F(Demrun, ABodyThatBeginsToRollDownATenthOfADegreeIsNotAtRest) {
    write("slope.ini",
          "[run]\nend_time = 0.3 s\nstop = at_rest\n"
          "[material.m]\ndensity = 1000\nyoungs_modulus = 5 MPa\npoissons_ratio = 0.3\n"
          "[contact]\nrestitution = 0.6\nfriction = 0.3\n"
          "[particles.ball]\nradius = 5 mm\nmaterial = m\ninsert = file\nfile = ball.csv\n"
          "[wall.slope]\nshape = plane\npoint = 0 0 0\nnormal = 0 0 1\nmaterial = m\n");
    write("ball.csv", "x,y,z\n0,0,0.005001\n");
    const auto end_on = [&](const std::string& normal) {
        const Outcome outcome = demrun(
            "slope.ini --quiet --force --set output.picture=no --set "
            "'wall.slope.normal=" +
            normal + "'");
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        const std::string summary = content(folder_ / "slope/summary.json");
        return summary.substr(summary.find("\"end\""), 18);
    };
    EXPECT_EQ(end_on("0 0 1"), "\"end\": \"at_rest\",\n");
    EXPECT_EQ(end_on("0.001745 0 1"), "\"end\": \"end_time\",");
}

}  // namespace
}  // namespace dem::runtime
