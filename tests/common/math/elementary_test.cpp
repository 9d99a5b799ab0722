// SPDX-License-Identifier: BSD-3-Clause
// The reference is the C library in long double, whose 64 bits give errors to a thousandth of an
// ulp. Only the arguments come from the library's own random numbers; nothing here is fast.
#include "common/math/elementary.hpp"

#include "common/random.hpp"
#include "common/state_hash.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace dem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int samples = 40'000;

/// Distance of a result from the exact one in units in its last place.
double error_in_ulp(double result, long double exact) {
    int exponent = 0;
    std::frexp(exact, &exponent);
    const int last_place = std::max(exponent - 53, -1074);
    return static_cast<double>(std::abs(std::ldexp(result - exact, -last_place)));
}

using Arguments = std::function<double(Random&)>;

Arguments between(double low, double high) {
    return [=](Random& random) { return random.uniform(low, high); };
}
/// Both signs, sizes between 2^low and 2^high, each binade as often as the others.
Arguments of_size(double low, double high) {
    return [=](Random& random) {
        const double size = std::exp2(random.uniform(low, high));
        return random.uniform() < 0.5 ? -size : size;
    };
}
Arguments positive(const Arguments& arguments) {
    return [=](Random& random) { return std::abs(arguments(random)); };
}
/// One plus or minus 2^low to 2^high.
Arguments near_one(double low, double high) {
    return [=](Random& random) { return 1.0 + of_size(low, high)(random); };
}
/// The doubles next to multiples of pi/2, where sine or cosine is smallest.
Arguments near_quarter_turns(double low, double high) {
    return [=](Random& random) {
        const long double quarters = std::floor(positive(of_size(low, high))(random));
        return static_cast<double>(quarters * 1.57079632679489661923132169163975144L);
    };
}

double largest_error(double (*function)(double), long double (*exact)(long double),
                     const std::vector<Arguments>& ranges) {
    double largest = 0.0;
    for (std::size_t r = 0; r < ranges.size(); ++r) {
        Random random(17, r);
        for (int n = 0; n < samples; ++n) {
            const double x = ranges[r](random);
            const double error = error_in_ulp(function(x), exact(x));
            if (!(error <= largest)) largest = error;  // keeps a NaN
        }
    }
    return largest;
}

double largest_error(double (*function)(double, double),
                     long double (*exact)(long double, long double), const Arguments& first,
                     const std::function<double(Random&, double)>& second) {
    double largest = 0.0;
    Random random(18, 0);
    for (int n = 0; n < samples; ++n) {
        const double x = first(random);
        const double y = second(random, x);
        const double error = error_in_ulp(function(x, y), exact(x, y));
        if (!(error <= largest)) largest = error;
    }
    return largest;
}

/// Exponents that bring x^y to between 2^low and 2^high.
std::function<double(Random&, double)> exponents(double low, double high) {
    return [=](Random& random, double x) { return random.uniform(low, high) / std::log2(x); };
}

TEST(Elementary, SineAndCosineAreRightForArgumentsOfAnySize) {
    const std::vector<Arguments> ranges = {between(-0.8, 0.8),        between(-100.0, 100.0),
                                           of_size(-60.0, 20.0),      of_size(20.0, 1024.0),
                                           near_quarter_turns(0, 19), near_quarter_turns(20, 60)};
    EXPECT_LE(largest_error(math::sin, std::sin, ranges), 0.80);
    EXPECT_LE(largest_error(math::cos, std::cos, ranges), 0.80);
}

TEST(Elementary, SineAndCosineTogetherAreTheSameBits) {
    Random random(19, 0);
    for (int n = 0; n < samples; ++n) {
        const double x = of_size(-40.0, 1024.0)(random);
        const math::SineCosine both = math::sin_cos(x);
        ASSERT_EQ(both.sine, math::sin(x)) << x;
        ASSERT_EQ(both.cosine, math::cos(x)) << x;
    }
}

