// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/import/load_mesh.hpp"

#include <boost/program_options.hpp>

namespace dem {

/// For `--help` and the parser.
boost::program_options::options_description mesh_options();

/// The options of meshes and the scale of any input. Throws UsageError for a value out of range.
MeshLoadOptions read_mesh_options(const boost::program_options::variables_map& values);

}  // namespace dem
