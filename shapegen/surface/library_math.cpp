// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's headers call functions of the C library, whose bits depend on the processor, on the way to
// a template. The linker's --wrap (CMakeLists.txt) gives them ours; a test reads what the finished
// program still takes from the C library.
#include "common/math/elementary.hpp"

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the linker's names.
extern "C" {
double __wrap_sin(double x);
double __wrap_cos(double x);
void __wrap_sincos(double x, double* sine, double* cosine);
double __wrap_asin(double x);
double __wrap_acos(double x);
double __wrap_atan(double x);
double __wrap_atan2(double y, double x);
double __wrap_exp(double x);
double __wrap_log(double x);
double __wrap_log10(double x);
double __wrap_pow(double x, double y);
double __wrap_cbrt(double x);

double __wrap_sin(double x) {
    return dem::math::sin(x);
}
double __wrap_cos(double x) {
    return dem::math::cos(x);
}
/// What the compiler makes of a sine and a cosine of one angle.
void __wrap_sincos(double x, double* sine, double* cosine) {
    const dem::math::SineCosine both = dem::math::sin_cos(x);
    *sine = both.sine;
    *cosine = both.cosine;
}
double __wrap_asin(double x) {
    return dem::math::asin(x);
}
double __wrap_acos(double x) {
    return dem::math::acos(x);
}
double __wrap_atan(double x) {
    return dem::math::atan(x);
}
double __wrap_atan2(double y, double x) {
    return dem::math::atan2(y, x);
}
double __wrap_exp(double x) {
    return dem::math::exp(x);
}
double __wrap_log(double x) {
    return dem::math::log(x);
}
double __wrap_log10(double x) {
    return dem::math::log10(x);
}
double __wrap_pow(double x, double y) {
    return dem::math::pow(x, y);
}
double __wrap_cbrt(double x) {
    return dem::math::cbrt(x);
}
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
