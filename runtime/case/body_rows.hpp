// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/case/values.hpp"
#include "runtime/files/body_table.hpp"
#include "runtime/scene.hpp"

#include <filesystem>
#include <vector>

namespace dem::runtime {

/// The rows of the table of an `insert = file` group; fills the group's file and count. Throws
/// Error naming the key, or the table and line.
std::vector<BodyRow> read_body_rows(const Values& values, const std::filesystem::path& folder,
                                    InsertionGroup& group);

/// Fills the placements of such a group. Its kinds are those that the rows take in turn, and each
/// once afterwards.
void place_rows(const std::vector<BodyRow>& rows, InsertionGroup& group);

}  // namespace dem::runtime
