// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/walls/pose_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace dem::runtime {

/// Rows of a csv table with the columns t,x,y,z and, all or none, qw,qx,qy,qz, in any order; SI,
/// world frame. Throws Error with file and line: a column that is unknown, missing or given twice,
/// a field that is no finite number, a quaternion whose length is not 1, times that do not rise,
/// less than two rows.
std::vector<PoseTable::Row> parse_pose_rows(std::string_view text, const std::string& where);

std::vector<PoseTable::Row> read_pose_rows(const std::string& path);

}  // namespace dem::runtime
