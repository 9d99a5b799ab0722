// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/shared_array.hpp"

#include <array>
#include <cstdint>
#include <limits>

/// What `shapegen` computes for a surface of revolution (SR) and `demrun` uses. Body frame: origin
/// at the center of mass, axis of revolution = body z; the half cross-section lies in (r, z) with
/// r = sqrt(x^2 + y^2). Arrays of plain types only: they are mapped straight from a template file.
namespace dem {

/// A point of the support map of a convex profile is found in closed form: on the piece whose range
/// of normal angles holds the direction (n_r, n_z), n_r >= 0,
///     x = center + (a^2 n_r, b^2 n_z) / sqrt(a^2 n_r^2 + b^2 n_z^2).
/// a == b is a circular arc, a == b == 0 a corner. Flat bands and faces are arcs of a large radius
/// ("crowned") that turn by 4e-4 rad from end to end.
struct SupportPiece {
    double center_r, center_z;  ///< [m]
    double a, b;                ///< semi-axes along r and z [m]
};

/// Bounds for a whole convex body (support_bounds.hpp). As they are here nothing is known.
struct SupportBounds {
    /// Bounds of the radii of curvature of the surface, in any direction [m].
    double longest_radius = std::numeric_limits<double>::infinity();
    double shortest_radius = 0.0;  ///< 0: the body has an edge or a tip
    /// A ball of this number times s fits into the body and touches its surface at a place, s the
    /// radius of curvature of the meridian there times the change of q (SupportMap), at most 1,
    /// to the end of the piece: on a flat no more than the way to its edge.
    double ball_slope = 0.0;
    double inner_radius = 0.0;  ///< of a ball about the origin inside of the body [m]
};

/// Support map of a convex surface of revolution. Empty for a non-convex one.
/// The direction is measured by q = n_z / (n_r + |n_z|), which rises from -1 (down the axis) to +1
/// and resolves angles near the poles as well as near the equator.
struct SupportMap {
    SharedArray<SupportPiece> pieces;  ///< n, in rising q
    SharedArray<double> piece_end;     ///< n, the largest q of each piece; the last is 1
    SharedArray<std::uint32_t>
        first_piece;       ///< m + 1: bucket k covers q in [2k/m - 1, 2(k+1)/m - 1)
    SupportBounds bounds;  ///< follow from the pieces and are not stored in files
};

/// Signed distance field of the half cross-section on a two-level grid, negative inside
/// ([SR] Sec. 2.3). Base cell (i, k) covers origin + base_size * ([i, i+1], [k, k+1]) and is
/// divided into 2^level x 2^level children; its (2^level + 1)^2 corner values lie at `first_value`,
/// r fastest. Values on the seam between levels are those of the coarser side, so the interpolant
/// is continuous.
struct SdfCell {
    std::uint32_t first_value;
    std::uint32_t level;
};

struct SdfQuadtree {
    /// Corner of base cell (0, 0) [m]. origin_r is minus half an interface cell: the field is even
    /// in r, so the cells that straddle the axis make its gradient continuous there.
    double origin_r = 0.0, origin_z = 0.0;
    double base_size = 0.0;  ///< edge of a base cell [m]
    std::uint32_t cells_r = 0, cells_z = 0;
    double margin = 0.0;         ///< the grid holds every point this near to the cross-section [m]
    SharedArray<SdfCell> cells;  ///< cells_r * cells_z, r fastest
    SharedArray<double> values;  ///< [m]
    /// Bound of |interpolated - exact| wherever the interpolant is positive (only there a search
    /// discards by it), twice the largest measured error [m].
    double lipschitz_slack = 0.0;
    /// Bound of |interpolated - exact| near the surface, much smaller: where |interpolated| <=
    /// surface_band [m].
    double surface_slack = 0.0;
    double surface_band = 0.0;  ///< one interface cell [m]
};

/// One sample of the profile's curvature (arc-length order, bottom to top).
struct CurvatureSample {
    double r, z;            ///< [m]
    double arc_length;      ///< from the bottom end [m]
    double mean_curvature;  ///< H = (kappa_1 + kappa_2)/2 [1/m], positive where convex, clamped
};

/// Surface nodes [SR 2.4], in spatial order in blocks of 16 (the last block repeats its last node).
struct SurfaceNodes {
    static constexpr std::uint32_t block_size = 16;
    static constexpr std::uint32_t stencil_size = 16;

    struct Node {
        double x, y, z;         ///< body frame [m]
        double mean_curvature;  ///< H at the node [1/m], clamped
    };
    struct Ball {
        double x, y, z, radius;  ///< [m]
    };

    std::uint32_t count = 0;             ///< number of different nodes, N
    SharedArray<Node> nodes;             ///< block_size * blocks.size()
    SharedArray<Ball> blocks;            ///< bounding sphere of each block of nodes
    SharedArray<Ball> super_blocks;      ///< bounding sphere of each run of 16 blocks
    SharedArray<std::uint32_t> stencil;  ///< N * stencil_size: the nearest nodes of each node
};

struct SrShape {
    bool is_convex = false;
    double bottom_z = 0.0;             ///< z of the profile's lower end [m]
    double top_z = 0.0;                ///< z of the profile's upper end [m]
    double max_radius = 0.0;           ///< largest distance from the axis [m]
    double bounding_radius = 0.0;      ///< about the center of mass [m]
    double equivalent_diameter = 0.0;  ///< d_eq [m]
    double major_axis_length = 0.0;    ///< l [m]
    SupportMap support;
    SdfQuadtree sdf;
    SharedArray<CurvatureSample> curvature;
    SurfaceNodes nodes;
};

}  // namespace dem
