// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "formats/template_reader.hpp"
#include "shapegen/certificate/template_summary.hpp"
#include "tests/cli/program.hpp"

#include <memory>
#include <span>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// Templates outlive the version that cooked them: files made by version 0.1.0 are read today and in
// all later versions of the same format, to the values they had.
//
//     shapegen data/profiles/tablet.profile -o tests/golden/tablet.tpl --nodes 200
//              --base-cells 25 --interface-cells 50 --corner-cells 100
//     shapegen data/profiles/peanut.profile ...the same
//     shapegen inspect tests/golden/tablet.tpl --json > tests/golden/tablet.json

namespace dem::shapegen {
namespace {

const std::filesystem::path folder = std::filesystem::path(DEM_SOURCE_DIR) / "tests/golden";

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, IsReadToTheValuesItHad) {
    const std::string name = GetParam();
    const std::string text = template_json(read_template(folder / (name + ".tpl")));
    const nlohmann::json found = nlohmann::json::parse(text).flatten();
    const nlohmann::json golden =
        nlohmann::json::parse(content(folder / (name + ".json"))).flatten();
    EXPECT_GT(golden.size(), 20U);
    for (const auto& [path, value] : golden.items()) {
        ASSERT_TRUE(found.contains(path)) << path;
        EXPECT_EQ(found[path], value) << path;
    }
}

/// Their checksum is another than that of the files of today.
TEST_P(Golden, IsFoundToBeDamagedByAnyChangedByte) {
    const std::string good = content(folder / (std::string(GetParam()) + ".tpl"));
    ASSERT_EQ(good[8], 1) << "the format version";
    for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 1000) {
        const auto bytes = std::make_shared<std::string>(good);
        (*bytes)[at] = static_cast<char>((*bytes)[at] ^ 4);
        EXPECT_THROW(read_template(bytes, std::as_bytes(std::span(*bytes)), "x"), Error) << at;
    }
}

INSTANTIATE_TEST_SUITE_P(Templates, Golden, testing::Values("tablet", "peanut"));

}  // namespace
}  // namespace dem::shapegen
