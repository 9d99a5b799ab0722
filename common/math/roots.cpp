// SPDX-License-Identifier: BSD-3-Clause
#include "common/math/double_double.hpp"
#include "common/math/elementary.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace dem::math {

// With |x| = 2^(3 q) 2^s m, m in [1, 2): a parabola for the root of m, Halley's step and one of
// Newton's with its residual to 100 bits. docs/elementary-functions.md
double cbrt(double x) {
    if (x == 0.0 || !std::isfinite(x)) return x;
    double size = std::abs(x);
    int exponent = -1023;
    if (size < std::numeric_limits<double>::min()) {
        size *= 0x1p54;
        exponent -= 54;
    }
    const auto bits = std::bit_cast<std::uint64_t>(size);
    exponent += static_cast<int>(bits >> 52);
    const auto mantissa = std::bit_cast<double>((bits & 0xfffffffffffffU) | 0x3ff0000000000000U);
    const int q = (exponent + 3072) / 3 - 1024;
    const auto s = static_cast<std::size_t>(exponent - 3 * q);

    constexpr std::array<double, 3> root_of_two_power = {1.0, 0x1.428a2f98d728bp+0,
                                                         0x1.965fea53d6e3dp+0};
    constexpr std::array<double, 3> two_power = {1.0, 2.0, 4.0};
    const double f = two_power[s] * mantissa;
    // Within 9e-4, so that Halley's step is within 5e-10 and Newton's within 2^-60.
    const double seed = root_of_two_power[s] * (0.6257 + mantissa * (0.43356 - mantissa * 0.05836));
    const double seed_cubed = seed * seed * seed;
    const double t = seed * ((seed_cubed + 2.0 * f) / (2.0 * seed_cubed + f));
    const DoubleDouble squared = two_product(t, t);
    const DoubleDouble cubed = two_product(squared.hi, t);
    const double residual = (f - cubed.hi) - cubed.lo - squared.lo * t;
    const double root = t + residual / (3.0 * squared.hi);
    const auto scale = std::bit_cast<double>(static_cast<std::uint64_t>(q + 1023) << 52);
    return std::copysign(root * scale, x);
}

}  // namespace dem::math
