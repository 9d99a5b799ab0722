// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/demrun_fixture.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

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
        "demrun: error: --set: found 's' after 'run.end_time=3', expected quotes around a value "
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

TEST_F(Demrun, LanesThatThereAreNotAreNamed) {
    for (const char* lanes : {"3", "16", "", "two"}) {
        const Outcome outcome = run_command(
            "DEM_LANES='" + std::string(lanes) + "' " + program("demrun") + " case.ini --check",
            folder_);
        EXPECT_EQ(outcome.code, 1) << lanes;
        EXPECT_TRUE(outcome.errors.starts_with("demrun: error: DEM_LANES: '" + std::string(lanes) +
                                               "' found, expected 1, 2, 4 or 8 and at most "))
            << outcome.errors;
    }
}

TEST_F(Demrun, NoMessageHasTwoLines) {
    EXPECT_EQ(demrun("'none\nto be\tfound.ini'").errors,
              "demrun: error: none\\nto be\\tfound.ini: no such file, expected a case file\n");
}

TEST_F(Demrun, ADeviceIsNoCaseTemplateOrTable) {
    EXPECT_EQ(demrun("/dev/zero").errors,
              "demrun: error: /dev/zero: found more than 16 MB, expected a case file\n");
    const std::string device = " is a device, expected a ";
    EXPECT_EQ(demrun("case.ini --set particles.t.template=/dev/zero --set particles.t.material=m "
                     "--set particles.t.count=1 --set 'particles.t.region=box 0 0 0 1 1 1 mm'")
                  .errors,
              "demrun: error: --set particles.t.template: /dev/zero:" + device +
                  "template made by shapegen\n");
    EXPECT_EQ(demrun("case.ini --set particles.t.radius=1 --set particles.t.material=m "
                     "--set particles.t.insert=file --set particles.t.file=/dev/zero")
                  .errors,
              "demrun: error: /dev/zero:" + device + "table of bodies\n");
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
    std::ofstream(folder_ / "case.ini", std::ios::app) << "color = red\n";
    EXPECT_EQ(demrun("case.ini").errors.substr(0, 49),
              "demrun: error: case.ini:20: unknown key 'color' i");
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
    const auto checked = [&](const std::string& options) {
        return demrun(other + "--check " + options).output;
    };
    const std::string warning = "warning: the run would be refused: case holds the results";
    EXPECT_NE(checked("").find(warning), std::string::npos) << checked("");
    EXPECT_EQ(checked("--force").find(warning), std::string::npos);
    EXPECT_EQ(demrun(other + "--force").code, 0);
    EXPECT_FALSE(content(folder_ / "case/final.csv") == state);
    EXPECT_EQ(demrun(other + "--force --resume").code, 2);
}

TEST_F(Demrun, NothingOfARunThatIsWrittenOverStays) {
    const std::string all = "--set output.surfaces=yes --set output.contacts=yes";
    ASSERT_EQ(demrun("case.ini --quiet " + all).code, 0);
    ASSERT_TRUE(fs::exists(folder_ / "case/surfaces.h5"));
    ASSERT_TRUE(fs::exists(folder_ / "case/contacts.h5"));
    ASSERT_EQ(demrun("case.ini --quiet --force").code, 0);
    EXPECT_FALSE(fs::exists(folder_ / "case/surfaces.h5"));
    EXPECT_FALSE(fs::exists(folder_ / "case/surfaces.xdmf"));
    EXPECT_FALSE(fs::exists(folder_ / "case/contacts.h5"));
    EXPECT_FALSE(fs::exists(folder_ / "case/contacts.xdmf"));
}

