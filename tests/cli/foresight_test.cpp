// SPDX-License-Identifier: BSD-3-Clause
// What demrun --check foresees of a run, and what a run says that did not heed it.
#include "tests/cli/program.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

namespace dem {
namespace {

/// A ball that falls by 100 mm onto a floor.
const char* const soft_drop =
    "[run]\nend_time = 0.2 s\n"
    "[material.m]\ndensity = 2500\nyoungs_modulus = 1 MPa\npoissons_ratio = 0.3\n"
    "[contact]\nrestitution = 0.7\nfriction = 0.3\n"
    "[particles.s]\nradius = 5 mm\nmaterial = m\ninsert = file\nfile = drop.csv\n"
    "[wall.floor]\nshape = plane\npoint = 0 0 0\nnormal = 0 0 1\nmaterial = m\n"
    "[output]\npicture = no\nhistory_every = 0.1 ms\n";

class Foresight : public TemporaryFolder {
  protected:
    Foresight() {
        write("case.ini", soft_drop);
        write("drop.csv", "x,y,z\n0,0,0.105\n");
    }
    Outcome demrun(const std::string& arguments) const {
        return run_command(program("demrun") + " case.ini --quiet " + arguments, folder_);
    }
    static std::string modulus_in(const std::string& text) {
        std::smatch found;
        const std::regex expected("youngs_modulus = ([0-9.]+ [kMG]?Pa) in \\[material\\.m\\]");
        return std::regex_search(text, found, expected) ? found[1].str() : "none in " + text;
    }
    static double pascals(const std::string& modulus) {
        const double prefix = modulus.ends_with(" kPa")   ? 1e3
                              : modulus.ends_with(" MPa") ? 1e6
                              : modulus.ends_with(" GPa") ? 1e9
                                                          : 1.0;
        return prefix * std::stod(modulus);
    }
    /// The overlap in impacts that --check foresees, in radii.
    static double foreseen(const std::string& check) {
        const std::string before = "overlap: up to about ";
        return 0.01 * std::stod(check.substr(check.find(before) + before.size()));
    }
    static std::string with_modulus(const std::string& modulus) {
        return " --set 'material.m.youngs_modulus=" + modulus + "' ";
    }
    double largest_overlap(const std::string& folder) const {
        std::istringstream lines(text(folder + "/history.csv"));
        double largest = 0.0;
        std::string line;
        std::getline(lines, line);
        constexpr int column = 12;  // largest_relative_overlap
        while (std::getline(lines, line)) {
            for (int k = 0; k < column; ++k) line.erase(0, line.find(',') + 1);
            largest = std::max(largest, std::stod(line));
        }
        return largest;
    }
};

TEST_F(Foresight, CheckSaysTheModulusThatKeepsTheOverlapBelowTheLimit) {
    const Outcome check = demrun("--check");
    EXPECT_EQ(check.code, 0) << check.errors;
    EXPECT_NE(check.output.find("warning: the material is too soft for the fastest impact of"),
              std::string::npos)
        << check.output;
    const std::string enough = with_modulus(modulus_in(check.output));
    EXPECT_EQ(demrun("--check" + enough).output.find("warning"), std::string::npos) << enough;
    const Outcome run = demrun(enough);
    EXPECT_EQ(run.code, 0) << run.errors;
    // Hertz without damping, and from a little higher: no stiffer than it takes.
    EXPECT_GT(largest_overlap("case"), 0.07);
}

TEST_F(Foresight, TheWeightOfABedIsForeseenAndNamedAtTheStop) {
    const std::string bed =
        "--force --set particles.s.insert=fill --set particles.s.count=400 --set "
        "'particles.s.region=cylinder 0 0 0 0 0 500 mm 25 mm' --set wall.floor.shape=cylinder "
        "--set "
        "'wall.floor.radius=25 mm' --set 'run.gravity=0 0 -9.81'";
    std::string tube = soft_drop;
    tube.erase(tube.find("file = drop.csv\n"), 16);
    tube.erase(tube.find("normal = 0 0 1\n"), 15);
    write("case.ini", tube);
    const Outcome stiff = demrun("--check " + bed + with_modulus("200 MPa"));
    EXPECT_EQ(stiff.code, 0) << stiff.errors;
    EXPECT_EQ(stiff.output.find("warning"), std::string::npos) << stiff.output;
    const Outcome soft = demrun("--check " + bed + with_modulus("50 kPa"));
    EXPECT_NE(soft.output.find("too soft for a bed of"), std::string::npos) << soft.output;
    const Outcome stop = demrun(bed + with_modulus("50 kPa"));
    EXPECT_EQ(stop.code, 1);
    const Outcome run = demrun(bed + with_modulus(modulus_in(stop.errors)));
    EXPECT_EQ(run.code, 0) << stop.errors << run.errors;
}

TEST_F(Foresight, AStopNamesASoftMaterialAndWhatIsStiffEnough) {
    const Outcome stop = demrun("");
    EXPECT_EQ(stop.code, 1);
    EXPECT_NE(stop.errors.find("particle 0 and wall 'floor' overlap by 10."), std::string::npos)
        << stop.errors;
    EXPECT_NE(stop.errors.find("the material is too soft"), std::string::npos) << stop.errors;
    EXPECT_EQ(stop.errors.find('\n'), stop.errors.size() - 1) << stop.errors;
    // As far as they have come, the run can go on.
    const Outcome on = demrun("--resume --set run.overlap_limit=0.4");
    EXPECT_EQ(on.code, 0) << on.errors;
    EXPECT_GT(largest_overlap("case"), 0.2);
    const Outcome stiff = demrun("--force" + with_modulus(modulus_in(stop.errors)));
    EXPECT_EQ(stiff.code, 0) << stiff.errors;
}

TEST_F(Foresight, AStopAdvisesNoSofterMaterialThanCheck) {
    // They stop early, at less than what was to come.
    const std::string tube =
        " --set particles.s.count=60 --set wall.floor.shape=cylinder --set 'wall.floor.radius=20 "
        "mm' --set 'particles.s.region=cylinder 0 0 0 0 0 250 mm 20 mm' --set particles.s.insert=";
    std::string poured = soft_drop;
    poured.erase(poured.find("file = drop.csv\n"), 16);
    poured.erase(poured.find("normal = 0 0 1\n"), 15);
    write("case.ini", poured);
    for (const char* insert : {"at_once", "lattice", "fill"}) {
        for (const char* modulus : {"20 kPa", "100 kPa", "400 kPa"}) {
            const std::string arguments = tube + insert + with_modulus(modulus);
            const std::string check = demrun("--check" + arguments).output;
            const Outcome stop = demrun("--force" + arguments);
            EXPECT_EQ(stop.code, 1) << arguments;
            EXPECT_GE(pascals(modulus_in(stop.errors)), pascals(modulus_in(check)))
                << insert << modulus << check << stop.errors;
        }
    }
}

TEST_F(Foresight, BodiesOnALatticeFallNoFartherThanToTheirBed) {
    std::string stacked = soft_drop;
    stacked.erase(stacked.find("file = drop.csv\n"), 16);
    stacked.erase(stacked.find("normal = 0 0 1\n"), 15);
    write("case.ini", stacked);
    const std::string tube =
        " --force --set particles.s.count=100 --set wall.floor.shape=cylinder --set "
        "'wall.floor.radius=30 mm' --set run.end_time=0.3s --set 'particles.s.region=cylinder 0 0 "
        "0 0 0 500 mm 30 mm'" +
        with_modulus("20 MPa") + "--set particles.s.insert=";
    for (const char* insert : {"lattice", "fill"}) {
        const Outcome check = demrun("--check" + tube + insert);
        EXPECT_EQ(check.output.find("warning"), std::string::npos) << check.output;
        const Outcome run = demrun(tube + insert);
        EXPECT_EQ(run.code, 0) << run.errors;
        EXPECT_LT(largest_overlap("case"), foreseen(check.output)) << insert;
    }
    // Random places are as high as the region, and so is a region above the ground.
    EXPECT_NE(demrun("--check" + tube + "at_once").output.find("warning"), std::string::npos);
    EXPECT_NE(demrun("--check" + tube +
                     "lattice --set 'particles.s.region=cylinder 0 0 400 0 0 500 mm 30 mm'")
                  .output.find("warning"),
              std::string::npos);
}

TEST_F(Foresight, AStopNamesATimeStepThatIsTooLong) {
    const Outcome stop =
        demrun("--set run.time_step_force=yes --set run.time_step=2ms" + with_modulus("100 MPa"));
    EXPECT_EQ(stop.code, 1);
    EXPECT_NE(stop.errors.find("the time step of 0.002 s is too long"), std::string::npos)
        << stop.errors;
}

TEST_F(Foresight, AStopNamesBodiesThatOverlapFromTheStart) {
    write("drop.csv", "x,y,z\n0,0,0.1\n0,0,0.107\n");
    const Outcome stop = demrun("--set particles.s.overlaps=allow");
    EXPECT_EQ(stop.code, 1);
    EXPECT_NE(stop.errors.find("they do from the start"), std::string::npos) << stop.errors;
}

TEST_F(Foresight, AnEstimateCountsMeasuresAndWhatRemains) {
    const std::string all =
        " --check --set 'run.time_step=1us' --set run.end_time=10 " + with_modulus("50 MPa");
    EXPECT_NE(demrun(all + "--set measure.h.kind=fill_height --set measure.h.every=1us")
                  .output.find(" of it for measures"),
              std::string::npos);
    EXPECT_EQ(demrun(all).output.find("measures"), std::string::npos);
    EXPECT_NE(demrun(all).output.find("steps: 10000000 to 10 s\n"), std::string::npos);
    ASSERT_EQ(
        demrun("--set run.time_step=1us --set run.end_time=1ms" + with_modulus("50 MPa")).code, 0);
    const Outcome rest = demrun(all + " --resume");
    EXPECT_NE(rest.output.find("steps: 9999000 more of 10000000, from 0.001 s to 10 s\n"),
              std::string::npos)
        << rest.output << rest.errors;
}

TEST_F(Foresight, WhereNoBodyCanMoveNoTimeStepIsTooLong) {
    const Outcome check = demrun("--check --set particles.s.fixed=yes --set run.time_step=1ms");
    EXPECT_EQ(check.code, 0) << check.errors;
    EXPECT_NE(check.output.find("time step: 0.001 s, given; no body can move"), std::string::npos)
        << check.output;
    EXPECT_EQ(check.output.find("inf"), std::string::npos) << check.output;
}

}  // namespace
}  // namespace dem
