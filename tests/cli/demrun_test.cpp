// SPDX-License-Identifier: BSD-3-Clause
#include "formats/hdf5_reader.hpp"
#include "tests/cli/program.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <algorithm>
#include <csignal>

#include <gtest/gtest.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

const char* const small_case =
    "[run]\nend_time = 20 ms\n"
    "[material.m]\ndensity = 1000\nyoungs_modulus = 5 MPa\npoissons_ratio = 0.3\n"
    "[contact]\nrestitution = 0.6\nfriction = 0.3\n"
    "[particles.balls]\nradius = 5 mm\nmaterial = m\ncount = 20\n"
    "region = box -20 -20 0 20 20 40 mm\n"
    "[wall.room]\nshape = box\nlower = -20 -20 0 mm\nupper = 20 20 60 mm\nmaterial = m\n";

class Demrun : public TemporaryFolder {
  protected:
    Demrun() { write("case.ini", small_case); }
    Outcome demrun(const std::string& arguments) const {
        return run_command(program("demrun") + " " + arguments, folder_);
    }
};

TEST_F(Demrun, AWrongCommandLineIsTwo) {
    for (const char* arguments : {"", "a.ini b.ini", "case.ini --chekc", "case.ini --threads x",
                                  "case.ini --threads -1", "case.ini --set", "case.ini --set nodot",
                                  "case.ini --res", "--unknown", "case.ini --out"}) {
        const Outcome outcome = demrun(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_TRUE(outcome.errors.starts_with("demrun: error: ")) << outcome.errors;
        EXPECT_EQ(outcome.errors.find('\n'), outcome.errors.size() - 1) << outcome.errors;
        EXPECT_EQ(outcome.output, "");
    }
}

TEST_F(Demrun, AnOverrideWithoutItsQuotesIsExplained) {
    const std::string expected =
        "demrun: error: --set: 's' found after 'run.end_time=3', expected quotes around a value "
        "with blanks: --set 'run.end_time=3 s'\n";
    for (const char* arguments :
         {"case.ini --set run.end_time=3 s", "case.ini --set=run.end_time=3 s",
          "--set run.end_time=3 s case.ini"}) {
        const Outcome outcome = demrun(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_EQ(outcome.errors, expected) << arguments;
    }
    EXPECT_EQ(demrun("case.ini --set run.gravity=0 0 -9.81").code, 2);
    EXPECT_EQ(demrun("--set run.seed=3 case.ini --check").code, 0);
}

TEST_F(Demrun, NoMessageHasTwoLines) {
    EXPECT_EQ(demrun("'none\nto be\tfound.ini'").errors,
              "demrun: error: none\\nto be\\tfound.ini: no such file, expected a case file\n");
}

TEST_F(Demrun, ADeviceIsNoCaseTemplateOrTable) {
    EXPECT_EQ(demrun("/dev/zero").errors,
              "demrun: error: /dev/zero: more than 16 MB found, expected a case file\n");
    const std::string device = " is a device or pipe, expected a file\n";
    EXPECT_EQ(demrun("case.ini --set particles.t.template=/dev/zero --set particles.t.material=m "
                     "--set particles.t.count=1 --set 'particles.t.region=box 0 0 0 1 1 1 mm'")
                  .errors,
              "demrun: error: --set particles.t.template: /dev/zero:" + device);
    EXPECT_EQ(demrun("case.ini --set particles.t.radius=1 --set particles.t.material=m "
                     "--set particles.t.insert=file --set particles.t.file=/dev/zero")
                  .errors,
              "demrun: error: /dev/zero:" + device);
}

TEST_F(Demrun, CheckNamesTheMotionsThatAreThere) {
    const std::string fast =
        "case.ini --check --set contact.model=linear --set contact.normal_stiffness=1 "
        "--set contact.tangential_restitution=1 --set 'particles.balls.velocity=0 0 -900'";
    const Outcome balls = demrun(fast);
    EXPECT_NE(balls.output.find("of the motion: one radius at"), std::string::npos)
        << balls.output << balls.errors;
    EXPECT_EQ(balls.output.find("half a period"), std::string::npos) << balls.output;
    const Outcome wall = demrun(fast +
                                " --set wall.room.motion=oscillate --set "
                                "wall.room.frequency=1 --set wall.room.amplitude=1e-3 "
                                "--set 'wall.room.direction=0 0 1'");
    EXPECT_NE(wall.output.find("half a period of a wall"), std::string::npos) << wall.output;
}

TEST_F(Demrun, ABadCaseIsOneLineAndOneAndWritesNothing) {
    const Outcome unknown = demrun("case.ini --set contact.frictoin=1");
    EXPECT_EQ(unknown.code, 1);
    EXPECT_EQ(unknown.errors,
              "demrun: error: --set contact.frictoin: unknown key 'frictoin' in [contact], did you "
              "mean 'friction'?\n");
    std::ofstream(folder_ / "case.ini", std::ios::app) << "colour = red\n";
    EXPECT_EQ(demrun("case.ini").errors.substr(0, 50),
              "demrun: error: case.ini:20: unknown key 'colour' i");
    EXPECT_EQ(demrun("none.ini").code, 1);
    EXPECT_FALSE(fs::exists(folder_ / "case"));
    EXPECT_FALSE(fs::exists(folder_ / "none"));
}

TEST_F(Demrun, ACaseThatCannotStartLeavesNoFolder) {
    const Outcome crowd = demrun("case.ini --set particles.balls.count=1000");
    EXPECT_EQ(crowd.code, 1);
    EXPECT_NE(crowd.errors.find("of 1000 bodies placed at random"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "case"));
    const Outcome steps = demrun("case.ini --set run.time_step=1e-300");
    EXPECT_EQ(steps.code, 1);
    EXPECT_NE(steps.errors.find("expected at most 1e15"), std::string::npos) << steps.errors;
    EXPECT_FALSE(fs::exists(folder_ / "case"));
}

TEST_F(Demrun, CheckDescribesAndWritesNothing) {
    const Outcome outcome = demrun("case.ini --check");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("balls: 20 x sphere"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("time step: "), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "case"));
}

TEST_F(Demrun, CheckFindsWhatCannotRun) {
    const Outcome crowd = demrun("case.ini --check --set particles.balls.count=1000");
    EXPECT_EQ(crowd.code, 1);
    EXPECT_NE(crowd.errors.find("of 1000 bodies placed at random"), std::string::npos);
    const Outcome step = demrun("case.ini --check --set 'run.time_step=10 ms'");
    EXPECT_EQ(step.code, 1);
    EXPECT_NE(step.errors.find("critical"), std::string::npos) << step.errors;
    EXPECT_EQ(
        demrun("case.ini --check --set 'run.time_step=10 ms' --set run.time_step_force=yes").code,
        0);
}

TEST_F(Demrun, HelpAndVersionNeedNoCase) {
    EXPECT_EQ(demrun("--version").output, "demrun " DEM_VERSION "\n");
    EXPECT_NE(demrun("--help").output.find("--threads"), std::string::npos);
    EXPECT_EQ(demrun("-h").output, demrun("--help").output);
    EXPECT_NE(demrun("--keys").output.find("`restitution`"), std::string::npos);
}

TEST_F(Demrun, ARunWritesItsResultsIntoAFolderOfTheCasesName) {
    const Outcome outcome = demrun("case.ini --threads 1 --quiet");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output + outcome.errors, "") << "quiet";
    for (const char* name :
         {"frames.h5", "frames.xdmf", "history.csv", "final.csv", "summary.json"}) {
        EXPECT_TRUE(fs::exists(folder_ / "case" / name)) << name;
    }
    const Outcome loud = demrun("case.ini --out elsewhere");
    EXPECT_NE(loud.output.find("20 particles"), std::string::npos) << loud.output;
    EXPECT_EQ(content(folder_ / "case/final.csv"), content(folder_ / "elsewhere/final.csv"))
        << "another number of threads";
}