TEST_F(Demrun, TheLastLineTellsHowManyWereTakenOut) {
    const Outcome outcome = demrun(
        "case.ini --set run.end_time=100ms --set 'run.gravity=0 0 -9.81' --set "
        "wall.room.open=bottom "
        "--set 'run.domain=box -25 -25 -10 25 25 70 mm' --set run.domain_exit=remove "
        "--set output.picture=no");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_TRUE(outcome.output.starts_with("0 particles, 20 more were taken out, "))
        << outcome.output;
    EXPECT_EQ(demrun("case.ini --force").output.find("taken out"), std::string::npos);
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

TEST_F(Demrun, APipeASocketOrAFolderIsNoCase) {
    ASSERT_EQ(mkfifo((folder_ / "pipe.ini").c_str(), 0600), 0);
    fs::create_directory(folder_ / "folder.ini");
    fs::create_symlink("nowhere.ini", folder_ / "broken.ini");
    fs::create_symlink("case.ini", folder_ / "link.ini");
    const auto answer = [&](const std::string& arguments) {
        return run_command("timeout 10 " + program("demrun") + " " + arguments, folder_).errors;
    };
    const std::string error = "demrun: error: ";
    EXPECT_EQ(answer("pipe.ini"),
              error + "pipe.ini: is a pipe that nothing comes out of, expected a case file\n");
    EXPECT_EQ(answer("folder.ini"), error + "folder.ini: is a folder, expected a case file\n");
    EXPECT_EQ(answer("broken.ini"),
              error + "broken.ini: is a link to nothing, expected a case file\n");
    fs::create_symlink("loop.ini", folder_ / "loop.ini");
    EXPECT_EQ(answer("loop.ini"), error + "loop.ini: is a link to itself, expected a case file\n");
    EXPECT_EQ(answer("link.ini --check"), "");
    EXPECT_EQ(answer("/dev/null"),
              error + "/dev/null: is a device that nothing comes out of, expected a case file\n");
}

TEST_F(Demrun, ACaseThatComesSlowlyThroughAPipeIsRead) {
    const Outcome outcome = run_command(
        "{ sleep 0.2; head -c 50 case.ini; sleep 0.2; tail -c +51 case.ini; } | timeout 10 " +
            program("demrun") + " /dev/stdin --check",
        folder_);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("balls: 20 x sphere"), std::string::npos) << outcome.output;
}

TEST_F(Demrun, CountsMayHaveAnExponentOrAPoint) {
    const Outcome twenty = demrun("case.ini --check --threads 1");
    for (const char* count : {"2e1", "20.0", "20.", "+20", "0.2e2"}) {
        const Outcome outcome = demrun(
            "case.ini --check --threads 1.0 --set particles.balls.count=" + std::string(count));
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_EQ(outcome.output, twenty.output) << count;
    }
    for (const char* count : {"1.5", "1e-1", "-3", "5e9", "1e30"}) {
        const Outcome outcome =
            demrun("case.ini --check --set particles.balls.count=" + std::string(count));
        EXPECT_EQ(outcome.code, 1);
        EXPECT_TRUE(
            outcome.errors.starts_with("demrun: error: --set particles.balls.count: found '" +
                                       std::string(count) + "', expected "))
            << outcome.errors;
    }
}

TEST_F(Demrun, WhatIsMissingIsSaidWithWhatIsExpected) {
    const auto expect_line = [&](const std::string& arguments, const std::string& line) {
        const Outcome outcome = demrun("case.ini " + arguments);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(outcome.errors, "demrun: error: " + line + "\n");
    };
    const std::string body =
        "--set particles.t.material=m --set particles.t.count=1 --set "
        "'particles.t.region=box 0 0 0 1 1 1 mm' --set particles.t.template=";
    expect_line(body + "none.tpl",
                "--set particles.t.template: none.tpl: no such file, expected a "
                "template made by shapegen");
    expect_line(body + ".",
                "--set particles.t.template: .: is a folder, expected a template made "
                "by shapegen");
    expect_line("--check --set particles.balls.fixed=yes",
                "case.ini: found time_step = auto where no body can move, expected a time_step");
    expect_line("--out case.ini",
                "case.ini: is no folder, expected one for the results or a new name (--out)");
    expect_line("--out case.ini/sub",
                "case.ini/sub: cannot make the output folder: Not a "
                "directory, expected another one (--out)");
}

}  // namespace
}  // namespace dem
