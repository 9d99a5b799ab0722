// SPDX-License-Identifier: BSD-3-Clause
// exp and log by tables of 64 powers of two and 128 logarithms, and pow from both with the
// logarithm to 68 bits. docs/elementary-functions.md
#include "common/math/double_double.hpp"
#include "common/math/elementary.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace dem::math {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr DoubleDouble ln_2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// 2^n for -1022 <= n <= 1023.
double power_of_two(int n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

// ---- exp ----

constexpr int steps = 64;  // of the exponent between powers of two

/// 2^(j / 64) by the series of exp.
constexpr std::array<DoubleDouble, steps> make_powers() {
    std::array<DoubleDouble, steps> powers{};
    for (int j = 0; j < steps; ++j) {
        const DoubleDouble x = ln_2 * DoubleDouble{static_cast<double>(j) / steps};
        DoubleDouble term{1.0};
        DoubleDouble sum{1.0};
        for (int n = 1; n < 28; ++n) {
            term = term * x / DoubleDouble{static_cast<double>(n)};
            sum = sum + term;
        }
        powers[static_cast<std::size_t>(j)] = sum;
    }
    return powers;
}

constexpr std::array<DoubleDouble, steps> power = make_powers();

/// exp(x) for |x| below 1100.
double exp_of(const DoubleDouble& x) {
    constexpr double steps_per_one = 0x1.71547652b82fep+6;  // 64 / ln 2
    // ln 2 / 64 with 36 bits, of which multiples by k are exact, and the rest.
    constexpr double step = 0x1.62e42fefap-7;
    constexpr double step_rest = 0x1.cf79abc9e3b3ap-46;
    constexpr double rounder = 0x1.8p52;  // a sum with it has no digits behind the point
    const double n = (x.hi * steps_per_one + rounder) - rounder;
    const double r = ((x.hi - n * step) - n * step_rest) + x.lo;
    const double less_one =
        r +
        r * r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0)))));
    const auto k = static_cast<int>(n);
    const DoubleDouble& p = power[static_cast<std::size_t>(k & (steps - 1))];
    const double mantissa = p.hi + (p.lo + p.hi * less_one);
    const int exponent = k >> 6;
    if (exponent >= -1022 && exponent <= 1023) return mantissa * power_of_two(exponent);
    if (exponent > 1023) return mantissa * power_of_two(1023) * power_of_two(exponent - 1023);
    return mantissa * power_of_two(exponent + 600) * power_of_two(-600);
}

// ---- log ----

constexpr std::size_t intervals = 128;   // of a mantissa
constexpr std::size_t first_upper = 53;  // from here on, 1 + 53/128 > sqrt(2), it is halved

/// A number c of 9 bits near 1 / m for the mantissas m of an interval, and -log(c), hi in whole
/// 2^-42, like the multiples of ln 2 that it is added to.
struct LogStep {
    double inverse;
    DoubleDouble log;
};

constexpr std::array<LogStep, intervals> make_log_steps() {
    std::array<LogStep, intervals> table{};
    for (std::size_t i = 0; i < intervals; ++i) {
        const double middle =
            (1.0 + (static_cast<double>(i) + 0.5) / intervals) * (i < first_upper ? 1.0 : 0.5);
        const double nearest = 256.0 / middle + 0.5;  // once it is cut to a whole number
        double c = static_cast<double>(static_cast<int>(nearest)) / 256.0;
        if (i == 0 || i == intervals - 1) c = 1.0;  // no digits are lost where log is about zero
        // -log c = 2 atanh((1 - c) / (1 + c))
        const DoubleDouble s = DoubleDouble{1.0 - c} / DoubleDouble{1.0 + c};
        DoubleDouble odd_power = s;
        DoubleDouble sum;
        for (int n = 1; n < 45; n += 2) {
            sum = sum + odd_power / DoubleDouble{static_cast<double>(n)};
            odd_power = odd_power * s * s;
        }
        const double hi = (2.0 * sum.hi + 0x1.8p10) - 0x1.8p10;
        table[i] = {c, {hi, (2.0 * sum.hi - hi) + 2.0 * sum.lo}};
    }
    return table;
}

constexpr std::array<LogStep, intervals> log_steps = make_log_steps();

