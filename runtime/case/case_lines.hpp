// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/case/case_file.hpp"

#include <string>
#include <vector>

namespace dem::runtime {

/// What decides the motion of a case's bodies, one line per value in the order of the file:
/// "[contact] friction = 0.3", and for a value that names a file a line with the hash of what the
/// file holds. A run can be resumed while these lines stay the same; the end, the number of
/// threads, the skin and the outputs are left out.
std::vector<std::string> case_lines(const CaseFile& file);

}  // namespace dem::runtime
