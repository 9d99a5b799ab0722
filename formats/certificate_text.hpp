// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace dem {

/// One measured error of a template as a line for a reader: its number with a unit or scale, then
/// what it says. A name that is not known here is shown as it is. The names are those of
/// docs/template-format.md.
std::string certificate_line(const std::string& name, double value);

}  // namespace dem
