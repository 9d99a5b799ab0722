// SPDX-License-Identifier: BSD-3-Clause
#include "common/math/types.hpp"
#include "formats/template_check.hpp"
#include "formats/value_check.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

constexpr std::uint32_t deepest_level = 12;  // 4096 children along the edge of a base cell
/// Numbers of a distance field, in bounding radii: their products stay far from overflow.
constexpr double largest_number = 1e6;

void check_dimensions(const SrShape& shape, double bounding_radius, double volume,
                      const ValueCheck& check) {
    check.positive(shape.bounding_radius, "bounding radius");
    check.require(shape.bounding_radius == bounding_radius, "the two bounding radii differ");
    check.finite(shape.bottom_z, "bottom");
    check.finite(shape.top_z, "top");
    check.positive(shape.max_radius, "largest radius");
    check.positive(shape.equivalent_diameter, "equivalent diameter");
    check.positive(shape.major_axis_length, "major axis length");
    check.require(shape.bottom_z < shape.top_z, "the bottom does not lie below the top");
    const double limit = bounding_radius * check.slack;
    check.require(-shape.bottom_z <= limit && shape.top_z <= limit && shape.max_radius <= limit,
                  "the profile reaches beyond the bounding radius");
    check.require(std::abs(pi / 6.0 * cube(shape.equivalent_diameter) - volume) <= 1e-6 * volume,
                  "the equivalent diameter does not belong to the volume");
    check.require(shape.major_axis_length <= 2.0 * limit &&
                      shape.major_axis_length * check.slack >= 2.0 * shape.max_radius,
                  "the major axis length does not belong to the profile");
}

void check_support_map(const SupportMap& map, bool is_convex, const ValueCheck& check) {
    check.require(map.pieces.empty() != is_convex,
                  "a convex shape needs a support map, another has none");
    check.require(map.piece_end.size() == map.pieces.size(),
                  "the pieces of the support map and their ends differ in number");
    if (map.pieces.empty()) {
        check.require(map.first_piece.empty(), "the support map has an index of no pieces");
        return;
    }
    for (const SupportPiece& p : map.pieces) {
        check.finite(p.center_r, "center of a support piece");
        check.finite(p.center_z, "center of a support piece");
        check.not_negative(p.a, "semi-axis of a support piece");
        check.not_negative(p.b, "semi-axis of a support piece");
        check.require((p.a == 0.0) == (p.b == 0.0), "a support piece has one semi-axis of zero");
    }
    double last = -1.0;
    for (const double end : map.piece_end) {
        check.require(end >= last && end <= 1.0, "the ends of the support pieces do not rise");
        last = end;
    }
    check.require(last == 1.0, "the support pieces do not reach the top");

    check.require(map.first_piece.size() >= 2, "the support map has no index");
    const auto buckets = static_cast<double>(map.first_piece.size() - 1);
    std::uint32_t previous = 0;
    for (std::size_t k = 0; k + 1 < map.first_piece.size(); ++k) {
        const std::uint32_t first = map.first_piece[k];
        check.require(first < map.pieces.size() && first >= previous,
                      "the index of the support map is out of range");
        // The search goes up only: a start above the piece it looks for would miss it.
        const double bucket_start = 2.0 * static_cast<double>(k) / buckets - 1.0;
        check.require(first == 0 || map.piece_end[first - 1] <= bucket_start + 1e-12,
                      "the index of the support map skips a piece");
        previous = first;
    }
    check.require(map.first_piece.back() <= map.pieces.size() && map.first_piece.back() >= previous,
                  "the index of the support map is out of range");
}

