// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace dem {

/// Gauss-Legendre rule on [-1, 1] with 16 points: exact for polynomials up to degree 31.
struct GaussRule {
    static constexpr std::size_t size = 16;
    std::array<double, size> node;
    std::array<double, size> weight;
};

/// The rule, its nodes found once by Newton's method on the Legendre polynomial.
const GaussRule& gauss_rule();

/// Values integrated together: one pass over a curve gives all of its moments.
template <int N>
using Integrals = Eigen::Array<double, N, 1>;

/// Integral of f over [a, b] by one application of the rule.
template <int N, class F>
Integrals<N> integrate_panel(const F& f, double a, double b) {
    const GaussRule& rule = gauss_rule();
    const double half = 0.5 * (b - a);
    const double middle = 0.5 * (a + b);
    Integrals<N> sum = Integrals<N>::Zero();
    for (std::size_t i = 0; i < GaussRule::size; ++i)
        sum += rule.weight[i] * f(middle + half * rule.node[i]);
    return half * sum;
}

/// Integral of f over [a, b]; a panel is halved until its halves agree with it to 1e-14 of
/// `magnitude` (the integral of |f|), or 40 times, which ends at integrable singularities.
template <int N, class F>
Integrals<N> integrate_refined(const F& f, double a, double b, const Integrals<N>& whole,
                               const Integrals<N>& magnitude, int depth) {
    const double middle = 0.5 * (a + b);
    const Integrals<N> left = integrate_panel<N>(f, a, middle);
    const Integrals<N> right = integrate_panel<N>(f, middle, b);
    if (depth == 0 || ((left + right - whole).abs() <= 1e-14 * magnitude).all())
        return left + right;
    return integrate_refined<N>(f, a, middle, left, magnitude, depth - 1) +
           integrate_refined<N>(f, middle, b, right, magnitude, depth - 1);
}

/// Integral over [a, b] of f, a function of a double that returns Integrals<N>, to about 1e-14 of
/// the integral of |f|.
template <int N, class F>
Integrals<N> integrate(const F& f, double a, double b) {
    const auto absolute = [&f](double t) -> Integrals<N> { return f(t).abs(); };
    const Integrals<N> magnitude = integrate_panel<N>(absolute, a, b).abs();
    return integrate_refined<N>(f, a, b, integrate_panel<N>(f, a, b), magnitude, 40);
}

}  // namespace dem
