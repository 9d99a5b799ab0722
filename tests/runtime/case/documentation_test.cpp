// SPDX-License-Identifier: BSD-3-Clause
// What the documentation says about case files is what the program does.
#include "runtime/case/key.hpp"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

std::string text_of(const std::string& file) {
    std::ifstream stream(std::string(DEM_SOURCE_DIR) + "/docs/" + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(CaseDocumentation, TheTablesAreThoseOfTheProgram) {
    EXPECT_NE(text_of("case-file.md").find(describe_keys()), std::string::npos)
        << "put the output of `demrun --keys` under \"Every key\" of docs/case-file.md";
}

}  // namespace
}  // namespace dem::runtime
