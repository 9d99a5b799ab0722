// SPDX-License-Identifier: BSD-3-Clause
// sin and cos: the argument less the nearest multiple of pi/2, as a double-double within
// [-pi/4, pi/4], then a polynomial. docs/elementary-functions.md
#include "common/math/double_double.hpp"
#include "common/math/elementary.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace dem::math {

namespace {

/// x = quarter pi/2 + angle, the quarter turns counted modulo 4.
struct ReducedAngle {
    DoubleDouble angle;
    unsigned quarter;
};

constexpr double quarter_pi = 0x1.921fb54442d18p-1;
constexpr DoubleDouble half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

// pi/2 in three pieces of 33 bits, of which multiples up to 2^20 are exact, and a rest.
constexpr std::array<double, 4> half_pi_pieces = {0x1.921fb544p+0, 0x1.0b4611a6p-34,
                                                  0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
constexpr double largest_by_pieces = 0x1p20;  // [rad]

/// For |x| up to 2^20, by pieces (Cody and Waite 1980).
ReducedAngle reduced_by_pieces(double x) {
    constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    constexpr double rounder = 0x1.8p52;  // a sum with it has no digits behind the point
    const double n = (x * two_over_pi + rounder) - rounder;
    const DoubleDouble first = two_sum(x - n * half_pi_pieces[0], -n * half_pi_pieces[1]);
    const DoubleDouble second = two_sum(first.hi, -n * half_pi_pieces[2]);
    const double rest = (first.lo + second.lo) - n * half_pi_pieces[3];
    return {fast_two_sum(second.hi, rest), static_cast<unsigned>(static_cast<int>(n))};
}

// 64 zeros, then the first 1216 binary digits of 2/pi, which begin behind its point.
constexpr std::array<std::uint32_t, 40> two_over_pi_digits = {
    0x00000000, 0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
    0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

/// For x of any size above 2^20, in integers (Payne and Hanek 1983). With x = m 2^e the digits of
/// 2/pi down to 2^(2 - e) give multiples of 4 quarter turns; the next 192, times m, give the turn
/// modulo 4 to 137 digits behind the point, and no double is nearer than 2^-62 to a multiple.
ReducedAngle reduced_in_integers(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<int>(bits >> 52) - 1075;
    const std::uint64_t m = (bits & 0xfffffffffffffU) | 0x10000000000000U;
    const auto position = static_cast<unsigned>(exponent - 2 + 64);
    const std::size_t word = position / 32;
    const unsigned shift = position % 32;
    const std::uint64_t m_low = m & 0xffffffffU;
    const std::uint64_t m_high = m >> 32;

    // m times the digits modulo 2^192, from its last 32 digits to its first.
    std::array<std::uint32_t, 6> product;
    std::uint64_t carry = 0;
    std::uint64_t below = 0;  // the digits of the word before
    for (std::size_t k = 6; k-- > 0;) {
        const std::uint64_t two_words =
            (std::uint64_t{two_over_pi_digits[word + k]} << 32) | two_over_pi_digits[word + k + 1];
        const std::uint64_t digits = (two_words >> (32 - shift)) & 0xffffffffU;
        const std::uint64_t low = m_low * digits;
        const std::uint64_t high = m_high * below;  // both below 2^64 - 2^33
        const std::uint64_t sum =
            (low & 0xffffffffU) + (high & 0xffffffffU) + (carry & 0xffffffffU);
        product[k] = static_cast<std::uint32_t>(sum);
        carry = (carry >> 32) + (low >> 32) + (high >> 32) + (sum >> 32);
        below = digits;
    }

    // Its first two digits are the quarter turns, the others a fraction, to the nearest turn.
    unsigned quarter = product[0] >> 30;
    const bool is_upper_half = ((product[0] >> 29) & 1U) != 0;
    DoubleDouble fraction;
    double weight = 0x1p-30;
    std::uint32_t mask = 0x3fffffffU;
    for (std::size_t k = 0; k < 6; ++k) {
        // One's complement: what is missing, 2^-190, is less than the error of the digits.
        const std::uint32_t digits = (is_upper_half ? ~product[k] : product[k]) & mask;
        const DoubleDouble sum = two_sum(fraction.hi, digits * weight);
        fraction = fast_two_sum(sum.hi, fraction.lo + sum.lo);
        weight *= 0x1p-32;
        mask = 0xffffffffU;
    }
    if (is_upper_half) {
        ++quarter;
        fraction = -fraction;
    }
    return {fraction * half_pi, quarter};
}

ReducedAngle reduced(double x) {
    if (std::abs(x) <= quarter_pi) return {{x, 0.0}, 0U};
    if (std::abs(x) <= largest_by_pieces) return reduced_by_pieces(x);
    const ReducedAngle positive = reduced_in_integers(std::abs(x));
    return x > 0.0 ? positive : ReducedAngle{-positive.angle, 0U - positive.quarter};
}

/// sin x, |x| up to pi/4; polynomial to 2^-57.2 of x.
double sine(const DoubleDouble& x) {
    const double r = x.hi;
    const double z = r * r;
    const double p = -0x1.5555555555549p-3 +
                     z * (0x1.111111110f87cp-7 +
                          z * (-0x1.a01a019c11e64p-13 +
                               z * (0x1.71de3578066d1p-19 +
                                    z * (-0x1.ae5e668244b85p-26 + z * 0x1.5d931831655e5p-33))));
    return r + (r * z * p + x.lo * (1.0 - 0.5 * z));
}

/// cos x, |x| up to pi/4; polynomial to 2^-60.2 of 1.
double cosine(const DoubleDouble& x) {
    const double r = x.hi;
    const double z = r * r;
    const double p = 0x1.5555555555552p-5 +
                     z * (-0x1.6c16c16c15fcap-10 +
                          z * (0x1.a01a019e1585fp-16 +
                               z * (-0x1.27e4f908598dep-22 +
                                    z * (0x1.1eea9678279f2p-29 + z * -0x1.9005859b3ce41p-37))));
    // 1 - r^2 / 2 with its error, r^2 from the upper 26 bits of r (exact) and the rest.
    const double upper = upper_bits(r);
    const double half = 0.5 * (upper * upper);
    const double half_rest = 0.5 * ((r - upper) * (r + upper));
    const double first = 1.0 - half;
    return first + (((1.0 - first) - half) + (z * z * p - (half_rest + r * x.lo)));
}

/// sin of the angle and `more` quarter turns.
double turned_sine(const ReducedAngle& r, unsigned more) {
    const unsigned quarter = r.quarter + more;
    const double value = (quarter & 1U) == 0 ? sine(r.angle) : cosine(r.angle);
    return (quarter & 2U) == 0 ? value : -value;
}

constexpr double small_angle = 0x1p-27;  // below, sin x is x and cos x is 1 to less than an ulp / 4

}  // namespace

double sin(double x) {
    if (std::abs(x) < small_angle) return x;  // keeps the sign of zero
    if (!std::isfinite(x)) return x - x;
    return turned_sine(reduced(x), 0U);
}

double cos(double x) {
    if (!std::isfinite(x)) return x - x;
    return turned_sine(reduced(x), 1U);
}

SineCosine sin_cos(double x) {
    if (std::abs(x) < small_angle) return {x, 1.0};
    if (!std::isfinite(x)) return {x - x, x - x};
    const ReducedAngle r = reduced(x);
    const double s = sine(r.angle);
    const double c = cosine(r.angle);
    const bool is_odd = (r.quarter & 1U) != 0;
    const double first = is_odd ? c : s;
    const double second = is_odd ? s : c;
    return {(r.quarter & 2U) == 0 ? first : -first,
            ((r.quarter + 1U) & 2U) == 0 ? second : -second};
}

}  // namespace dem::math
