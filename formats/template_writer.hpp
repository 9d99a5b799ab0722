// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

#include <filesystem>

namespace flatbuffers {
class DetachedBuffer;
}

namespace dem {

/// Writes a `.tpl` file (docs/template-format.md), whole or not at all. The same content gives the
/// same bytes. Throws Error: a value out of range (check_template), more than the 2 GB that
/// FlatBuffers can address, the disk.
void write_template(const std::filesystem::path& path, const TemplateFile& content);

/// The payload alone, its values unchecked. Throws Error when it would exceed 2 GB.
flatbuffers::DetachedBuffer encode_template(const TemplateFile& content);

}  // namespace dem
