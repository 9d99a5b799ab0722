// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/option_values.hpp"
#include "shapegen/import/load_mesh.hpp"

namespace dem::shapegen {

/// The options of meshes and the scale of any input. Throws UsageError for a value out of range.
MeshLoadOptions read_mesh_options(const OptionValues& values);

}  // namespace dem::shapegen
