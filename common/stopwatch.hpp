// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace dem {

/// Adds the time that it lives to a sum [s], by a clock that never goes back.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum), start_(Clock::now()) {}
    ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& sum_;
    Clock::time_point start_;
};

}  // namespace dem