TEST(Elementary, ArcFunctionsAreRight) {
    EXPECT_LE(largest_error(math::atan, std::atan, {between(-2.0, 2.0), of_size(-60.0, 60.0)}),
              0.52);
    const std::vector<Arguments> sines = {between(-1.0, 1.0), of_size(-60.0, 0.0),
                                          [](Random& random) {
                                              const double x = near_one(-53.0, -1.0)(random);
                                              return x > 1.0 ? x - 2.0 : x;
                                          }};
    EXPECT_LE(largest_error(math::asin, std::asin, sines), 0.52);
    EXPECT_LE(largest_error(math::acos, std::acos, sines), 0.52);
}

TEST(Elementary, AnglesOfPointsOfAnySizeAreRight) {
    const auto of_any_size = [](Random& random, double /*y*/) {
        return of_size(-1074.0, 1024.0)(random);
    };
    const auto of_like_size = [](Random& random, double y) {
        return y * of_size(-40.0, 40.0)(random);
    };
    EXPECT_LE(largest_error(math::atan2, std::atan2, of_size(-1074.0, 1024.0), of_any_size), 0.52);
    EXPECT_LE(largest_error(math::atan2, std::atan2, of_size(-900.0, 900.0), of_like_size), 0.52);
}

TEST(Elementary, ExponentialsAndLogarithmsAreRight) {
    EXPECT_LE(largest_error(math::exp, std::exp,
                            {between(-708.0, 709.7), between(-1.0, 1.0), of_size(-60.0, 1.0)}),
              0.53);
    EXPECT_LE(largest_error(math::exp, std::exp, {between(-745.0, -708.5)}), 0.77) << "subnormal";
    const std::vector<Arguments> positives = {positive(of_size(-1074.0, 1024.0)), between(0.5, 2.0),
                                              near_one(-52.0, -1.0)};
    EXPECT_LE(largest_error(math::log, std::log, positives), 0.51);
    EXPECT_LE(largest_error(math::log10, std::log10, positives), 0.51);
}

TEST(Elementary, PowersAreRight) {
    EXPECT_LE(largest_error(math::pow, std::pow, positive(of_size(-1022.0, 1024.0)),
                            exponents(-1021.9, 1023.9)),
              0.55);
    EXPECT_LE(largest_error(math::pow, std::pow, near_one(-50.0, -2.0), exponents(-1021.9, 1023.9)),
              0.55);
    EXPECT_LE(largest_error(math::pow, std::pow, positive(of_size(-20.0, 20.0)),
                            [](Random& random, double) { return random.uniform(-4.0, 4.0); }),
              0.55);
    EXPECT_LE(largest_error(math::pow, std::pow, positive(of_size(-1022.0, 1024.0)),
                            exponents(-1074.0, -1022.0)),
              0.77)
        << "subnormal";
}

TEST(Elementary, RootsAreRight) {
    EXPECT_LE(largest_error(math::cbrt, std::cbrt, {between(1.0, 8.0), of_size(-1074.0, 1024.0)}),
              0.51);
    EXPECT_LE(largest_error(math::hypot, std::hypot, of_size(-400.0, 400.0),
                            [](Random& random, double x) {
                                return x * std::exp2(random.uniform(-30.0, 30.0));
                            }),
              1.25);
}

TEST(Elementary, WholePowersAndLogarithmsOfTenAreExact) {
    for (int n = -300; n <= 300; ++n) {
        EXPECT_EQ(math::log10(std::stod("1e" + std::to_string(n))), n);
    }
    for (int n = 0; n <= 22; ++n) {
        EXPECT_EQ(math::pow(10.0, n), std::stod("1e" + std::to_string(n)));
    }
    for (int n = -1074; n <= 1023; ++n) EXPECT_EQ(math::pow(2.0, n), std::ldexp(1.0, n));
    for (int n = 1; n <= 200'000; n += 7) {
        EXPECT_EQ(math::cbrt(static_cast<double>(n) * n * n), n);
    }
    EXPECT_EQ(math::pow(-3.0, 3.0), -27.0);
    EXPECT_EQ(math::pow(-3.0, 4.0), 81.0);
}

