// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/case/values.hpp"
#include "runtime/scene.hpp"

#include <filesystem>

namespace dem {

/// Fills the placements and the count of an `insert = file` group from its table. The group's kinds
/// are known already; rows take them in turn, or by name where the table has a `template` column.
/// Throws Error naming the key, or the table and line.
void read_body_rows(const Values& values, const std::filesystem::path& folder, const Scene& scene,
                    InsertionGroup& group);

}  // namespace dem
