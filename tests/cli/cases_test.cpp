// SPDX-License-Identifier: BSD-3-Clause
// The cases of data/cases, as a user would cook and check them.
#include "tests/cli/program.hpp"

#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const std::string& name) {
    fs::path folder = fs::temp_directory_path() / (name + "_" + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

/// The lines of a case's head that cook its templates, for a folder that holds the case itself.
std::vector<std::string> cooking_commands(const std::string& text) {
    std::vector<std::string> commands;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string start = "#   shapegen ";
        if (!line.starts_with(start)) continue;
        std::istringstream words(line.substr(start.size()));
        std::string command = program("shapegen");
        for (std::string word; words >> word;) {
            if (word.starts_with("data/cases/"))
                word = word.substr(11);
            else if (word.starts_with("data/"))
                word = "'" DEM_SOURCE_DIR "/" + word + "'";
            command += ' ' + word;
        }
        commands.push_back(command + " -q");
    }
    return commands;
}

class Case : public testing::TestWithParam<std::string> {};

TEST_P(Case, IsAcceptedWithTheShapesThatItsHeadCooks) {
    const fs::path folder = fresh_folder("case_" + GetParam());
    const fs::path cases = DEM_SOURCE_DIR "/data/cases";
    const std::string text = content(cases / (GetParam() + ".ini"));
    for (const auto& entry : fs::directory_iterator(cases)) {
        fs::copy_file(entry.path(), folder / entry.path().filename());
    }
    for (const std::string& command : cooking_commands(text)) {
        const Outcome cooked = run_command(command, folder);
        ASSERT_EQ(cooked.code, 0) << command << '\n' << cooked.errors;
    }
    const Outcome outcome =
        run_command(program("demrun") + " " + GetParam() + ".ini --check", folder);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output.find("AFTER end_time"), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find("warning"), std::string::npos) << outcome.output;
    fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Data, Case,
                         testing::Values("all_kinds", "chung_ooi_1", "chung_ooi_2", "chung_ooi_3",
                                         "baffles", "clumps", "demo", "hopper", "hopper_tablets",
                                         "mixture", "packing_candies", "packing_clumps",
                                         "packing_tablets", "rotating_drum", "sand", "spheroids",
                                         "tablet_wall", "ten_bunnies"),
                         [](const auto& tested) { return tested.param; });

TEST(CasesFolder, EveryCaseIsTested) {
    std::size_t cases = 0;
    for (const auto& entry : fs::directory_iterator(DEM_SOURCE_DIR "/data/cases")) {
        if (entry.path().extension() == ".ini") ++cases;
    }
    EXPECT_EQ(cases, 18U) << "add new cases to the list above";
}

}  // namespace
}  // namespace dem
