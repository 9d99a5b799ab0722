// SPDX-License-Identifier: BSD-3-Clause
// Equal commands write equal files, byte for byte: a second time, and on a processor that can do
// less (what the C library is told by GLIBC_TUNABLES, and DEM_LANES: one contact at a time).
#include "tests/cli/program.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

const char* const older_processor =
    "DEM_LANES=1 "
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX512F,-AVX2_Usable,-FMA_Usable ";

const char* const materials =
    "[material.m]\ndensity = 1200\nyoungs_modulus = 50 MPa\npoissons_ratio = 0.3\n";
const char* const hertz = "[contact]\nrestitution = 0.5\nfriction = 0.3\n";
const char* const linear =
    "[contact]\nmodel = linear\nnormal_stiffness = 2e4 N/m\nrestitution = 0.5\n"
    "tangential_restitution = 0.4\nfriction = 0.3\n";

/// Beads on a grid in a box that shakes.
const std::string shaken_beads =
    std::string("[run]\nend_time = 25 ms\n") + materials + hertz +
    "[particles.beads]\nradius = 4 mm\nmaterial = m\ncount = 60\ninsert = lattice\n"
    "region = box -38 -38 2  38 38 32 mm\norientation = 1 0 0 0\n"
    "[wall.box]\nshape = box\nlower = -40 -40 0 mm\nupper = 40 40 200 mm\nopen = top\n"
    "material = m\nmotion = oscillate\ndirection = 1 0 0\namplitude = 2 mm\nfrequency = 10 Hz\n"
    "[measure.height]\nkind = fill_height\nevery = 10 ms\n"
    "[measure.solid]\nkind = solid_fraction\nevery = 25 ms\n"
    "[output]\nhistory_every = 1 ms\n";

/// Every kind of shape, turned at random, in a drum that rotates.
std::string mixed_drum(const char* law) {
    std::string text = std::string("[run]\nend_time = 12 ms\nseed = 3\n") + materials + law;
    double start = 0.0;
    for (const char* name : {"tablet", "clump", "sand", "rod"}) {
        char group[400];
        std::snprintf(group, sizeof group,
                      "[particles.%s]\ntemplate = %s.tpl\nmaterial = m\ncount = 6\n"
                      "region = cylinder 0 %g 0 mm  0 %g 0 mm  25 mm\n"
                      "velocity = 0.1 0 -0.4\n",
                      name, name, start, start + 20.0);
        text += group;
        start += 20.0;
    }
    return text +
           "[particles.beads]\nradius = 3 mm\nmaterial = m\ncount = 10\n"
           "region = cylinder 0 80 0 mm  0 95 0 mm  25 mm\n"
           "[wall.drum]\nshape = cylinder\npoint = 0 -2 0 mm\naxis = 0 1 0\nlength = 100 mm\n"
           "ends = both\nradius = 28 mm\nmaterial = m\nmotion = rotate\nrate = 60 rpm\n"
           "[output]\nframes_every = 3 ms\nhistory_every = 1 ms\n"
           "[measure.height]\nkind = fill_height\nevery = 20 ms\n";
}

/// Every file below a folder by its name, without what the clock of the wall gave.
std::map<std::string, std::string> contents(const fs::path& folder) {
    static const std::regex clock_times(
        "(\"(wall|measure|output)_time\"|\"microseconds_per_particle_step\"|\"threads_used\"|"
        "\"lanes\"): "
        "[-+.e0-9]+");
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::string text = content(entry.path());
        if (entry.path().filename() == "summary.json") {
            text = std::regex_replace(text, clock_times, "$1");
        }
        result[fs::relative(entry.path(), folder).string()] = text;
    }
    return result;
}

class EqualFiles : public TemporaryFolder {
  protected:
    /// Runs the commands in an empty folder that holds `files`; what is in it afterwards.
    std::map<std::string, std::string> results(const std::string& name,
                                               const std::vector<std::string>& commands,
                                               const std::string& before = "") const {
        const fs::path folder = folder_ / name;
        fs::create_directories(folder);
        for (const auto& [file, text] : files_) std::ofstream(folder / file) << text;
        for (const std::string& command : commands) {
            const Outcome outcome = run_command(before + command, folder);
            EXPECT_EQ(outcome.code, 0) << command << outcome.errors;
        }
        return contents(folder);
    }

    std::map<std::string, std::string> files_;
};

void expect_equal(const std::map<std::string, std::string>& first,
                  const std::map<std::string, std::string>& second,
                  const std::set<std::string>& among) {
    for (const std::string& name : among) EXPECT_TRUE(first.contains(name)) << name;
    EXPECT_EQ(first.size(), second.size());
    for (const auto& [name, text] : first) {
        const auto other = second.find(name);
        ASSERT_NE(other, second.end()) << name;
        const auto [a, b] =
            std::mismatch(text.begin(), text.end(), other->second.begin(), other->second.end());
        EXPECT_TRUE(text == other->second)
            << name << " differs from byte " << a - text.begin() << " of " << text.size();
    }
}

TEST_F(EqualFiles, ASecondRunWritesTheSameBytes) {
    files_ = {{"case.ini", shaken_beads}};
    const std::vector<std::string> commands = {program("demrun") +
                                               " case.ini --quiet --set output.surfaces=yes "
                                               "--set output.contacts=yes"};
    const auto first = results("first", commands);
    // HDF5 counts in seconds.
    ASSERT_EQ(run_command("sleep 1.1", folder_).code, 0);
    const auto second = results("second", commands);
    expect_equal(first, second,
                 {"case/frames.h5", "case/frames.xdmf", "case/surfaces.h5", "case/contacts.h5",
                  "case/checkpoint.h5", "case/history.csv", "case/final.csv", "case/final.png",
                  "case/summary.json"});
}

TEST_F(EqualFiles, AnotherProcessorWritesTheSameBytes) {
    const std::string libm_bits = program("libm_bits");
    if (run_command(libm_bits, folder_).output ==
        run_command(older_processor + libm_bits, folder_).output) {
        GTEST_SKIP() << "the C library has one set of functions for this processor only";
    }
    files_ = {{"beads.ini", shaken_beads}, {"hertz.ini", mixed_drum(hertz)}};
    files_["linear.ini"] = mixed_drum(linear);
    std::vector<std::string> commands;
    std::set<std::string> expected;
#ifdef DEM_WITH_SHAPEGEN
    const std::string shapegen = program("shapegen") + " ";
    const std::string data = "'" DEM_SOURCE_DIR "/data/";
    commands = {shapegen + data + "profiles/tablet.profile' -q -o tablet.tpl",
                shapegen + data +
                    "profiles/peanut.profile' --clump-spheres 6 --resolution 30 -q -o clump.tpl",
                shapegen + data + "convex/cylinder.convex' -q -o rod.tpl",
                shapegen + "generate sand --count 3 --seed 2 -q -o sand.tpl"};
    expected = {"tablet.tpl", "clump.tpl", "rod.tpl", "sand.tpl", "hertz/final.csv"};
    for (const char* name : {"hertz", "linear"}) {
        commands.push_back(program("demrun") + " " + name + ".ini --quiet");
    }
#endif
    commands.push_back(program("demrun") + " beads.ini --quiet");
    const auto here = results("here", commands);
    const auto there = results("there", commands, older_processor);
    expect_equal(here, there, expected);
}

}  // namespace
}  // namespace dem
