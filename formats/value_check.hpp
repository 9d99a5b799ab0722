// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/error.hpp"
#include "common/math/types.hpp"
#include "formats/number_text.hpp"

#include <cmath>
#include <string>

namespace dem {

/// Conditions on numbers read from a file; what breaks one is reported at `where`.
struct ValueCheck {
    const std::string& where;

    /// Rounding and the crowning of flat faces (3e-5 of the size) may put a point this far beyond a
    /// bound that was computed from the exact shape.
    static constexpr double slack = 1.0 + 1e-4;

    void require(bool holds, const char* what) const {
        if (!holds) throw Error(where, std::string(what) + "; make the template again");
    }
    void finite(double value, const char* name) const {
        if (!std::isfinite(value)) fail(value, name, "a finite number");
    }
    void finite(const Vec3& value, const char* name) const {
        for (int i = 0; i < 3; ++i) finite(value[i], name);
    }
    void positive(double value, const char* name) const {
        if (!(std::isfinite(value) && value > 0.0)) fail(value, name, "a positive number");
    }
    void not_negative(double value, const char* name) const {
        if (!(std::isfinite(value) && value >= 0.0)) fail(value, name, "zero or a positive number");
    }

  private:
    [[noreturn]] void fail(double value, const char* name, const char* expected) const {
        throw Error(where, std::string(name) + " is " + number_text(value) + ", expected " +
                               expected + "; make the template again");
    }
};

}  // namespace dem
