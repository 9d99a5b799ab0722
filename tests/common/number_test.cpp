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

TEST(Number, AWholeNumberMayHaveAPointOrAnExponent) {
    for (const char* text : {"1000", "+1000", "1e3", "1E+3", "1.e3", "1.0e3", "0.1e4", "10000e-1",
                             "1000.", "1000.00", "001000", "1000000000000000000000e-18"}) {
        EXPECT_EQ(whole_number(text), 1000U) << text;
    }
    for (const char* text : {"0", "0.0", "0e9", ".0", "0e-999999999999"}) {
        EXPECT_EQ(whole_number(text), 0U) << text;
    }
    EXPECT_EQ(whole_number("18446744073709551615"), 18446744073709551615U);
    EXPECT_EQ(whole_number("1844674407370955161.5e1"), 18446744073709551615U) << "no double is it";
    EXPECT_EQ(whole_number("9007199254740993.0"), 9007199254740993U) << "nor this";
}

TEST(Number, NothingButAWholeNumberIsOne) {
    for (const char* text : {"",     "-1",   "1.5",   "1e-1",  "15e-1", "0.99999999999999999999",
                             ".",    "e3",   "1e",    "1e3.0", "1e+-3", "18446744073709551616",
                             "2e19", "1e30", "1e999", "1e-9",  "0x10",  "1 000",
                             "1e3 ", "nan",  "inf",   "++1",   "1.0.0", "1e99999999999999999999"}) {
        EXPECT_FALSE(whole_number(text)) << text;
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
