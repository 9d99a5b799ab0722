// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"

#include <cstddef>
#include <vector>

namespace dem::shapegen {

/// A point of a surface and its outward unit normal.
struct SurfaceSample {
    Vec3 point, normal;
};

/// `count` points that each stand for the same area: one in each stretch of area / count of the
/// triangles laid end to end, at places within the triangle from a low-discrepancy sequence. The
/// same for the same mesh, always.
std::vector<SurfaceSample> surface_samples(const TriangleMesh& mesh, std::size_t count);

}  // namespace dem::shapegen
