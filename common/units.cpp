// SPDX-License-Identifier: BSD-3-Clause
#include "common/units.hpp"

#include "common/error.hpp"
#include "common/math/types.hpp"
#include "common/number.hpp"
#include "common/text.hpp"

#include <cctype>
#include <cmath>
#include <vector>

namespace dem {

namespace {

struct Unit {
    std::string_view name;
    double factor;
    Dimension dimension;
    bool is_listed = true;  ///< false: understood, but not named in messages
};

constexpr double degree = pi / 180.0;

constexpr Unit units[] = {
    {"m", 1.0, Dimension::length},
    {"mm", 1e-3, Dimension::length},
    {"um", 1e-6, Dimension::length},
    {"\u00b5m", 1e-6, Dimension::length, false},
    {"\u03bcm", 1e-6, Dimension::length, false},
    {"cm", 1e-2, Dimension::length},
    {"in", 0.0254, Dimension::length},
    {"s", 1.0, Dimension::time},
    {"ms", 1e-3, Dimension::time},
    {"us", 1e-6, Dimension::time},
    {"\u00b5s", 1e-6, Dimension::time, false},
    {"\u03bcs", 1e-6, Dimension::time, false},
    {"min", 60.0, Dimension::time},
    {"h", 3600.0, Dimension::time},
    {"m/s", 1.0, Dimension::velocity},
    {"mm/s", 1e-3, Dimension::velocity},
    {"cm/s", 1e-2, Dimension::velocity},
    {"m/s^2", 1.0, Dimension::acceleration},
    {"mm/s^2", 1e-3, Dimension::acceleration},
    {"m/s2", 1.0, Dimension::acceleration, false},
    {"rad/s", 1.0, Dimension::angular_velocity},
    {"rpm", 2.0 * pi / 60.0, Dimension::angular_velocity},
    {"deg/s", degree, Dimension::angular_velocity},
    {"1/s", 1.0, Dimension::angular_velocity},
    {"Hz", 2.0 * pi, Dimension::angular_velocity},
    {"rad", 1.0, Dimension::angle},
    {"deg", degree, Dimension::angle},
    {"kg/m^3", 1.0, Dimension::density},
    {"g/cm^3", 1e3, Dimension::density},
    {"kg/m3", 1.0, Dimension::density, false},
    {"g/cm3", 1e3, Dimension::density, false},
    {"g/cc", 1e3, Dimension::density},
    {"Pa", 1.0, Dimension::pressure},
    {"kPa", 1e3, Dimension::pressure},
    {"MPa", 1e6, Dimension::pressure},
    {"GPa", 1e9, Dimension::pressure},
    {"N/m", 1.0, Dimension::stiffness},
    {"kN/m", 1e3, Dimension::stiffness},
    {"N/mm", 1e3, Dimension::stiffness},
    {"Hz", 1.0, Dimension::frequency},
    {"1/s", 1.0, Dimension::frequency},
};

std::string dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return "plain number";
        case Dimension::length:
            return "length";
        case Dimension::time:
            return "time";
        case Dimension::velocity:
            return "velocity";
        case Dimension::acceleration:
            return "acceleration";
        case Dimension::angular_velocity:
            return "angular velocity";
        case Dimension::angle:
            return "angle";
        case Dimension::density:
            return "density";
        case Dimension::pressure:
            return "pressure";
        case Dimension::stiffness:
            return "stiffness";
        case Dimension::frequency:
            return "frequency";
    }
    return "quantity";
}

std::vector<std::string> units_of(Dimension dimension) {
    std::vector<std::string> names;
    for (const Unit& u : units) {
        if (u.dimension == dimension && u.is_listed) names.emplace_back(u.name);
    }
    return names;
}

std::string with_article(const std::string& noun) {
    return (noun.starts_with('a') ? "an " : "a ") + noun;
}

/// "length (m, mm, um, cm or in)"
std::string expectation(Dimension dimension) {
    const std::vector<std::string> names = units_of(dimension);
    std::string text = dimension_name(dimension);
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += i == 0 ? " (" : i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return names.empty() ? text : text + ")";
}

}  // namespace

double unit_factor(std::string_view unit, Dimension dimension) {
    if (unit.empty()) return 1.0;
    const Unit* other = nullptr;
    for (const Unit& u : units) {
        if (u.name != unit) continue;
        if (u.dimension == dimension) return u.factor;
        if (other == nullptr) other = &u;
    }
    if (other != nullptr) {
        throw Error("unit " + in_quotes(unit) + " is of " +
                    with_article(dimension_name(other->dimension)) + ", expected " +
                    with_article(expectation(dimension)));
    }
    throw Error("unknown unit " + in_quotes(unit) + suggestion(unit, units_of(dimension)) +
                ", expected " + with_article(expectation(dimension)));
}

double parse_quantity(std::string_view text, Dimension dimension) {
    const std::string_view whole = trimmed(text);
    const NumberAhead number = number_ahead(whole);
    const std::string found =
        "found " + (whole.empty() ? std::string("nothing") : in_quotes(whole));
    const std::string beyond = ", expected a number within the range of double precision";
    if (number.error == std::errc::result_out_of_range) throw Error(found + beyond);
    if (number.error != std::errc())
        throw Error(found + ", expected " + with_article(expectation(dimension)));
    const std::string_view unit = trimmed(number.rest);
    if (!number.is_finite()) throw Error(found + ", expected a finite number");
    if (!unit.empty() &&
        (std::isdigit(static_cast<unsigned char>(unit[0])) != 0 ||
         unit.find_first_of(" \t,;") != std::string_view::npos) &&
        unit != "1/s") {
        throw Error(found + ", expected one " + expectation(dimension));
    }
    double factor = 1.0;
    try {
        factor = unit_factor(unit, dimension);
    } catch (const Error& e) {
        throw Error(found, e.what());
    }
    const double si = number.value * factor;
    if (!std::isfinite(si)) throw Error(found + beyond);
    return si;
}

LengthUnit length_unit(double size) {
    if (size < 1e-4) return {"um", 1e-6};
    if (size < 0.5) return {"mm", 1e-3};
    return {"m", 1.0};
}

}  // namespace dem
