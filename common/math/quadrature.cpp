// SPDX-License-Identifier: BSD-3-Clause
#include "common/math/quadrature.hpp"

#include "common/math/elementary.hpp"

namespace dem {
namespace {

GaussRule make_gauss_rule() {
    GaussRule rule{};
    constexpr auto n = static_cast<int>(GaussRule::size);
    for (int i = 0; i < n; ++i) {
        double x = math::cos(pi * (i + 0.75) / (n + 0.5));
        double slope = 0.0;
        for (int iteration = 0; iteration < 10; ++iteration) {
            double p = 1.0;
            double previous = 0.0;
            for (int k = 1; k <= n; ++k) {
                const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * previous) / k;
                previous = p;
                p = next;
            }
            slope = n * (x * p - previous) / (x * x - 1.0);
            x -= p / slope;
        }
        const auto k = static_cast<std::size_t>(i);
        rule.node[k] = x;
        rule.weight[k] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
    return rule;
}

}  // namespace

const GaussRule& gauss_rule() {
    static const GaussRule rule = make_gauss_rule();
    return rule;
}

}  // namespace dem
