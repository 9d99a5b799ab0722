// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/thinning/skeletal_voxels.hpp"

namespace dem::shapegen {

namespace {

/// The neighbors in one direction each: -x, x, -y, y, -z, z.
std::array<Brick, 6> face_neighbors(const BrickView& view, std::ptrdiff_t i) {
    const Brick* b = view.bricks + i;
    return {x_below(*b, b[-1]),
            x_above(*b, b[1]),
            y_below(*b, b[-view.row_stride]),
            y_above(*b, b[view.row_stride]),
            z_below(*b, b[-view.layer_stride]),
            z_above(*b, b[view.layer_stride])};
}

}  // namespace

Brick interior_voxels(const BrickView& x, std::ptrdiff_t i) {
    Brick inside = x[i];
    if (inside == 0) return 0;
    for (const Brick neighbors : face_neighbors(x, i)) inside &= neighbors;
    return inside;
}

Brick surface_ends(const BrickView& x, const BrickView& interior, std::ptrdiff_t i) {
    Brick ends = x[i] & ~interior[i];
    for (const Brick neighbors : face_neighbors(interior, i)) ends &= ~neighbors;
    return ends;
}

Brick curve_ends(const BrickView& x, std::ptrdiff_t i) {
    const Neighborhoods neighbors = neighborhoods(x, i);
    Brick one = 0;
    Brick more = 0;
    for (std::size_t n = 0; n < neighbors.words.size(); ++n) {
        if (n == Neighborhoods::place(Step{})) continue;
        more |= one & neighbors.words[n];
        one |= neighbors.words[n];
    }
    return x[i] & one & ~more;
}

}  // namespace dem::shapegen
