// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace dem::runtime {

/// When something that happens every so many seconds is due: at the first step at or after each
/// multiple of the interval, counted in whole numbers so that nothing drifts.
class Cadence {
  public:
    /// 0: never.
    explicit Cadence(double every) : every_(every) {}

    /// True once per multiple of the interval; call after each step, with rising times [s].
    bool is_due(double time) {
        if (every_ <= 0.0) return false;
        const double intervals = std::floor(time / every_ * (1.0 + 1e-12) + 1e-9);
        if (intervals < next_) return false;
        next_ = intervals + 1.0;
        return true;
    }

  private:
    double every_;
    double next_ = 0.0;
};

}  // namespace dem::runtime
