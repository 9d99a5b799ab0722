// SPDX-License-Identifier: BSD-3-Clause
#include "common/number.hpp"

#include <gtest/gtest.h>

namespace dem {
namespace {

TEST(Number, ANumberHasOneSignAtMost) {
    EXPECT_EQ(finite_number("-9.81"), -9.81);
    EXPECT_EQ(finite_number("+9.81"), 9.81);
    EXPECT_EQ(finite_number(".5"), 0.5);
    EXPECT_EQ(finite_number("5."), 5.0);
    EXPECT_EQ(finite_number("1e-3"), 1e-3);
    for (const char* text :
         {"+-9.81", "-+1", "--1", "++1", "+",   "-",    "",    " 1",   "1 ",    "1,5",
          "0x10",   "1e",  "e5",  ".",   "nan", "+nan", "inf", "-inf", "1e999", "1e-999"}) {
        EXPECT_FALSE(finite_number(text)) << text;
    }
}

TEST(Number, WhatFollowsANumberIsLeft) {
    const NumberAhead number = number_ahead("+6.5mm 7");
    EXPECT_TRUE(number.is_finite());
    EXPECT_EQ(number.value, 6.5);
    EXPECT_EQ(number.rest, "mm 7");
    EXPECT_EQ(number_ahead("mm").error, std::errc::invalid_argument);
    EXPECT_EQ(number_ahead("1e999 mm").error, std::errc::result_out_of_range);
    EXPECT_FALSE(number_ahead("inf").is_finite());
}

}  // namespace
}  // namespace dem
