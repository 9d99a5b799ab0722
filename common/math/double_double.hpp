// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

/// Sums and products of doubles with their rounding errors, which are doubles, too (Dekker 1971,
/// Knuth TAOCP 2, section 4.2.2). They need -ffp-contract=off and no fast-math.
namespace dem {

/// The number hi + lo, about 106 bits: |lo| is at most half a unit in the last place of hi.
struct DoubleDouble {
    double hi = 0.0;
    double lo = 0.0;
};

/// a + b exactly, for |a| >= |b| or a = 0.
constexpr DoubleDouble fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a + b exactly.
constexpr DoubleDouble two_sum(double a, double b) {
    const double sum = a + b;
    const double b_in_sum = sum - a;
    return {sum, (a - (sum - b_in_sum)) + (b - b_in_sum)};
}

/// A double as the exact sum of two that have at most 26 bits each; |x| below 2^996.
constexpr DoubleDouble halves(double x) {
    const double shifted = 0x1.000002p+27 * x;  // 2^27 + 1
    const double upper = shifted - (shifted - x);
    return {upper, x - upper};
}

/// The first 26 bits of a double; their square is exact.
inline double upper_bits(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

/// a b exactly, where neither it nor its last bits leave the range of doubles.
constexpr DoubleDouble two_product(double a, double b) {
    const DoubleDouble x = halves(a);
    const DoubleDouble y = halves(b);
    const double product = a * b;
    return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

constexpr DoubleDouble operator-(const DoubleDouble& x) {
    return {-x.hi, -x.lo};
}
constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble sum = two_sum(x.hi, y.hi);
    return fast_two_sum(sum.hi, sum.lo + (x.lo + y.lo));
}
constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) {
    return x + -y;
}
constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble product = two_product(x.hi, y.hi);
    return fast_two_sum(product.hi, product.lo + (x.hi * y.lo + x.lo * y.hi));
}
constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.hi / y.hi;
    const DoubleDouble product = two_product(quotient, y.hi);
    const double rest = ((x.hi - product.hi) - product.lo) + (x.lo - quotient * y.lo);
    return fast_two_sum(quotient, rest / y.hi);
}

}  // namespace dem
