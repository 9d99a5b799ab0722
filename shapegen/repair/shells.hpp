// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"
#include "shapegen/repair/repair_report.hpp"

#include <vector>

namespace dem::shapegen {

/// What to do about several shells in one file.
struct ShellOptions {
    double limit = 0.01;        ///< separate pieces of less than this fraction are left out
    bool keep_largest = false;  ///< leave out all but the largest body, whatever their size
};

/// One body with its hollows, outward, from closed oriented shells that do not cross. A shell
/// inside an odd number of others is a hollow of the smallest of them and faces into itself; any
/// other is a body. Returns an empty list or the separate bodies that were refused.
std::vector<Finding> keep_one_body(TriangleMesh& mesh, const ShellOptions& options,
                                   RepairReport& report);

}  // namespace dem::shapegen