TEST_F(Demrun, ARunCanStartFromAnothersEnd) {
    ASSERT_EQ(demrun("case.ini --quiet").code, 0);
    std::string text = small_case;
    const std::size_t start = text.find("count = 20\n");
    text.replace(start, text.find("[wall.room]") - start,
                 "insert = file\nfile = case/final.csv\noverlaps = allow\n");
    std::ofstream(folder_ / "again.ini") << text;
    const Outcome outcome = demrun("again.ini --check");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("balls: 20 x sphere"), std::string::npos);
    EXPECT_NE(outcome.output.find("(contacts begin anew: without their friction springs)"),
              std::string::npos)
        << outcome.output;
}

TEST_F(Demrun, AFolderThatCannotBeWrittenIsAnErrorBeforeTheRun) {
    std::ofstream(folder_ / "taken") << "a file";
    const Outcome outcome = demrun("case.ini --out taken");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.errors.find("taken"), std::string::npos) << outcome.errors;
    EXPECT_EQ(content(folder_ / "taken"), "a file");
}

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

TEST_F(Demrun, ASignalEndsTheRunWithEverythingSavedAndItsOwnExitCode) {
    struct Signal {
        int number;
        const char* name;
    };
    for (const Signal& signal :
         {Signal{SIGINT, "INT"}, Signal{SIGTERM, "TERM"}, Signal{SIGHUP, "HUP"},
          Signal{SIGUSR1, "USR1"}, Signal{SIGUSR2, "USR2"}}) {
        const Outcome outcome =
            run_command("timeout --preserve-status --signal " + std::string(signal.name) + " 0.5 " +
                            program("demrun") + " case.ini --force --set run.end_time=1h",
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
    const Outcome outcome =
        run_command("timeout --preserve-status --signal INT 0.5 bash loop.sh", folder_);
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

TEST_F(Demrun, ResultsAreNotReplacedUnlessForced) {
    ASSERT_EQ(demrun("case.ini --quiet").code, 0);
    const std::string state = content(folder_ / "case/final.csv");
    const std::string other = "case.ini --quiet --set run.seed=2 ";
    const Outcome refused = demrun(other);
    EXPECT_EQ(refused.code, 1);
    EXPECT_EQ(refused.errors,
              "demrun: error: case: holds the results of a run, expected another folder (--out), "
              "--resume to go on with it, or --force to write over it\n");
    EXPECT_TRUE(content(folder_ / "case/final.csv") == state);
    EXPECT_EQ(demrun(other + "--force").code, 0);
    EXPECT_FALSE(content(folder_ / "case/final.csv") == state);
    EXPECT_EQ(demrun(other + "--force --resume").code, 2);
}

TEST_F(Demrun, NothingOfARunThatIsWrittenOverStays) {
    ASSERT_EQ(demrun("case.ini --quiet --set output.surfaces=yes").code, 0);
    ASSERT_TRUE(fs::exists(folder_ / "case/surfaces.h5"));
    ASSERT_EQ(demrun("case.ini --quiet --force").code, 0);
    EXPECT_FALSE(fs::exists(folder_ / "case/surfaces.h5"));
    EXPECT_FALSE(fs::exists(folder_ / "case/surfaces.xdmf"));
}

TEST_F(Demrun, ClosedStandardStreamsAndBrokenPipesHarmNoFile) {
    ASSERT_EQ(demrun("case.ini --quiet --out open").code, 0);
    write("closed.sh", program("demrun") + " case.ini --out closed <&- >&- 2>&-\n" +
                           program("demrun") + " case.ini --out pipe 2>&1 | true\n");
    run_command("sh closed.sh", folder_);
    for (const char* folder : {"closed", "pipe"}) {
        for (const char* name : {"frames.h5", "history.csv", "final.csv", "checkpoint.h5"}) {
            EXPECT_TRUE(content(folder_ / "open" / name) == content(folder_ / folder / name))
                << folder << "/" << name;
        }
    }
}

TEST_F(Demrun, CheckWarnsOfACoarseTimeStep) {
    EXPECT_EQ(demrun("case.ini --check").output.find("warning: the time step"), std::string::npos);
    EXPECT_NE(demrun("case.ini --check --set run.time_step_divisor=5")
                  .output.find(
                      "warning: the time step is 0.2 of the critical time, expected a tenth of it"),
              std::string::npos);
}

TEST_F(Demrun, NumbersWithoutSenseAreAnswered) {
    const Outcome outcome = run_command(
        "timeout 10 " + program("demrun") + " case.ini --check --set 'run.gravity=0 0 -1e160'",
        folder_);
    EXPECT_EQ(outcome.code, 1) << outcome.output;
    EXPECT_NE(outcome.errors.find("expected at most 1e15"), std::string::npos) << outcome.errors;
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

TEST_F(Demrun, OutputThatCannotBeWrittenIsAnError) {
    for (const char* arguments :
         {"case.ini --check", "--keys", "--help", "--version", "case.ini"}) {
        const Outcome outcome = demrun(std::string(arguments) + " > /dev/full");
        EXPECT_EQ(outcome.code, 1) << arguments;
        EXPECT_TRUE(
            outcome.errors.ends_with("demrun: error: standard output: could not be written\n"))
            << outcome.errors;
    }
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

}  // namespace
}  // namespace dem
