// SPDX-License-Identifier: BSD-3-Clause
#include "common/units.hpp"

#include "common/error.hpp"
#include "common/math/types.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace dem {
namespace {

std::string message_of(std::string_view text, Dimension dimension) {
    try {
        parse_quantity(text, dimension);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Units, EveryUnitIsConvertedToSi) {
    const struct {
        const char* text;
        Dimension dimension;
        double si;
    } cases[] = {
        {"5e-7", Dimension::time, 5e-7},
        {" 6.5 mm ", Dimension::length, 6.5e-3},
        {"12um", Dimension::length, 12e-6},
        {"12 \u00b5m", Dimension::length, 12e-6},
        {"+2 in", Dimension::length, 0.0508},
        {"-3 cm", Dimension::length, -0.03},
        {"80 ms", Dimension::time, 0.08},
        {"2 min", Dimension::time, 120.0},
        {"1.5 h", Dimension::time, 5400.0},
        {"250 mm/s", Dimension::velocity, 0.25},
        {"9810 mm/s^2", Dimension::acceleration, 9.81},
        {"30 rpm", Dimension::angular_velocity, pi},
        {"0.5 Hz", Dimension::angular_velocity, pi},
        {"7 1/s", Dimension::angular_velocity, 7.0},
        {"0.5 Hz", Dimension::frequency, 0.5},
        {"180 deg", Dimension::angle, pi},
        {"2.5 g/cm^3", Dimension::density, 2500.0},
        {"50 MPa", Dimension::pressure, 5e7},
        {"10 N/mm", Dimension::stiffness, 1e4},
        {"0.38", Dimension::none, 0.38},
    };
    for (const auto& c : cases) {
        EXPECT_DOUBLE_EQ(parse_quantity(c.text, c.dimension), c.si) << c.text;
    }
}

TEST(Units, TextThatIsNotOneFiniteNumberIsRefused) {
    for (const char* text : {"", "  ", "mm", "nan", "inf", "-inf mm", "1e999", "1e308 kPa", "1 2",
                             "1,5 mm", "0x10", "1..2", "--1", "+-1", "++1", "71/s", "5 mm mm"}) {
        EXPECT_THROW(parse_quantity(text, Dimension::pressure), Error) << text;
        EXPECT_THROW(parse_quantity(text, Dimension::none), Error) << text;
        EXPECT_THROW(parse_quantity(text, Dimension::length), Error) << text;
    }
}

TEST(Units, MessagesNameWhatWasFoundWhatWasMeantAndWhatIsKnown) {
    EXPECT_EQ(message_of("6.5 mn", Dimension::length),
              "found '6.5 mn': unknown unit 'mn', did you mean 'mm'?, expected a length (m, mm, "
              "um, cm or in)");
    EXPECT_EQ(message_of("5 rpn", Dimension::angular_velocity).find("did you mean 'rpm'") !=
                  std::string::npos,
              true);
    EXPECT_EQ(
        message_of("5 mpa", Dimension::pressure).find("did you mean 'MPa'") != std::string::npos,
        true);
    EXPECT_EQ(message_of("5 s", Dimension::length),
              "found '5 s': unit 's' is of a time, expected a length (m, mm, um, cm or in)");
    EXPECT_EQ(message_of("5 mm", Dimension::none),
              "found '5 mm': unit 'mm' is of a length, expected a plain number");
}

}  // namespace
}  // namespace dem
