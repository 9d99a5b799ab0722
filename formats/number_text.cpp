// SPDX-License-Identifier: BSD-3-Clause
#include "formats/number_text.hpp"

#include <charconv>
#include <cmath>

namespace dem {

std::string number_text(double value) {
    char digits[32];
    const bool is_whole = std::abs(value) < 0x1p53 && value == std::floor(value);
    const auto result =
        is_whole ? std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed)
                 : std::to_chars(digits, digits + sizeof digits, value);
    return {digits, result.ptr};
}

}  // namespace dem
