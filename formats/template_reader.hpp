// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace dem {

/// Maps a `.tpl` file, verifies all of it and returns its content; the arrays lie in the map and
/// keep it alive. After this nothing needs to be checked again. Throws Error naming the file, and
/// the shape where it is one: missing, a directory, not a template, another format version,
/// truncated, damaged, a value out of range.
TemplateFile read_template(const std::filesystem::path& path);

/// The same for bytes in memory, aligned to 8; the arrays share `owner`. `where` names them in
/// messages.
TemplateFile read_template(const std::shared_ptr<const void>& owner,
                           std::span<const std::byte> bytes, const std::string& where);

}  // namespace dem
