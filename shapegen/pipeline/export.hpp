// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"

#include <filesystem>
#include <string>

namespace dem::shapegen {

/// The shape of that name or index; "" is the only one. Throws Error.
const ParticleTemplate& find_shape(const TemplateFile& file, const std::string& where,
                                   const std::string& wanted);

/// Writes a shape in the format that the extension of `path` names: surfaces and tables in the
/// frame of its input, lengths in `unit` [m]. Throws UsageError for an unknown extension, Error
/// when the shape's kind has no such content or the file cannot be written.
void export_shape(const ParticleTemplate& shape, const std::filesystem::path& path, double unit);

}  // namespace dem::shapegen
