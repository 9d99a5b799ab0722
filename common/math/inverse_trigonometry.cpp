// SPDX-License-Identifier: BSD-3-Clause
// atan and what follows from it: the angle of a point is that of the nearest of seventeen
// directions with slopes k/16, and the arc tangent of a slope of at most 1/32 seen from there.
// docs/elementary-functions.md
#include "common/math/double_double.hpp"
#include "common/math/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace dem::math {

namespace {

constexpr DoubleDouble pi_pair = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

constexpr std::size_t directions = 16;

/// atan(k / 16), each from the one before: the slope from there is 16 / (256 + k (k - 1)).
constexpr std::array<DoubleDouble, directions + 1> make_angles() {
    std::array<DoubleDouble, directions + 1> angles{};
    for (std::size_t k = 1; k <= directions; ++k) {
        const DoubleDouble slope =
            DoubleDouble{16.0} / DoubleDouble{256.0 + static_cast<double>(k * (k - 1))};
        DoubleDouble power = slope;
        DoubleDouble sum;
        for (int n = 1; n < 29; n += 2) {
            sum = sum + power / DoubleDouble{static_cast<double>(n)};
            power = -power * slope * slope;
        }
        angles[k] = angles[k - 1] + sum;
    }
    return angles;
}

constexpr std::array<DoubleDouble, directions + 1> direction_angle = make_angles();

/// atan(y / x) for 0 <= y <= x, x far from where doubles end.
DoubleDouble angle_below_diagonal(const DoubleDouble& y, const DoubleDouble& x) {
    const double nearest = directions * (y.hi / x.hi) + 0.5;  // once it is cut to a whole number
    const auto k = static_cast<std::size_t>(nearest);
    const double slope = static_cast<double>(k) / directions;
    // Across and along the direction, times its secant. A slope has 5 bits, so that its products
    // with halves of x are exact, and so is the first difference: y is near slope x.
    const DoubleDouble x_half = halves(x.hi);
    DoubleDouble across = two_sum(y.hi - slope * x_half.hi, -slope * x_half.lo);
    across.lo += y.lo - slope * x.lo;
    const DoubleDouble along = fast_two_sum(x.hi, slope * y.hi);
    const double inverse = 1.0 / along.hi;
    const double t = across.hi * inverse;
    const DoubleDouble product = two_product(t, along.hi);
    const double rest = (across.hi - product.hi) - product.lo;
    const double t_rest = (rest + (across.lo - t * (along.lo + (x.lo + slope * y.lo)))) * inverse;
    const double s = t * t;
    const double series =
        t * s *
        (-1.0 / 3.0 + s * (1.0 / 5.0 + s * (-1.0 / 7.0 + s * (1.0 / 9.0 - s * (1.0 / 11.0)))));
    const DoubleDouble& angle = direction_angle[k];
    const DoubleDouble sum = fast_two_sum(angle.hi, t);
    return fast_two_sum(sum.hi, sum.lo + (angle.lo + (t_rest + series)));
}

/// Angle in [0, pi] of a point with y >= 0, not the origin and not far away.
double angle_of(const DoubleDouble& y, const DoubleDouble& x) {
    const bool is_left = x.hi < 0.0;
    const DoubleDouble x_size = is_left ? -x : x;
    const bool is_steep = y.hi > x_size.hi;
    const DoubleDouble acute = angle_below_diagonal(is_steep ? x_size : y, is_steep ? y : x_size);
    // From the nearer half axis, to its left (+) or to its right.
    const double axis = is_steep ? 0.5 : (is_left ? 1.0 : 0.0);
    const double side = is_steep == is_left ? 1.0 : -1.0;
    const DoubleDouble sum = fast_two_sum(axis * pi_pair.hi, side * acute.hi);
    return sum.hi + (sum.lo + (axis * pi_pair.lo + side * acute.lo));
}

/// sqrt(1 - x^2) for |x| <= 1.
DoubleDouble other_leg(double x) {
    const DoubleDouble rest = DoubleDouble{1.0} - two_product(x, x);
    if (rest.hi <= 0.0) return {};
    const double root = std::sqrt(rest.hi);
    const DoubleDouble squared = two_product(root, root);
    const double missing = ((rest.hi - squared.hi) - squared.lo) + rest.lo;
    return fast_two_sum(root, missing / (2.0 * root));
}

/// 2^n for the n that brings a number as large as x to [2, 4); 2^1023 where there is no larger.
double scale_to_two(double x) {
    const std::uint64_t biased_exponent = std::bit_cast<std::uint64_t>(x) >> 52;
    return std::bit_cast<double>((2047 - std::max<std::uint64_t>(biased_exponent, 1)) << 52);
}

constexpr double negligible = 0x1p-30;  // below, atan x is x to less than an ulp / 100

/// atan2 for finite y >= 0 and finite x, not both zero.
double upper_angle(double y, double x) {
    const double larger = std::max(y, std::abs(x));
    if (larger == x && y < negligible * x) return y / x;
    const double scale = scale_to_two(larger);
    return angle_of({y * scale, 0.0}, {x * scale, 0.0});
}

}  // namespace

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    if (std::isinf(x) && std::isinf(y)) return atan2(std::copysign(1.0, y), std::copysign(1.0, x));
    if (std::isinf(x)) return atan2(std::copysign(0.0, y), std::copysign(1.0, x));
    if (std::isinf(y)) return std::copysign(0.5 * pi_pair.hi, y);
    if (y == 0.0 && !std::signbit(x)) return y;
    if (y == 0.0) return std::copysign(pi_pair.hi, y);
    return std::copysign(upper_angle(std::abs(y), x), y);
}

double atan(double x) {
    return atan2(x, 1.0);
}

double asin(double x) {
    if (!(std::abs(x) <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
    if (std::abs(x) < negligible) return x;
    return std::copysign(angle_of({std::abs(x), 0.0}, other_leg(x)), x);
}

double acos(double x) {
    if (!(std::abs(x) <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
    return angle_of(other_leg(x), {x, 0.0});
}

}  // namespace dem::math
