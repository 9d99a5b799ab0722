// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/convex/rounding.hpp"
#include "shapegen/solids/make_convex.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dem::shapegen {

/// What a `.convex` file holds (docs/convex-file.md): a named convex shape, rounded.
struct ConvexFile {
    ConvexSolid solid;
    std::string name;                ///< of the file, without folder and ending
    std::uint64_t hash = 0;          ///< file_hash() of the file
    double unit = 1.0;               ///< of the file's plain numbers, times the scale [m]
    std::vector<std::string> lines;  ///< for the user: points that are no corners
};

/// Reads a file. All its lengths are multiplied by `scale`; `rounding` stands for the file's own
/// where it is given. Throws Error(file:line, ...) for everything that makes no body.
ConvexFile read_convex(const std::string& path, const std::optional<Rounding>& rounding = {},
                       double scale = 1.0);

/// A convex shape from the text of a file; `path` is for messages and the name.
ConvexFile parse_convex(std::string_view text, const std::string& path,
                        const std::optional<Rounding>& rounding = {}, double scale = 1.0);

/// A profile as a convex shape: those named sphere, spheroid, cylinder, disc or spherocylinder.
/// Throws Error for any other and for what is wrong in the file.
ConvexFile read_convex_profile(const std::string& path, const std::optional<Rounding>& rounding,
                               double scale = 1.0);
ConvexFile parse_convex_profile(std::string_view text, const std::string& path,
                                const std::optional<Rounding>& rounding = {}, double scale = 1.0);

}  // namespace dem::shapegen