void check_sdf(const SdfQuadtree& sdf, const SrShape& shape, const ValueCheck& check) {
    check.finite(sdf.origin_r, "origin of the distance field");
    check.finite(sdf.origin_z, "origin of the distance field");
    check.positive(sdf.base_size, "cell size of the distance field");
    check.not_negative(sdf.margin, "margin of the distance field");
    check.not_negative(sdf.lipschitz_slack, "slack of the distance field");
    check.not_negative(sdf.surface_slack, "slack of the distance field near the surface");
    check.not_negative(sdf.surface_band, "band of the distance field");
    const double most = largest_number * shape.bounding_radius;
    for (const double length : {sdf.origin_r, sdf.origin_z, sdf.base_size, sdf.margin,
                                sdf.surface_slack, sdf.surface_band}) {
        check.require(std::abs(length) <= most, "the distance field is too large for the body");
    }
    check.require(sdf.lipschitz_slack <= largest_number,
                  "the slack of the distance field is too large");
    const std::uint64_t cells = std::uint64_t{sdf.cells_r} * sdf.cells_z;
    check.require(cells > 0 && cells == sdf.cells.size(),
                  "the distance field's cells do not match its grid");
    // Half a cell of doubt: a point outside is moved to the grid's edge.
    const double margin = 0.5 * sdf.base_size;
    const double right = sdf.origin_r + sdf.cells_r * sdf.base_size;
    const double above = sdf.origin_z + sdf.cells_z * sdf.base_size;
    check.require(sdf.origin_r <= 0.0 && right >= shape.max_radius - margin &&
                      sdf.origin_z <= shape.bottom_z + margin && above >= shape.top_z - margin,
                  "the distance field does not cover the profile");
    for (const SdfCell& cell : sdf.cells) {
        check.require(cell.level <= deepest_level, "a cell of the distance field is too deep");
        const std::uint64_t corners = (std::uint64_t{1} << cell.level) + 1;
        check.require(cell.first_value + corners * corners <= sdf.values.size(),
                      "a cell of the distance field has no values");
    }
    for (const double value : sdf.values) {
        check.finite(value, "distance");
        check.require(std::abs(value) <= most, "a distance is too large for the body");
    }
}

void check_curvature(const SrShape& shape, const ValueCheck& check) {
    check.require(shape.curvature.size() >= 2, "the curvature table has less than two samples");
    const double limit = shape.bounding_radius * check.slack;
    double last = 0.0;
    for (const CurvatureSample& s : shape.curvature) {
        check.finite(s.mean_curvature, "curvature");
        check.finite(s.arc_length, "arc length");
        check.require(s.arc_length >= last, "the arc length of the curvature table does not rise");
        check.require(s.r >= -1e-9 * limit && s.r * s.r + s.z * s.z <= limit * limit,
                      "a sample of the curvature table lies off the profile");
        last = s.arc_length;
    }
}

bool holds(const SurfaceNodes::Ball& ball, const SurfaceNodes::Node& node) {
    const double distance = Vec3(node.x - ball.x, node.y - ball.y, node.z - ball.z).norm();
    return distance <= ball.radius * (1.0 + 1e-9);
}

void check_nodes(const SurfaceNodes& nodes, double bounding_radius, const ValueCheck& check) {
    constexpr std::uint64_t block = SurfaceNodes::block_size;
    const std::uint64_t blocks = (std::uint64_t{nodes.count} + block - 1) / block;
    check.require(nodes.nodes.size() == blocks * block && nodes.blocks.size() == blocks &&
                      nodes.super_blocks.size() == (blocks + 15) / 16 &&
                      nodes.stencil.size() == std::uint64_t{nodes.count} * nodes.stencil_size,
                  "the numbers of surface nodes, blocks and neighbors do not match");
    const double limit = square(bounding_radius * check.slack);
    for (const auto& ball : nodes.blocks) check.not_negative(ball.radius, "radius of a block");
    for (const auto& ball : nodes.super_blocks)
        check.not_negative(ball.radius, "radius of a block");
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
        const SurfaceNodes::Node& node = nodes.nodes[i];
        check.finite(node.mean_curvature, "curvature");
        check.require(square(node.x) + square(node.y) + square(node.z) <= limit,
                      "a surface node lies outside the bounding radius");
        check.require(
            holds(nodes.blocks[i / block], node) && holds(nodes.super_blocks[i / block / 16], node),
            "a surface node lies outside the bounding sphere of its block");
        const SurfaceNodes::Node& last = nodes.nodes[nodes.count - 1];
        check.require(i < nodes.count || (node.x == last.x && node.y == last.y && node.z == last.z),
                      "the last block of surface nodes is not filled with its last node");
    }
    for (const std::uint32_t neighbor : nodes.stencil) {
        check.require(neighbor < nodes.count, "a surface node has a neighbor that does not exist");
    }
}

}  // namespace

void check_sr_shape(const SrShape& shape, double bounding_radius, double volume,
                    const std::string& where) {
    const ValueCheck check{where};
    check_dimensions(shape, bounding_radius, volume, check);
    check_support_map(shape.support, shape.is_convex, check);
    check_sdf(shape.sdf, shape, check);
    check_curvature(shape, check);
    check.require(shape.is_convex || shape.nodes.count > 0,
                  "a shape that is not convex has no surface nodes");
    check_nodes(shape.nodes, bounding_radius, check);
}

}  // namespace dem
