// SPDX-License-Identifier: BSD-3-Clause
// Equal commands write equal files, byte for byte.
#include "tests/cli/program.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

const char* const materials =
    "[material.m]\ndensity = 1200\nyoungs_modulus = 50 MPa\npoissons_ratio = 0.3\n";
const char* const hertz = "[contact]\nrestitution = 0.5\nfriction = 0.3\n";
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

/// Every file below a folder by its name, without the times that the clock of the wall gave.
std::map<std::string, std::string> contents(const fs::path& folder) {
    static const std::regex clock_times(
        "(\"wall_time\"|\"microseconds_per_particle_step\"): [-+.e0-9]+");
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
                                               " case.ini --quiet --set output.surfaces=yes"};
    const auto first = results("first", commands);
    // HDF5 counts in seconds.
    ASSERT_EQ(run_command("sleep 1.1", folder_).code, 0);
    const auto second = results("second", commands);
    expect_equal(first, second,
                 {"case/frames.h5", "case/frames.xdmf", "case/surfaces.h5", "case/checkpoint.h5",
                  "case/history.csv", "case/final.csv", "case/final.png", "case/summary.json"});
}

}  // namespace
}  // namespace dem
