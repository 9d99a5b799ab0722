// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/voxel/voxel_image.hpp"

#include <ostream>

namespace dem::test {

using namespace shapegen;

/// The Betti numbers of the union of the closed cubes.
struct Topology {
    int components = 0;  ///< connected through faces, edges or corners
    int tunnels = 0;
    int cavities = 0;  ///< of the background, connected through faces

    bool operator==(const Topology&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const Topology& t) {
    return out << t.components << " components, " << t.tunnels << " tunnels, " << t.cavities
               << " cavities";
}

/// Components and cavities by flooding, tunnels from them and the Euler number, for which corners,
/// edges, faces and cubes are counted one by one.
Topology topology(const VoxelImage& image);

}  // namespace dem::test
