// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_segment.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dem::shapegen {

/// A profile file taken apart into its lines: settings `key = value` and statements. Comments and
/// blank lines are gone. The views look into the text that was parsed.
struct ProfileText {
    struct Setting {
        std::string_view value;
        std::size_t line;
    };
    struct Statement {
        std::string_view text;
        std::size_t line;
    };

    std::string path;
    std::map<std::string, Setting, std::less<>> settings;
    std::vector<Statement> statements;
    double unit = 1.0;   ///< of plain numbers [m], from the setting `units`
    double scale = 1.0;  ///< of all lengths, whatever their unit

    /// "tablet.profile:12"
    std::string place(std::size_t line) const { return path + ":" + std::to_string(line); }

    /// A length with or without a unit [m], times the scale. Throws Error(place, ...).
    double length(std::string_view text, std::size_t line) const;
};

/// Throws Error for bytes that are no text, a setting given twice or without a value, an unknown
/// unit, more lines than `most_profile_lines`.
ProfileText parse_profile_text(std::string_view text, const std::string& path, double scale = 1.0);

/// More points than any drawing or measured outline has; a longer table is a mistake that would
/// only cost time and memory.
inline constexpr std::size_t most_profile_lines = 100'000;
/// What so many lines of numbers with 17 digits, units and comments take [MB].
inline constexpr std::size_t most_profile_megabytes = 64;

/// Segments of a profile as written, each with its place in the file.
struct ProfileDraft {
    std::vector<ProfileSegment> segments;
    std::vector<std::string> labels;

    void append(const ProfileSegment& segment, const std::string& label) {
        segments.push_back(segment);
        labels.push_back(label);
    }
};

/// The columns of a row, separated by blanks, a comma or a semicolon.
std::vector<std::string_view> columns(std::string_view row);

}  // namespace dem::shapegen
