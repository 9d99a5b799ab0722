// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/aabb.hpp"

#include <array>
#include <cstddef>

namespace dem::shapegen {

/// (i, j, k) along x, y, z.
using Voxel = std::array<int, 3>;

/// Cubes in rows along x, rows in layers of equal z. The outermost voxels on all six sides are a
/// border that never belongs to a shape, so that neighborhoods need no range checks.
struct VoxelGrid {
    Vec3 origin = Vec3::Zero();  ///< center of voxel (0, 0, 0), which is on the border [m]
    double spacing = 1.0;        ///< edge of a voxel [m]
    std::array<int, 3> size{};   ///< voxels along each axis, the border included

    double coordinate(int axis, int i) const { return origin[axis] + spacing * i; }
    Vec3 center(const Voxel& v) const {
        return {coordinate(0, v[0]), coordinate(1, v[1]), coordinate(2, v[2])};
    }
    bool operator==(const VoxelGrid&) const = default;
};

/// The smallest grid that has every lattice point of the box inside its border; the box and the
/// grid share their center, so that what is symmetric stays so. Throws Error when the spacing is
/// not positive or so small that an image would need more than 2 GB.
VoxelGrid enclosing_grid(const Aabb& box, double spacing);

/// Edge of a voxel [m] for `per_diameter` of them along the diameter of the sphere of the same
/// volume [m^3], d_eq / N in [MS 2.1].
double voxel_spacing(double volume, double per_diameter);

}  // namespace dem::shapegen
