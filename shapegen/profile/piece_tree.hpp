// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_piece.hpp"

#include <optional>
#include <span>
#include <vector>

namespace dem::shapegen {

/// A binary tree of boxes over the pieces of a path, in the order of the path: neighbors along the
/// path are neighbors in the plane, so no sorting is needed.
class PieceTree {
  public:
    PieceTree() = default;
    explicit PieceTree(const std::vector<ProfileSegment>& segments);

    std::span<const ProfilePiece> pieces() const { return pieces_; }

    ProfilePoint nearest(std::span<const ProfileSegment> segments, const Vec2& x) const;

    /// Two places of the path that come closer than `tolerance` without being joined there.
    struct Meeting {
        std::size_t first_segment, second_segment;
        Vec2 point;
    };
    std::optional<Meeting> find_meeting(std::span<const ProfileSegment> segments,
                                        double tolerance) const;

  private:
    struct Node {
        Vec2 lower, upper;
        std::uint32_t first, last;  ///< pieces [first, last)
        std::uint32_t right;        ///< the second child; the first one follows; 0 for a leaf
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t last);
    double squared_distance(const Node& node, const Vec2& x) const;
    std::optional<Meeting> meeting_within(std::span<const ProfileSegment> segments,
                                          std::uint32_t node, double tolerance) const;
    std::optional<Meeting> meeting_between(std::span<const ProfileSegment> segments,
                                           std::uint32_t a, std::uint32_t b,
                                           double tolerance) const;
    std::optional<Meeting> meeting_of_pieces(std::span<const ProfileSegment> segments,
                                             std::uint32_t i, std::uint32_t k,
                                             double tolerance) const;

    std::vector<ProfilePiece> pieces_;
    std::vector<Node> nodes_;
};

}  // namespace dem::shapegen
