// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/piece_tree.hpp"

#include "shapegen/profile/piece_meeting.hpp"

#include <algorithm>
#include <array>

namespace dem::shapegen {
namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

PieceTree::PieceTree(const std::vector<ProfileSegment>& segments) {
    for (std::size_t i = 0; i < segments.size(); ++i)
        append_pieces(segments[i], static_cast<std::uint32_t>(i), pieces_);
    nodes_.reserve(pieces_.size());
    build(0, static_cast<std::uint32_t>(pieces_.size()));
}

std::uint32_t PieceTree::build(std::uint32_t first, std::uint32_t last) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({Vec2::Zero(), Vec2::Zero(), first, last, 0});
    if (last - first <= leaf_size) {
        Vec2 lower = pieces_[first].from;
        Vec2 upper = lower;
        for (std::uint32_t i = first; i < last; ++i) {
            const ProfilePiece& piece = pieces_[i];
            const Vec2 bulge = Vec2::Constant(piece.bulge);
            lower = lower.cwiseMin(piece.from.cwiseMin(piece.to) - bulge);
            upper = upper.cwiseMax(piece.from.cwiseMax(piece.to) + bulge);
        }
        nodes_[index].lower = lower;
        nodes_[index].upper = upper;
        return index;
    }
    const std::uint32_t middle = first + (last - first) / 2;
    const std::uint32_t left = build(first, middle);
    const std::uint32_t right = build(middle, last);
    nodes_[index].lower = nodes_[left].lower.cwiseMin(nodes_[right].lower);
    nodes_[index].upper = nodes_[left].upper.cwiseMax(nodes_[right].upper);
    nodes_[index].right = right;
    return index;
}

double PieceTree::squared_distance(const Node& node, const Vec2& x) const {
    return (x - x.cwiseMax(node.lower).cwiseMin(node.upper)).squaredNorm();
}

ProfilePoint PieceTree::nearest(std::span<const ProfileSegment> segments, const Vec2& x) const {
    ProfilePoint best;
    struct Entry {
        std::uint32_t node;
        double bound2;
    };
    std::array<Entry, 64> stack;  // the tree halves 2^32 pieces at most 32 times
    std::size_t size = 0;
    stack[size++] = {0, 0.0};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (entry.bound2 > best.distance * best.distance) continue;
        const Node& node = nodes_[entry.node];
        if (node.right == 0) {
            for (std::uint32_t i = node.first; i < node.last; ++i)
                improve_nearest(segments[pieces_[i].segment], pieces_[i], x, best);
            continue;
        }
        const Entry left{entry.node + 1, squared_distance(nodes_[entry.node + 1], x)};
        const Entry right{node.right, squared_distance(nodes_[node.right], x)};
        stack[size++] = left.bound2 < right.bound2 ? right : left;
        stack[size++] = left.bound2 < right.bound2 ? left : right;
    }
    return best;
}

std::optional<PieceTree::Meeting> PieceTree::find_meeting(std::span<const ProfileSegment> segments,
                                                          double tolerance) const {
    return meeting_within(segments, 0, tolerance);
}

std::optional<PieceTree::Meeting> PieceTree::meeting_within(
    std::span<const ProfileSegment> segments, std::uint32_t node, double tolerance) const {
    const Node& n = nodes_[node];
    if (n.right == 0) {
        for (std::uint32_t i = n.first; i < n.last; ++i)
            for (std::uint32_t k = i + 1; k < n.last; ++k)
                if (auto found = meeting_of_pieces(segments, i, k, tolerance)) return found;
        return std::nullopt;
    }
    if (auto found = meeting_within(segments, node + 1, tolerance)) return found;
    if (auto found = meeting_within(segments, n.right, tolerance)) return found;
    return meeting_between(segments, node + 1, n.right, tolerance);
}

std::optional<PieceTree::Meeting> PieceTree::meeting_between(
    std::span<const ProfileSegment> segments, std::uint32_t a, std::uint32_t b,
    double tolerance) const {
    const Node& first = nodes_[a];
    const Node& second = nodes_[b];
    if ((first.lower.array() > second.upper.array() + tolerance).any() ||
        (second.lower.array() > first.upper.array() + tolerance).any())
        return std::nullopt;
    if (first.right == 0 && second.right == 0) {
        for (std::uint32_t i = first.first; i < first.last; ++i)
            for (std::uint32_t k = second.first; k < second.last; ++k)
                if (auto found = meeting_of_pieces(segments, i, k, tolerance)) return found;
        return std::nullopt;
    }
    const bool split_first =
        second.right == 0 ||
        (first.right != 0 && first.last - first.first >= second.last - second.first);
    if (split_first) {
        if (auto found = meeting_between(segments, a + 1, b, tolerance)) return found;
        return meeting_between(segments, first.right, b, tolerance);
    }
    if (auto found = meeting_between(segments, a, b + 1, tolerance)) return found;
    return meeting_between(segments, a, second.right, tolerance);
}

std::optional<PieceTree::Meeting> PieceTree::meeting_of_pieces(
    std::span<const ProfileSegment> segments, std::uint32_t i, std::uint32_t k,
    double tolerance) const {
    const ProfilePiece& a = pieces_[i];
    const ProfilePiece& b = pieces_[k];
    const auto point =
        k == i + 1 ? second_meeting_point(segments[a.segment], a, segments[b.segment], b, tolerance)
                   : meeting_point(segments[a.segment], a, segments[b.segment], b, tolerance);
    if (!point) return std::nullopt;
    return Meeting{a.segment, b.segment, *point};
}

}  // namespace dem::shapegen
