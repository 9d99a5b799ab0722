// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

/// Decimal numbers in files and options: at most one sign, digits with at most one point, an
/// exponent if any; the same in every locale. "+-1" and "0x1p3" are none.
namespace dem {

/// The number that a text begins with.
struct NumberAhead {
    double value = 0.0;          ///< may be a NaN or infinite where the text says so
    std::string_view rest = {};  ///< of the text, behind the number
    /// invalid_argument: no number; result_out_of_range: none of double precision.
    std::errc error = {};

    bool is_finite() const { return error == std::errc() && value - value == 0.0; }
};
NumberAhead number_ahead(std::string_view text);

/// The finite number that a text is; none: it is something else.
std::optional<double> finite_number(std::string_view text);

/// The whole number that a text is, exactly: "1000", "1e3", "1.5e3" or "1000.0"; none: it is
/// something else, negative or 2^64 and more.
std::optional<std::uint64_t> whole_number(std::string_view text);

}  // namespace dem
