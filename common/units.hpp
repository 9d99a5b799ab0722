// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// Units at the edge of the programs; inside everything is SI.
namespace dem {

enum class Dimension {
    none,
    length,            // m mm um cm in
    time,              // s ms us min h
    velocity,          // m/s mm/s
    acceleration,      // m/s^2
    angular_velocity,  // rad/s rpm deg/s 1/s Hz
    angle,             // rad deg
    density,           // kg/m^3 g/cm^3 kg/m3 g/cc
    pressure,          // Pa kPa MPa GPa
    stiffness,         // N/m kN/m
    frequency          // Hz 1/s
};

/// SI factor of `unit` ("" is SI), or an exception.
/// Throws Error("unknown unit 'mn' ..., did you mean 'mm'?") naming the units of that dimension.
double unit_factor(std::string_view unit, Dimension dimension);

/// One value with an optional unit: "6.5 mm", "25rpm", "30 deg", "5e-7". Rejects NaN, infinity and
/// trailing text. Returns SI. Throws Error that says what was found and what was expected.
double parse_quantity(std::string_view text, Dimension dimension);

/// The candidate nearest to `word` by edit distance, or "" when none is near enough to suggest.
std::string nearest_word(std::string_view word, const std::string* candidates, std::size_t count);

}  // namespace dem
