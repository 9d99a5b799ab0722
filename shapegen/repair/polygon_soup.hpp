// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dem::shapegen {

/// Faces as a file holds them: of three or more corners each, in no order, nothing promised about
/// closedness, orientation, flatness or shared corners. Corners are in range, points finite.
struct PolygonSoup {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> corners;  ///< of all faces, one after the other
    std::vector<std::size_t> face_ends;  ///< where in `corners` each face ends
    std::vector<std::string> notes;      ///< for the user: what the file holds beside the faces

    std::size_t face_count() const { return face_ends.size(); }
    std::span<const std::uint32_t> face(std::size_t f) const {
        const std::size_t begin = f == 0 ? 0 : face_ends[f - 1];
        return std::span(corners).subspan(begin, face_ends[f] - begin);
    }
    /// The corners since the last face are a face.
    void end_face() { face_ends.push_back(corners.size()); }
};

}  // namespace dem::shapegen
