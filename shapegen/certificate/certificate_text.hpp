// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace dem::shapegen {

/// One measured error of a template as a line for a reader: its number with a unit or scale, then
/// what it says. `length_unit`: of the lengths of this kind of shape, "l" or "d_eq". A name that is
/// not known here is shown as it is. The names are those of docs/template-format.md.
std::string certificate_line(const std::string& name, double value, const char* length_unit);

}  // namespace dem::shapegen
