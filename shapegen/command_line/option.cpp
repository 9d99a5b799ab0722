// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/option.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {

const Option* CommandOptions::find(std::string_view option) const {
    for (const OptionGroup& group : groups) {
        const auto found = std::ranges::find(group.options, option, &Option::name);
        if (found != group.options.end()) return &*found;
    }
    return nullptr;
}

std::vector<std::string> words_of(std::string_view list) {
    std::vector<std::string> words;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find('|'), list.size());
        words.emplace_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return words;
}

std::string alternatives(std::span<const std::string> words) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k)
        text += (k == 0 ? "" : k + 1 < words.size() ? ", " : " or ") + words[k];
    return text;
}

std::int64_t largest_count(const Option& option) {
    return std::isfinite(option.range.high) ? static_cast<std::int64_t>(option.range.high)
                                            : std::numeric_limits<std::int64_t>::max();
}

std::string expected_value(const Option& option) {
    if (!option.expected.empty()) return std::string(option.expected);
    if (option.type == OptionType::count)
        return "a whole number from " +
               std::to_string(static_cast<std::int64_t>(option.range.low)) + " to " +
               std::to_string(largest_count(option));
    return alternatives(words_of(option.words));
}

}  // namespace dem::shapegen
