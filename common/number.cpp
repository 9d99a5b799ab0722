// SPDX-License-Identifier: BSD-3-Clause
#include "common/number.hpp"

#include <charconv>

namespace dem {

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

}  // namespace dem
