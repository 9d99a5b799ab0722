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
        if (!will_be_due(time)) return false;
        next_ = intervals(time) + 1.0;
        return true;
    }
    /// What is_due() would say.
    bool will_be_due(double time) const { return every_ > 0.0 && intervals(time) >= next_; }

  private:
    double intervals(double time) const { return std::floor(time / every_ * (1.0 + 1e-12) + 1e-9); }

    double every_;
    double next_ = 0.0;
};

}  // namespace dem::runtime