/// log(1 + r) for |r| below 1/128, to 2^-68 of itself.
DoubleDouble log_of_one_plus(const DoubleDouble& r) {
    const double x = r.hi;
    // x^2 from the upper 26 bits of x (exact) and the rest.
    const double upper = upper_bits(x);
    const double square = upper * upper;
    const double square_rest = (x - upper) * (x + upper);
    const double series =
        x * (x * x) *
        (1.0 / 3.0 +
         x * (-1.0 / 4.0 +
              x * (1.0 / 5.0 +
                   x * (-1.0 / 6.0 +
                        x * (1.0 / 7.0 + x * (-1.0 / 8.0 + x * (1.0 / 9.0 - x * 0.1)))))));
    const DoubleDouble sum = fast_two_sum(x, -0.5 * square);
    return {sum.hi, sum.lo + ((r.lo - x * r.lo) - 0.5 * square_rest + series)};
}

/// log(x) to 2^-67 of itself, for finite x above zero.
DoubleDouble log_of(double x) {
    int exponent = -1023;
    if (x < std::numeric_limits<double>::min()) {
        x *= 0x1p54;
        exponent -= 54;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<int>(bits >> 52);
    const auto i = static_cast<std::size_t>((bits >> 45) & (intervals - 1));
    const bool is_upper = i >= first_upper;
    if (is_upper) ++exponent;
    const auto mantissa = std::bit_cast<double>(
        (bits & 0xfffffffffffffU) | (is_upper ? 0x3fe0000000000000U : 0x3ff0000000000000U));
    // c m - 1 exactly: c has 9 bits, the upper part of m 26 and the lower one 27.
    const LogStep& step = log_steps[i];
    const double upper = upper_bits(mantissa);
    const DoubleDouble r = two_sum(step.inverse * upper - 1.0, step.inverse * (mantissa - upper));
    const DoubleDouble rest = log_of_one_plus(r);
    // ln 2 with 42 bits, of which multiples by the exponent are exact, and the rest.
    const double n = exponent;
    const double whole = n * 0x1.62e42fefa38p-1 + step.log.hi;
    const DoubleDouble sum = fast_two_sum(whole, rest.hi);
    return fast_two_sum(sum.hi, sum.lo + (rest.lo + (step.log.lo + n * 0x1.ef35793c7673p-45)));
}

// ---- pow ----

bool is_whole(double y) {
    return std::floor(y) == y;
}
bool is_odd(double y) {
    return is_whole(y) && !is_whole(0.5 * y);
}

/// x^y for x from 0 to infinity but 1, y finite and not zero.
double power_of_positive(double x, double y) {
    if (x == 0.0 || x == infinity) return (x == 0.0) == (y > 0.0) ? 0.0 : infinity;
    const DoubleDouble logarithm = log_of(x);
    const double product = y * logarithm.hi;
    if (product > 710.0) return infinity;
    if (product < -746.0) return 0.0;
    // log x is 2^-53 or more, so that y is below 2^63; where it is tiny, the result is 1.
    if (std::abs(product) < 0x1p-55) return 1.0;
    const DoubleDouble exponent = two_product(y, logarithm.hi);
    return exp_of({exponent.hi, exponent.lo + y * logarithm.lo});
}

}  // namespace

double exp(double x) {
    if (x > 710.0) return x == infinity ? x : infinity;
    if (x < -746.0) return 0.0;
    if (std::isnan(x)) return x;
    return exp_of({x, 0.0});
}

double log(double x) {
    if (std::isnan(x) || x == infinity) return x;
    if (x == 0.0) return -infinity;
    if (x < 0.0) return nan;
    const DoubleDouble logarithm = log_of(x);
    return logarithm.hi + logarithm.lo;
}

double log10(double x) {
    if (!(x > 0.0) || x == infinity) return log(x);
    const DoubleDouble logarithm =
        log_of(x) * DoubleDouble{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
    return logarithm.hi + logarithm.lo;
}

double pow(double x, double y) {
    if (y == 0.0 || x == 1.0) return 1.0;
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const double size = std::abs(x);
    if (std::isinf(y)) {
        if (size == 1.0) return 1.0;
        return (size > 1.0) == (y > 0.0) ? infinity : 0.0;
    }
    if (x < 0.0 && size != infinity && !is_whole(y)) return nan;
    const double value = size == 1.0 ? 1.0 : power_of_positive(size, y);
    return std::signbit(x) && is_odd(y) ? -value : value;
}

}  // namespace dem::math