/// What the C standard says about special arguments, signs of zeros included.
void expect_same(double result, double expected, const std::string& what) {
    if (std::isnan(expected)) {
        EXPECT_TRUE(std::isnan(result)) << what;
    } else {
        EXPECT_EQ(result, expected) << what;
        EXPECT_EQ(std::signbit(result), std::signbit(expected)) << what;
    }
}

TEST(Elementary, SpecialArgumentsGiveWhatTheStandardSays) {
    using Function = double (*)(double);
    struct Pair {
        const char* name;
        Function ours, standard;
    };
    const std::vector<Pair> functions = {
        {"sin", math::sin, std::sin},    {"cos", math::cos, std::cos},
        {"asin", math::asin, std::asin}, {"acos", math::acos, std::acos},
        {"atan", math::atan, std::atan}, {"exp", math::exp, std::exp},
        {"log", math::log, std::log},    {"log10", math::log10, std::log10},
        {"cbrt", math::cbrt, std::cbrt}};
    const std::vector<double> special = {0.0,      1.0,
                                         infinity, nan,
                                         5e-324,   std::numeric_limits<double>::min(),
                                         2.0,      std::numeric_limits<double>::max(),
                                         800.0,    0x1p-30,
                                         0x1p-60};
    for (const Pair& f : functions) {
        for (const double x : special) {
            for (const double sign : {1.0, -1.0}) {
                const double expected = f.standard(sign * x);
                const double result = f.ours(sign * x);
                const auto what = std::string(f.name) + " " + std::to_string(sign * x);
                const bool is_exact = expected == 0.0 || !std::isfinite(expected);
                if (is_exact) {
                    expect_same(result, expected, what);
                } else {
                    EXPECT_LE(error_in_ulp(result, expected), 1.0) << what;
                }
            }
        }
    }
}

TEST(Elementary, SpecialPairsGiveWhatTheStandardSays) {
    const std::vector<double> special = {0.0, 1.0, 2.0, 3.0, 0.5, infinity, nan, 5e-324, 1e300};
    for (const double a : special) {
        for (const double b : special) {
            for (int signs = 0; signs < 4; ++signs) {
                const double x = (signs & 1) != 0 ? -a : a;
                const double y = (signs & 2) != 0 ? -b : b;
                const auto what = std::to_string(x) + " " + std::to_string(y);
                const double angle = std::atan2(y, x);
                const double power = std::pow(x, y);
                expect_same(math::atan2(y, x), angle, "atan2 " + what);
                if (power == 0.0 || !std::isfinite(power)) {
                    expect_same(math::pow(x, y), power, "pow " + what);
                } else {
                    EXPECT_LE(error_in_ulp(math::pow(x, y), power), 1.0) << what;
                }
            }
        }
    }
}

// The bits are part of every trajectory and template: another compiler, another processor or a
// change of a coefficient that moves one of them shows here.
TEST(Elementary, BitsAreThoseOfEveryOtherBuild) {
    StateHash hash;
    const auto add = [&](double value) { hash.add(std::span<const double>(&value, 1)); };
    Random random(20, 0);
    for (int n = 0; n < samples; ++n) {
        // Scaled by exact powers: no function of the C library makes the arguments.
        const double x = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(n % 64) - 32);
        const double size = std::abs(x);
        const double unit = random.uniform(-1.0, 1.0);
        add(math::sin(x));
        add(math::cos(std::ldexp(x, 300)));
        add(math::asin(unit));
        add(math::acos(unit));
        add(math::atan2(unit, x));
        add(math::exp(0x1p-24 * x));
        add(math::log(size));
        add(math::log10(size));
        add(math::pow(size, 8.0 * unit));
        add(math::cbrt(x));
        add(math::hypot(x, unit));
    }
    EXPECT_EQ(hash.value(), 14930421956161746518ULL);
}

}  // namespace
}  // namespace dem
