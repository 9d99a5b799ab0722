// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/surface_nodes.hpp"

#include "shapegen/revolution/enclosing_ball.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace dem::shapegen {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeEntry = std::pair<TreePoint, std::uint32_t>;
using Order = std::vector<std::uint32_t>;

constexpr std::size_t block = SurfaceNodes::block_size;
constexpr std::size_t super_block = 16 * block;

/// Sorts order[first, last) so that every aligned run of `block` and of `super_block` is compact.
/// Ties are broken by the index: the result depends on the points alone.
void bisect(const std::vector<Vec3>& points, Order& order, std::size_t first, std::size_t last) {
    const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t n = last - first;
    if (n <= block) {
        std::sort(at(first), at(last));
        return;
    }
    Vec3 low = points[order[first]];
    Vec3 high = low;
    for (std::size_t i = first; i < last; ++i) {
        low = low.cwiseMin(points[order[i]]);
        high = high.cwiseMax(points[order[i]]);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t unit = n > super_block ? super_block : block;
    const std::size_t units = (n + unit - 1) / unit;
    const std::size_t middle = first + units / 2 * unit;
    std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
        const double x = points[a][axis];
        const double y = points[b][axis];
        return x != y ? x < y : a < b;
    });
    bisect(points, order, first, middle);
    bisect(points, order, middle, last);
}

/// Enclosing balls of runs of `size` points.
std::vector<SurfaceNodes::Ball> balls(const std::vector<Vec3>& points, std::size_t size) {
    std::vector<SurfaceNodes::Ball> result;
    for (std::size_t first = 0; first < points.size(); first += size) {
        const std::size_t n = std::min(size, points.size() - first);
        result.push_back(enclosing_ball(std::span(points).subspan(first, n)));
    }
    return result;
}

std::vector<std::uint32_t> nearest_nodes(const std::vector<Vec3>& points) {
    constexpr unsigned wanted = SurfaceNodes::stencil_size;
    std::vector<TreeEntry> entries;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        entries.emplace_back(TreePoint(points[i].x(), points[i].y(), points[i].z()), i);
    }
    const bg::index::rtree<TreeEntry, bg::index::quadratic<16>> tree(entries);
    std::vector<std::uint32_t> stencil;
    stencil.reserve(points.size() * wanted);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        std::vector<std::pair<double, std::uint32_t>> found;
        const auto query = bg::index::nearest(entries[i].first, wanted + 1);
        for (auto it = tree.qbegin(query); it != tree.qend(); ++it) {
            if (it->second != i) {
                found.emplace_back((points[it->second] - points[i]).squaredNorm(), it->second);
            }
        }
        std::sort(found.begin(), found.end());
        for (unsigned k = 0; k < wanted; ++k) stencil.push_back(found[k].second);
    }
    return stencil;
}

}  // namespace

SurfaceNodes surface_nodes(std::span<const Ring> rings,
                           const std::function<double(const Ring&)>& mean_curvature) {
    const std::vector<Vec3> unordered = ring_points(rings);
    std::vector<double> curvature;
    for (const Ring& ring : rings)
        curvature.insert(curvature.end(), ring.count, mean_curvature(ring));

    Order order(unordered.size());
    std::iota(order.begin(), order.end(), 0);
    bisect(unordered, order, 0, order.size());

    std::vector<Vec3> points;
    std::vector<SurfaceNodes::Node> nodes;
    for (const std::uint32_t i : order) {
        const Vec3& p = unordered[i];
        points.push_back(p);
        nodes.push_back({p.x(), p.y(), p.z(), curvature[i]});
    }
    while (nodes.size() % block != 0) nodes.push_back(nodes.back());

    SurfaceNodes result;
    result.count = static_cast<std::uint32_t>(points.size());
    result.blocks = balls(points, block);
    result.super_blocks = balls(points, super_block);
    result.stencil = nearest_nodes(points);
    result.nodes = std::move(nodes);
    return result;
}

}  // namespace dem::shapegen
