// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/case/case_file.hpp"
#include "runtime/scene.hpp"

namespace dem::runtime {

/// Makes the scene a case file describes: every section and key known, every value in range, every
/// material, template and table there, every pair of materials that can meet with its law, every
/// region on the right side of the walls. `Scene::output.directory` is left to the caller.
/// Throws Error with file and line.
Scene read_scene(const CaseFile& file);

}  // namespace dem::runtime
