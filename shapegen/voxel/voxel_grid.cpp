// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/voxel/voxel_grid.hpp"

#include "common/error.hpp"
#include "common/shapes/mass_properties.hpp"

#include <cmath>
#include <sstream>

namespace dem::shapegen {

namespace {

/// 2 GB at one bit a voxel; thinning holds five such images.
constexpr double most_voxels = 0x1p34;

/// What an int can count, with room for the sums made of it.
constexpr double most_along_an_axis = 0x1p30;

}  // namespace

VoxelGrid enclosing_grid(const Aabb& box, double spacing) {
    if (!(spacing > 0.0) || !std::isfinite(spacing)) {
        std::ostringstream message;
        message << "found a spacing of " << spacing << " m, expected a positive length";
        throw Error("voxels", message.str());
    }
    if (box.is_empty()) throw Error("voxels", "found no shape, expected a mesh with triangles");
    const Vec3 extent = box.upper - box.lower;
    const Vec3 inner = (extent / spacing).array().ceil().max(1.0);
    const Vec3 size = inner.array() + 2.0;
    if (!extent.allFinite() || size.prod() > most_voxels || size.maxCoeff() > most_along_an_axis) {
        std::ostringstream message;
        message << "found a spacing of " << spacing << " m for a shape of " << extent.x() << " x "
                << extent.y() << " x " << extent.z() << " m, expected at most " << most_voxels
                << " voxels: use a larger spacing";
        throw Error("voxels", message.str());
    }
    const Vec3 center = 0.5 * (box.lower + box.upper);
    VoxelGrid grid{center - 0.5 * spacing * (size.array() - 1.0).matrix(), spacing, {}};
    for (int axis = 0; axis < 3; ++axis)
        grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(size[axis]);
    return grid;
}

double voxel_spacing(double volume, double per_diameter) {
    return equivalent_diameter(volume) / per_diameter;
}

}  // namespace dem::shapegen
