// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_file.hpp"

#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "common/text.hpp"
#include "formats/text_file.hpp"
#include "shapegen/profile/named_shapes.hpp"
#include "shapegen/profile/profile_path.hpp"
#include "shapegen/profile/profile_text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace dem::shapegen {
namespace {

std::string_view first_word(std::string_view text) {
    return text.substr(0, text.find_first_of(" \t,;"));
}

bool starts_a_number(std::string_view text) {
    const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t dot = text.size() > sign && text[sign] == '.' ? 1 : 0;
    return text.size() > sign + dot && text[sign + dot] >= '0' && text[sign + dot] <= '9';
}

bool is_not_a_number(std::string_view word) {
    return word == "nan" || word == "NaN" || word == "inf" || word == "-inf" || word == "-nan";
}

/// Points `r z` joined by lines; repeated points count once.
ProfileDraft parse_table(const ProfileText& text, std::size_t first_row) {
    ProfileDraft draft;
    Vec2 last = Vec2::Zero();
    for (std::size_t i = first_row; i < text.statements.size(); ++i) {
        const auto& [row, line] = text.statements[i];
        const auto cells = columns(row);
        if (cells.size() != 2)
            throw Error(text.place(line),
                        "found " + in_quotes(row) + ", expected two numbers 'r z'");
        const Vec2 point(text.length(cells[0], line), text.length(cells[1], line));
        if (point.x() < 0.0)
            throw Error(text.place(line),
                        in_quotes(row) + " has a negative radius, expected r >= 0");
        if (i > first_row && point != last)
            draft.append(LineSegment{last, point}, text.place(line));
        last = point;
    }
    if (draft.segments.empty())
        throw Error(text.path, "found one point, expected at least two different ones");
    return draft;
}

[[noreturn]] void fail_on_first(const ProfileText& text) {
    const auto& [statement, line] = text.statements.front();
    const std::string_view word = first_word(statement);
    throw Error(text.place(line), "unknown command " + in_quotes(word) +
                                      ", expected 'shape = ...', a path that begins with 'start', "
                                      "or a table of points 'r z'" +
                                      suggestion(word, path_commands()));
}

ProfileDraft parse_statements(const ProfileText& text) {
    const std::vector<std::string> settings = {"units", "shape"};
    for (const auto& [name, setting] : text.settings)
        if (name != "units")
            throw Error(text.place(setting.line), "unknown setting " + in_quotes(name) +
                                                      ", expected 'units' or 'shape'" +
                                                      suggestion(name, settings));
    if (text.statements.empty())
        throw Error(text.path, "found no profile, expected 'shape = ...', a path or a table");
    const std::string_view first = first_word(text.statements.front().text);
    if (starts_a_number(first) || is_not_a_number(first)) return parse_table(text, 0);
    if (is_path_command(first)) return parse_path(text);
    // A header is a line of words above a line of numbers.
    const bool has_header = text.statements.size() > 1 && starts_a_number(text.statements[1].text);
    if (!has_header) fail_on_first(text);
    return parse_table(text, 1);
}

/// A path may be written from top to bottom as well.
void run_upwards(ProfileDraft& draft) {
    const Vec2 first = evaluate(draft.segments.front(), 0.0).point;
    const Vec2 last = evaluate(draft.segments.back(), 1.0).point;
    if (first.y() <= last.y()) return;
    std::reverse(draft.segments.begin(), draft.segments.end());
    std::reverse(draft.labels.begin(), draft.labels.end());
    for (ProfileSegment& segment : draft.segments) segment = reversed(segment);
}

/// [SR] Sec. 2.1: ends off the axis are projected onto it.
void close_by_discs(ProfileDraft& draft) {
    const Vec2 first = evaluate(draft.segments.front(), 0.0).point;
    const Vec2 last = evaluate(draft.segments.back(), 1.0).point;
    const double size = std::max({first.norm(), last.norm(), (last - first).norm()});
    if (first.x() > 1e-9 * size) {
        draft.segments.insert(draft.segments.begin(), LineSegment{Vec2(0.0, first.y()), first});
        draft.labels.insert(draft.labels.begin(), draft.labels.front() + " (closing disc)");
    }
    if (last.x() > 1e-9 * size)
        draft.append(LineSegment{last, Vec2(0.0, last.y())},
                     draft.labels.back() + " (closing disc)");
}

}  // namespace

ProfileFile parse_profile(std::string_view text, const std::string& path, double scale) {
    const ProfileText parts = parse_profile_text(text, path, scale);
    if (parts.settings.empty() && parts.statements.empty())
        throw Error(path, "the file is empty, expected a profile");
    ProfileDraft draft =
        parts.settings.contains("shape") ? named_shape(parts) : parse_statements(parts);
    run_upwards(draft);
    close_by_discs(draft);
    return {Profile(std::move(draft.segments), std::move(draft.labels)),
            std::filesystem::path(path).stem().string(), file_hash(text), parts.unit * scale};
}

ProfileFile read_profile(const std::string& path, double scale) {
    return parse_profile(read_text_file(path, "profile", most_profile_megabytes), path, scale);
}

}  // namespace dem::shapegen
