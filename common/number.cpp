// SPDX-License-Identifier: BSD-3-Clause
#include "common/number.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace dem {

namespace {

/// All of a text as a whole number of its type.
template <class Integer>
std::optional<Integer> integer(std::string_view text) {
    Integer value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem != std::errc() || stop != end) return std::nullopt;
    return value;
}

}  // namespace

NumberAhead number_ahead(std::string_view text) {
    NumberAhead number{0.0, text, std::errc::invalid_argument};
    std::string_view unsigned_text = text;
    if (text.starts_with('+')) {
        unsigned_text.remove_prefix(1);
        // from_chars knows no plus sign, and would take "+-1" where one is skipped.
        if (unsigned_text.starts_with('-')) return number;
    }
    const char* end = unsigned_text.data() + unsigned_text.size();
    const auto found = std::from_chars(unsigned_text.data(), end, number.value);
    number.error = found.ec;
    if (found.ec != std::errc::invalid_argument)
        number.rest = {found.ptr, static_cast<std::size_t>(end - found.ptr)};
    return number;
}

std::optional<double> finite_number(std::string_view text) {
    const NumberAhead number = number_ahead(text);
    if (!number.is_finite() || !number.rest.empty()) return std::nullopt;
    return number.value;
}

// Digit by digit: a double would take 0.99999999999999999 for 1.
std::optional<std::uint64_t> whole_number(std::string_view text) {
    if (!finite_number(text)) return std::nullopt;
    if (text.starts_with('+')) text.remove_prefix(1);
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
    std::string digits(text.substr(0, mark));
    std::string_view exponent = text.substr(std::min(mark + 1, text.size()));
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    const auto power = exponent.empty() ? 0 : integer<std::int64_t>(exponent);
    if (!power) return std::nullopt;
    const std::size_t point = std::min(digits.find('.'), digits.size() - 1);
    std::int64_t zeros = *power;
    if (digits[point] == '.') {
        zeros -= static_cast<std::int64_t>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    if (digits.find_first_not_of('0') == std::string::npos) return 0;
    for (; zeros < 0 && digits.ends_with('0'); ++zeros) digits.pop_back();
    constexpr std::int64_t most_zeros = 19;  // of a number below 2^64
    if (zeros < 0 || zeros > most_zeros) return std::nullopt;
    digits.append(static_cast<std::size_t>(zeros), '0');
    return integer<std::uint64_t>(digits);
}

}  // namespace dem
