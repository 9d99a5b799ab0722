// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace dem {

/// The shortest text that reads back as the same double; whole numbers below 2^53 in digits only
/// ("1000000", not "1e+06").
std::string number_text(double value);

}  // namespace dem
