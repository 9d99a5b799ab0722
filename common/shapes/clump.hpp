// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/shared_array.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// One sphere of a clump, body frame.
struct ClumpSphere {
    double x, y, z;  ///< center [m]
    double radius;   ///< [m]
    /// Mass per unit density that exports give this sphere [m^3]; the shares add up to the volume
    /// of the body. `demrun` takes mass and inertia from the template's MassProperties instead.
    double volume_share;

    Vec3 center() const { return {x, y, z}; }
};

/// A rigid body whose surface is that of a union of spheres [MS]. make_clump() makes one.
struct Clump {
    struct Ball {
        double x, y, z, radius;  ///< [m]

        Vec3 center() const { return {x, y, z}; }
    };
    /// Pairs of spheres of two clumps are numbered with 32 bits.
    static constexpr std::size_t most_spheres = 65535;

    SharedArray<ClumpSphere> spheres;  ///< in spatial order
    /// Bounding balls of the runs of 8 spheres, then of those of 64, and so on up to one of all.
    SharedArray<Ball> balls;
    double largest_radius = 0.0;  ///< of a sphere [m]; follows from them, not stored in files
};

double largest_radius(std::span<const ClumpSphere> spheres);

/// The spheres in spatial order with their bounding balls. Throws Error when there are none or more
/// than Clump::most_spheres.
Clump make_clump(std::vector<ClumpSphere> spheres);

/// The bounding balls of a clump by level: level l >= 1 has one ball for each run of 8^l spheres.
class ClumpLevels {
  public:
    ClumpLevels(std::size_t spheres, std::span<const Clump::Ball> balls) : balls_(balls) {
        for (std::size_t count = spheres; count > 1;) {
            count = (count + 7) / 8;
            first_[++top_] = total_;
            total_ += count;
        }
    }

    std::uint32_t top() const { return top_; }         ///< 0: a single sphere has no ball
    std::size_t ball_count() const { return total_; }  ///< of a complete tree
    /// The ball that holds sphere k at a level.
    const Clump::Ball& ball(std::uint32_t level, std::uint32_t k) const {
        return balls_[first_[level] + (k >> 3 * level)];
    }

  private:
    std::span<const Clump::Ball> balls_;
    std::uint32_t top_ = 0;
    std::size_t total_ = 0;
    std::array<std::size_t, 8> first_{};  ///< 8^6 > Clump::most_spheres
};

/// Calls visit(k) for every sphere, in rising order, but those in balls for which skip(ball) is
/// true. skip is asked from large balls to small ones.
template <class Skip, class Visit>
void visit_spheres(std::span<const ClumpSphere> spheres, const ClumpLevels& levels,
                   const Skip& skip, const Visit& visit) {
    const auto count = static_cast<std::uint32_t>(spheres.size());
    std::uint32_t k = 0;
    while (k < count) {
        // The balls that begin with sphere k.
        std::uint32_t level =
            k == 0 ? levels.top()
                   : std::min(levels.top(), static_cast<std::uint32_t>(std::countr_zero(k)) / 3);
        while (level > 0 && !skip(levels.ball(level, k))) --level;
        if (level == 0) visit(k);
        k += 1U << 3 * level;
    }
}

}  // namespace dem
