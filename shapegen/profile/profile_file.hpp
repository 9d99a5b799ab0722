// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace dem::shapegen {

/// What a profile file holds (docs/profile-file.md): a named shape, a path of commands or a table
/// of points.
struct ProfileFile {
    Profile profile;         ///< [m], in the frame of the file
    std::string name;        ///< of the file, without folder and ending
    std::uint64_t hash = 0;  ///< file_hash() of the file
    double unit = 1.0;       ///< of the file's plain numbers, times the scale [m]
};

/// Reads a file. Ends off the axis are closed by discs, a path from top to bottom is turned round.
/// All lengths are multiplied by `scale`. Throws Error(file:line, ...) for everything that makes no
/// body.
ProfileFile read_profile(const std::string& path, double scale = 1.0);

/// A profile from the text of a file; `path` is for messages and the name.
ProfileFile parse_profile(std::string_view text, const std::string& path, double scale = 1.0);

}  // namespace dem::shapegen
