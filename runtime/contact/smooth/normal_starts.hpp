// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/common_normal.hpp"

#include <array>
#include <cstddef>

namespace dem::runtime {

/// Directions n from i to j from which a descent of f (common_normal.hpp) leads to the minima
/// beside a known one.
class NormalStarts {
  public:
    /// `reach`: how far along a surface to look [m].
    explicit NormalStarts(double reach) : reach_(reach) {}

    /// Those that one body offers, along its meridian through its outward normal m: the middle of
    /// the fan of each edge on the way, and the flat or cap behind it, up to the reach to either
    /// side. `sign`: 1 for i, -1 for j.
    void add_meridian(const SrSupport& body, const Vec3& m, double sign);
    /// Those of a tip, or of a face so small that all of its edge is within reach: the surface
    /// beside it against an edge of the other body, a circle about `other_axis` through the same
    /// place. All meridians are as near, and the circle picks them.
    void add_tip(const SrSupport& body, const Vec3& m, double sign, const Vec3& other_axis);
    void add(const Vec3& n) {
        if (count_ < directions_.size()) directions_[count_++] = n.normalized();
    }
    const Vec3* begin() const { return directions_.data(); }
    const Vec3* end() const { return directions_.data() + count_; }

  private:
    double reach_;
    std::array<Vec3, 32> directions_;
    std::size_t count_ = 0;
};

}  // namespace dem::runtime
