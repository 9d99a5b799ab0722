// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"

#include <cmath>

namespace dem::test {

/// Between low and high, both positive, all ratios alike.
inline double log_uniform(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

}  // namespace dem::test
