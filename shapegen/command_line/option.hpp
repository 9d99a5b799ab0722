// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/units.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What a command line of shapegen may say. Every option is declared once, in option_table.cpp:
/// reading, range checks, suggestions, `--help` and `--man` all come from there.
namespace dem::shapegen {

enum class OptionType : std::uint8_t {
    flag,      ///< given or not
    text,      ///< a name, a path, or what its reader takes apart
    count,     ///< a whole number
    number,    ///< without a unit
    fraction,  ///< 0.95 or 95%
    percents,  ///< 95%
    quantity,  ///< a number with its unit
    choice     ///< one of Option::words
};

struct OptionRange {
    double low = 0.0;
    double high = std::numeric_limits<double>::infinity();
    bool low_allowed = true;
    bool high_allowed = true;

    bool contains(double x) const {
        return (low_allowed ? x >= low : x > low) && (high_allowed ? x <= high : x < high);
    }
};

/// Other options, "clump|convex", and what a message says about them.
struct OtherOptions {
    std::string_view names = {};
    std::string_view words = {};
};

struct Option {
    std::string_view name;
    char letter = '\0';           ///< of its short form; '\0': none
    std::string_view value = {};  ///< what stands for the value in the help
    OptionType type = OptionType::flag;
    OptionRange range = {};  ///< in SI
    Dimension dimension = Dimension::none;
    bool required = false;
    std::string_view standard = {};  ///< the default, as one would type it; "": none
    std::string_view words = {};     ///< choices, "surface|curve"
    std::string_view expected = {};  ///< completes "expected ..."; "": follows from type and range
    OtherOptions needs = {};         ///< one of them; `words` completes "found it ..."
    OtherOptions excludes =
        {};                   ///< `words` completes "found it with --other, ..."; "": one of both
    bool for_meshes = false;  ///< means something for a mesh only
    std::string_view help;
};

struct OptionGroup {
    std::string_view title;
    std::span<const Option> options;
};

/// A command: how it is typed, and its options in the order of the help.
struct CommandOptions {
    std::string_view name;  ///< after `shapegen`; "": cooking
    std::span<const OptionGroup> groups;

    const Option* find(std::string_view option) const;  ///< nullptr: not an option of this command
};

extern const CommandOptions cook_command;
extern const CommandOptions generate_command;
extern const CommandOptions inspect_command;
extern const CommandOptions export_command;

/// What is expected of a value, for messages and the help: "a whole number from 4 to 100000".
std::string expected_value(const Option& option);

/// Largest value of a count.
std::int64_t largest_count(const Option& option);

/// The words of "a|b|c".
std::vector<std::string> words_of(std::string_view list);

/// "a, b or c"
std::string alternatives(std::span<const std::string> words);

}  // namespace dem::shapegen
