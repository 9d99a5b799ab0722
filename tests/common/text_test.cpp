// SPDX-License-Identifier: BSD-3-Clause
#include "common/text.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace dem {
namespace {

TEST(Text, BlanksAndLineEndsAreTrimmed) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \r\n"), "");
}

TEST(Text, WhatIsQuotedStandsOnOneLine) {
    EXPECT_EQ(in_quotes("a\nb\rc\td"), "'a\\nb\\rc\\td'");
    EXPECT_EQ(in_quotes(std::string("\0\x1b[31m\x7f", 7)), "'\\x00\\x1b[31m\\x7f'");
    EXPECT_EQ(in_quotes("\u00b5m \u2300 \U0001F600"), "'\u00b5m \u2300 \U0001F600'");
    // No UTF-8: a lone byte, one cut short, one too long, a control character in two bytes.
    EXPECT_EQ(in_quotes("\xb5m"), "'\\xb5m'");
    EXPECT_EQ(in_quotes("\xe2\x8c"), "'\\xe2\\x8c'");
    EXPECT_EQ(in_quotes("\xc0\x80"), "'\\xc0\\x80'");
    EXPECT_EQ(in_quotes("\xc2\x9b"), "'\\xc2\\x9b'");
}

TEST(Text, ALongWordIsQuotedByItsEnds) {
    EXPECT_EQ(in_quotes(std::string(60, 'a')), "'" + std::string(60, 'a') + "'");
    const std::string word = std::string(1'000'000, 'a') + "/case.ini";
    EXPECT_EQ(in_quotes(word),
              "'" + std::string(40, 'a') + "..." + std::string(8, 'a') + "/case.ini'");
    std::string greek;
    for (int k = 0; k < 100; ++k) greek += "\u03bc";
    EXPECT_EQ(in_quotes(greek), "'" + greek.substr(0, 40) + "..." + greek.substr(0, 16) + "'");
}

TEST(Text, TheNearestWordIsSuggestedAndNoneWhereNoneIsNear) {
    const std::vector<std::string> words = {"restitution", "friction", "model", "youngs_modulus",
                                            "shape"};
    EXPECT_EQ(nearest_word("restitutoin", words), "restitution");
    EXPECT_EQ(nearest_word("frction", words), "friction");
    EXPECT_EQ(nearest_word("Model", words), "model");
    EXPECT_EQ(nearest_word("young_modulus", words), "youngs_modulus");
    EXPECT_EQ(nearest_word("shaep", words), "shape");
    EXPECT_EQ(nearest_word("scale", words), "");
    EXPECT_EQ(nearest_word("gravity", words), "");
    EXPECT_EQ(nearest_word("", words), "");
    EXPECT_EQ(nearest_word("x", {}), "");
}

TEST(Text, AListOfWhatThereIsIsCutWhenLong) {
    const std::vector<std::string> few = {"ab", "cd"};
    EXPECT_EQ(suggestion("uvwxyz", few), "");
    EXPECT_EQ(suggestion_or_all("abb", few), ", did you mean 'ab'?");
    EXPECT_EQ(suggestion_or_all("uvwxyz", few), ", expected one of: ab, cd");
    EXPECT_EQ(suggestion_or_all("a", {}), ", there is none");
    const std::vector<std::string> many(1000, "shape");
    const std::string text = suggestion_or_all("uvwxyz", many);
    EXPECT_LT(text.size(), 600U);
    EXPECT_TRUE(text.ends_with(", ... (1000 in all)"));
}

}  // namespace
}  // namespace dem
