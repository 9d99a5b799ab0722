// SPDX-License-Identifier: BSD-3-Clause
#include "common/units.hpp"

#include "common/error.hpp"
#include "common/math/types.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
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

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool equal_but_for_case(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

/// Twice the Damerau-Levenshtein distance (insert, delete, replace, swap of neighbours), a change
/// of case costing half.
std::size_t doubled_edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> before(width);
    std::vector<std::size_t> above(width);
    std::vector<std::size_t> row(width);
    for (std::size_t j = 0; j < width; ++j) above[j] = 2 * j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = 2 * i;
        for (std::size_t j = 1; j < width; ++j) {
            const char x = a[i - 1];
            const char y = b[j - 1];
            const std::size_t replace = x == y ? 0 : equal_but_for_case(x, y) ? 1 : 2;
            row[j] = std::min({above[j] + 2, row[j - 1] + 2, above[j - 1] + replace});
            if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y) {
                row[j] = std::min(row[j], before[j - 2] + 2);
            }
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above.back();
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
    const std::string quoted = "'" + std::string(unit) + "'";
    if (other != nullptr) {
        throw Error("unit " + quoted + " is of " + with_article(dimension_name(other->dimension)) +
                    ", expected " + with_article(expectation(dimension)));
    }
    const std::string guess = nearest_word(unit, units_of(dimension));
    throw Error("unknown unit " + quoted +
                (guess.empty() ? "" : ", did you mean '" + guess + "'?") + ", expected " +
                with_article(expectation(dimension)));
}

double parse_quantity(std::string_view text, Dimension dimension) {
    const std::string_view whole = trimmed(text);
    std::string_view rest = whole;
    // from_chars knows no plus sign, and would take "+-1" if it were simply skipped.
    if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const std::string found = "'" + std::string(whole) + "'";
    if (error == std::errc::result_out_of_range) {
        throw Error(found + " is outside the range of double precision");
    }
    if (error != std::errc()) {
        throw Error((whole.empty() ? std::string("nothing") : found) + " found, expected " +
                    with_article(expectation(dimension)));
    }
    const std::string_view unit = trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())));
    if (!std::isfinite(value)) throw Error(found + " found, expected a finite number");
    if (!unit.empty() &&
        (std::isdigit(static_cast<unsigned char>(unit[0])) != 0 ||
         unit.find_first_of(" \t,;") != std::string_view::npos) &&
        unit != "1/s") {
        throw Error(found + " found, expected one " + expectation(dimension));
    }
    double factor = 1.0;
    try {
        factor = unit_factor(unit, dimension);
    } catch (const Error& e) {
        throw Error(found, e.what());
    }
    const double si = value * factor;
    if (!std::isfinite(si)) throw Error(found + " is outside the range of double precision");
    return si;
}

LengthUnit length_unit(double size) {
    if (size < 1e-4) return {"um", 1e-6};
    if (size < 0.5) return {"mm", 1e-3};
    return {"m", 1.0};
}

std::string nearest_word(std::string_view word, std::span<const std::string> candidates) {
    // A third of the letters may be wrong: "restitutoin" is helped, "foo" is not told "mu".
    const std::size_t longest = 2 * std::max<std::size_t>(1, (word.size() + 1) / 3);
    std::size_t best = longest + 1;
    std::string nearest;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = doubled_edit_distance(word, candidate);
        // Everything replaced is no resemblance ("x" for "m").
        if (distance >= 2 * std::min(word.size(), candidate.size()) && distance > 1) continue;
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace dem
