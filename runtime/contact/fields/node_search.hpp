// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/sr_shape.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

/// Which nodes of a body lie inside a distance field ([SR] Sec. 2.4): the same ones, in rising
/// order, as a walk over all nodes finds, by two means that skip most of them:
///
/// - Branch and bound over the blocks of nodes. A distance grows no faster than the way walked, so
///   no node of a block with bounding ball (c, R) is nearer than distance(c) - R - slack. Where a
///   field knows a plane that it lies behind, blocks and nodes are first held against that.
/// - A list of the nodes within `margin` of the field, kept from an earlier step. As long as the
///   points of the two bodies have moved by less than the margin relative to each other, every
///   node that touches is in the list.
///
/// Neither changes a bit of the result: each node that may touch is evaluated by the same formula.
namespace dem::runtime {

/// What a pair remembers about the nodes that touch next. All zero: nothing is known. Owned by the
/// host; may be dropped at any time. Only valid for the two bodies it was written for, with the
/// master's nodes, and with `travel` counted on from where it was.
struct NearCache {
    static constexpr std::uint32_t capacity = 24;

    /// No node touches while `travel` is less than this [m]: until then the host need not call the
    /// kernel. `travel` bounds the path walked by any point of either body, one added to the other,
    /// since some fixed time: it never falls, and no point of one body has come nearer to a point
    /// of the other by more than its increase.
    double clear_until = 0.0;
    /// Every node that touches is listed while `travel` is less than this [m].
    double listed_until = 0.0;
    std::uint32_t count = 0;
    std::array<std::uint32_t, capacity> nodes{};  ///< in rising order
};
static_assert(std::is_trivially_copyable_v<NearCache>);

/// Calls visit(node, sample) for every node nearer than `margin`, in rising order. Returns a lower
/// bound of the distance of all others [m].
template <class Field, class Visit>
double visit_near_nodes(const SurfaceNodes& nodes, const Field& field, double margin,
                        Visit&& visit) {
    constexpr std::uint32_t fan = SurfaceNodes::block_size;
    double others = std::numeric_limits<double>::infinity();
    const auto can_skip = [&](const SurfaceNodes::Ball& ball) {
        const Vec3 center(ball.x, ball.y, ball.z);
        double bound = field.floor(center) - ball.radius;
        if (bound < margin) bound = field.sample(center).distance - ball.radius - field.slack;
        if (bound < margin) return false;
        others = std::min(others, bound);
        return true;
    };
    const auto blocks = static_cast<std::uint32_t>(nodes.blocks.size());
    for (std::uint32_t s = 0; s < nodes.super_blocks.size(); ++s) {
        if (can_skip(nodes.super_blocks[s])) continue;
        const std::uint32_t blocks_end = std::min(fan * (s + 1), blocks);
        for (std::uint32_t b = fan * s; b < blocks_end; ++b) {
            if (can_skip(nodes.blocks[b])) continue;
            const std::uint32_t nodes_end = std::min(fan * (b + 1), nodes.count);
            for (std::uint32_t k = fan * b; k < nodes_end; ++k) {
                const SurfaceNodes::Node& node = nodes.nodes[k];
                const Vec3 x(node.x, node.y, node.z);
                const double floor = field.floor(x);
                if (floor >= margin) {
                    others = std::min(others, floor);
                    continue;
                }
                const auto sample = field.sample(x);
                if (sample.distance < margin)
                    visit(k, sample);
                else
                    others = std::min(others, sample.distance);
            }
        }
    }
    return others;
}

/// Fills a NearCache with the nearest nodes of a search, in rising order.
class NodeListBuilder {
  public:
    explicit NodeListBuilder(NearCache& cache) : cache_(cache) { cache_.count = 0; }

    void add(std::uint32_t node, double distance) {
        nearest_ = std::min(nearest_, distance);
        if (distance >= reach_) return;
        if (cache_.count == NearCache::capacity) drop_farthest();
        if (distance >= reach_) return;
        cache_.nodes[cache_.count] = node;
        distances_[cache_.count] = distance;
        ++cache_.count;
    }

    /// `others`: lower bound of the distance of nodes never added.
    template <class Field>
    void finish(double others, const Field& field, double travel) {
        cache_.listed_until = travel + field.proven_gap(std::min(reach_, others));
        cache_.clear_until = travel + field.proven_gap(std::min(nearest_, others));
    }

  private:
    /// From now on only nodes nearer than the one dropped are listed. Once that one touches, no
    /// list of this size is complete and the rest need not be looked at.
    void drop_farthest() {
        std::uint32_t farthest = 0;
        for (std::uint32_t k = 1; k < cache_.count; ++k)
            if (distances_[k] > distances_[farthest]) farthest = k;
        reach_ = distances_[farthest];
        if (reach_ < 0.0) reach_ = -std::numeric_limits<double>::infinity();
        std::copy(cache_.nodes.begin() + farthest + 1, cache_.nodes.begin() + cache_.count,
                  cache_.nodes.begin() + farthest);
        std::copy(distances_.begin() + farthest + 1, distances_.begin() + cache_.count,
                  distances_.begin() + farthest);
        --cache_.count;
    }

    NearCache& cache_;
    std::array<double, NearCache::capacity> distances_{};
    double reach_ = std::numeric_limits<double>::infinity();
    double nearest_ = std::numeric_limits<double>::infinity();
};

/// Calls visit(node, sample) for every node that touches (distance < 0 and accepted), in rising
/// order, through the list while it is complete, otherwise by a search that makes a new list of
/// the nodes within `margin` [m].
template <class Field, class Visit>
void visit_touching_nodes(const SurfaceNodes& nodes, const Field& field, double margin,
                          double travel, NearCache& cache, Visit&& visit) {
    const auto visit_if_touching = [&](std::uint32_t k, const auto& sample) {
        const SurfaceNodes::Node& node = nodes.nodes[k];
        if (sample.distance < 0.0 && field.accepts({node.x, node.y, node.z})) visit(k, sample);
    };
    if (travel < cache.listed_until) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t n = 0; n < cache.count; ++n) {
            const SurfaceNodes::Node& node = nodes.nodes[cache.nodes[n]];
            const auto sample = field.sample({node.x, node.y, node.z});
            nearest = std::min(nearest, sample.distance);
            visit_if_touching(cache.nodes[n], sample);
        }
        cache.clear_until = std::min(cache.listed_until, travel + field.proven_gap(nearest));
        return;
    }
    NodeListBuilder list(cache);
    const double others =
        visit_near_nodes(nodes, field, margin, [&](std::uint32_t k, const auto& sample) {
            list.add(k, sample.distance);
            visit_if_touching(k, sample);
        });
    list.finish(others, field, travel);
}

}  // namespace dem::runtime
