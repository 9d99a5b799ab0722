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
    velocity,          // m/s mm/s cm/s
    acceleration,      // m/s^2 mm/s^2
    angular_velocity,  // rad/s rpm deg/s 1/s Hz (turns per second: 1 Hz = 2 pi rad/s)
    angle,             // rad deg
    density,           // kg/m^3 g/cm^3 kg/m3 g/cc
    pressure,          // Pa kPa MPa GPa
    stiffness,         // N/m kN/m N/mm
    frequency          // Hz 1/s
};

/// SI factor of `unit` ("" is SI). Throws Error that says whether the unit belongs to another
/// dimension or which one was probably meant, and names the units of `dimension`.
double unit_factor(std::string_view unit, Dimension dimension);

/// One value with an optional unit: "6.5 mm", "25rpm", "30 deg", "5e-7". Rejects NaN, infinity and
/// trailing text. Returns SI. Throws Error that says what was found and what was expected.
double parse_quantity(std::string_view text, Dimension dimension);

/// The unit that lengths are written in for a reader.
struct LengthUnit {
    std::string name;
    double meters;
};

/// um, mm or m, by the size of the body that is described [m].
LengthUnit length_unit(double size);

}  // namespace dem
