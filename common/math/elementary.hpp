// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// Elementary functions whose bits are the same on every processor: made of + - * / sqrt and of
/// integer operations alone, while those of a C library depend on what the processor can do. What
/// reaches a trajectory or a template calls these; a test finds who calls others. Method and
/// coefficients: docs/elementary-functions.md. The errors given are the largest of 10^7 random
/// arguments, in units in the last place; tests/common/math/elementary_test.cpp holds them. Special
/// arguments give what the C standard says, without floating-point flags.
namespace dem::math {

struct SineCosine {
    double sine, cosine;
};

/// For arguments of any size [rad]. Error 0.78.
double sin(double x);
/// For arguments of any size [rad]. Error 0.79.
double cos(double x);
/// Both, to the bits of sin and cos, for little more than the time of one.
SineCosine sin_cos(double x);

/// In [-pi/2, pi/2]. Error 0.52.
double asin(double x);
/// In [0, pi]. Error 0.51.
double acos(double x);
/// In [-pi/2, pi/2]. Error 0.51.
double atan(double x);
/// Angle of the point (x, y) in [-pi, pi], signed zeros as in C. Error 0.51.
double atan2(double y, double x);

/// Error 0.52; 0.76 where the result is subnormal.
double exp(double x);
/// Error 0.51.
double log(double x);
/// Error 0.51; powers of ten give whole numbers.
double log10(double x);
/// Error 0.52; 0.76 where the result is subnormal.
double pow(double x, double y);

/// Error 0.51.
double cbrt(double x);

/// sqrt(x^2 + y^2) for lengths whose squares are doubles: 1e-150 to 1e150, or zero. Error 1.2.
inline double hypot(double x, double y) {
    return std::sqrt(x * x + y * y);
}

}  // namespace dem::math
