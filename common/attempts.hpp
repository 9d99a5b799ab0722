// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

namespace dem {

/// Things to be done one after another, each of them whatever becomes of those before.
class Attempts {
  public:
    template <class Task>
    void make(const Task& task) {
        try {
            task();
        } catch (...) {
            if (!first_failure_) first_failure_ = std::current_exception();
        }
    }

    /// Throws what the first of them that failed threw.
    void check() const {
        if (first_failure_) std::rethrow_exception(first_failure_);
    }

  private:
    std::exception_ptr first_failure_;
};

}  // namespace dem
