// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_text.hpp"

namespace dem::shapegen {

/// Whether a word begins a path command (docs/profile-file.md).
bool is_path_command(std::string_view word);
const std::vector<std::string>& path_commands();

/// The segments of a path of commands: start, line, arc, ellipse_arc, curve, bezier, fillet. Throws
/// Error(file:line, ...).
ProfileDraft parse_path(const ProfileText& text);

}  // namespace dem::shapegen
