// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/template_reader.hpp"
#include "tests/cli/program.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace dem {

/// Runs shapegen in an empty folder of its own.
class ShapegenFixture : public TemporaryFolder {
  protected:
    /// `before`: shell words in front of the program.
    Outcome run(const std::string& arguments, const std::string& before = "") const {
        return run_command(before + program("shapegen") + " " + arguments, folder_);
    }
    /// Cooks quietly, which must work.
    TemplateFile cook_file(const std::string& arguments, const std::string& before = "") const {
        const Outcome outcome = run(arguments + " -q -o out.tpl", before);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_EQ(outcome.output + outcome.errors, "");
        return read_template(folder_ / "out.tpl");
    }
    ParticleTemplate cook(const std::string& arguments, const std::string& before = "") const {
        return cook_file(arguments, before).shapes.at(0);
    }
    /// One line that starts as promised and holds the words; no template left.
    void expect_failure(const std::string& arguments, int code, const std::string& words) const {
        const Outcome outcome = run(arguments + " -q -o out.tpl");
        EXPECT_EQ(outcome.code, code) << arguments;
        EXPECT_EQ(outcome.errors.rfind("shapegen: error: ", 0), 0U) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
            << outcome.errors;
        EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.tpl"));
    }
};

}  // namespace dem
