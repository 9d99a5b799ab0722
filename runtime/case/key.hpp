// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/units.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What a case file may say. Every key is declared once, in case_keys.cpp: reading, range checks,
/// suggestions, `demrun --keys` and the tables of docs/case-file.md all come from there.
namespace dem::runtime {

enum class ValueType : std::uint8_t {
    number,       ///< one quantity
    count,        ///< a whole number
    yes_no,       ///< yes | no
    choice,       ///< one of Key::words
    vector,       ///< three quantities
    orientation,  ///< a quaternion w x y z
    region,       ///< box ... | cylinder ...
    text          ///< a name or a path
};

struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_allowed = true;
    bool high_allowed = true;

    bool contains(double x) const {
        return (low_allowed ? x >= low : x > low) && (high_allowed ? x <= high : x < high);
    }
};

inline constexpr Range positive{.low = 0.0, .low_allowed = false};
inline constexpr Range not_negative{.low = 0.0};

struct Key {
    std::string_view name;
    ValueType type = ValueType::number;
    Dimension dimension = Dimension::none;
    Range range = {};  ///< in SI
    bool required = false;
    std::string_view standard = {};  ///< the default, as one would write it; "": none
    std::string_view words = {};     ///< choices; else words that may stand for a value ("auto")
    std::string_view names = {};     ///< "motion": beside the words the NAME of a [motion.NAME]
    std::string_view later = {};     ///< choices, or the key itself, that this version cannot do
    std::string_view when = {};      ///< "shape=box|plane": only with these choices of that key
    std::string_view doc = {};
};

/// A sort of section: "run", "wall.NAME", "contact.A.B" (words in capitals stand for names).
struct SectionKind {
    std::string_view pattern;
    std::span<const Key> keys;
    std::string_view doc;

    const Key* find(std::string_view key) const;  ///< nullptr: not a key of this section
};

/// All sorts of sections, in the order of the documentation.
std::span<const SectionKind> section_kinds();

/// The kind of section a name belongs to; nullptr: none.
const SectionKind* section_kind(std::string_view section);

/// "wall.vessel", '.' -> {"wall", "vessel"}; empty pieces are left out.
std::vector<std::string_view> split(std::string_view text, char separator);

/// "> 0", "0 to 0.5"; "" for any number.
std::string range_text(const Range& range);

/// Every section and key with unit, default, range and meaning, as Markdown: `demrun --keys`.
std::string describe_keys();

}  // namespace dem::runtime
