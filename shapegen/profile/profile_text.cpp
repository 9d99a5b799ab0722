// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_text.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "common/units.hpp"

#include <algorithm>
#include <cstdio>

namespace dem::shapegen {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

void check_bytes(std::string_view line, const std::string& place) {
    for (const char c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte >= 32 && byte != 127) || is_blank(c)) continue;
        char hex[8];
        std::snprintf(hex, sizeof hex, "0x%02x", byte);
        throw Error(place, "found " + std::string("byte ") + hex + ", expected text");
    }
}

void add_setting(std::string_view line, std::size_t number, ProfileText& result) {
    const std::size_t equals = line.find('=');
    const std::string_view key = trimmed(line.substr(0, equals));
    const std::string_view value = trimmed(line.substr(equals + 1));
    if (key.empty() || value.empty())
        throw Error(result.place(number), "found " + in_quotes(line) + ", expected 'name = value'");
    const auto [entry, is_new] = result.settings.emplace(key, ProfileText::Setting{value, number});
    if (!is_new)
        throw Error(result.place(number), in_quotes(key) + " given again, expected it once (line " +
                                              std::to_string(entry->second.line) + ")");
}

}  // namespace

double ProfileText::length(std::string_view text, std::size_t line) const {
    if (const auto value = finite_number(text)) return *value * unit * scale;
    try {
        return parse_quantity(text, Dimension::length) * scale;
    } catch (const Error& problem) {
        throw Error(place(line), problem.what());
    }
}

ProfileText parse_profile_text(std::string_view text, const std::string& path, double scale) {
    ProfileText result;
    result.path = path;
    result.scale = scale;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (++number > most_profile_lines)
            throw Error(path, "found more than " + std::to_string(most_profile_lines) +
                                  " lines, expected a profile of at most that many points");
        check_bytes(line, result.place(number));
        line = trimmed(line.substr(0, line.find('#')));
        if (line.empty()) continue;
        if (line.find('=') != std::string_view::npos) {
            add_setting(line, number, result);
        } else {
            result.statements.push_back({line, number});
        }
    }
    if (const auto units = result.settings.find("units"); units != result.settings.end()) {
        try {
            result.unit = unit_factor(units->second.value, Dimension::length);
        } catch (const Error& problem) {
            throw Error(result.place(units->second.line), problem.what());
        }
    }
    return result;
}

std::vector<std::string_view> columns(std::string_view row) {
    std::vector<std::string_view> result;
    constexpr std::string_view separators = " \t,;";
    while (true) {
        row.remove_prefix(std::min(row.find_first_not_of(separators), row.size()));
        if (row.empty()) return result;
        const std::size_t end = std::min(row.find_first_of(separators), row.size());
        result.push_back(row.substr(0, end));
        row.remove_prefix(end);
    }
}

}  // namespace dem::shapegen
