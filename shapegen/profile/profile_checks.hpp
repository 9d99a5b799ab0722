// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/piece_tree.hpp"

#include <span>
#include <string>

namespace dem::shapegen {

/// What can be said of the segments before anything is built on them: there are some, their ends
/// are finite, each has a length, they join, the first starts and the last ends on the axis, from
/// the lower end to the upper one. Throws Error(label of the segment, ...).
void check_path(std::span<const ProfileSegment> segments, std::span<const std::string> labels);

/// What needs the pieces: the profile stays at r > 0 between its ends, does not fold back on
/// itself, does not cross or touch itself, and encloses an area. `size`: l [m]. Throws Error.
void check_shape(std::span<const ProfileSegment> segments, std::span<const std::string> labels,
                 const PieceTree& tree, double size);

}  // namespace dem::shapegen
