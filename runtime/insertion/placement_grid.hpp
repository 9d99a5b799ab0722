// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace dem::runtime {

/// Spheres that are added one by one, and the question which of them a new one may touch. One
/// hashed grid per power of two of the radius, so that grains beside boulders stay quick; no bounds
/// on the space. Bodies are numbered in the order in which they are added.
class PlacementGrid {
  public:
    void add(const Vec3& center, double radius);
    std::uint32_t size() const { return count_; }

    /// Calls visit(number) for every body whose sphere overlaps the given one, in no particular
    /// order and possibly twice, until visit returns true. Returns whether it did.
    template <class Visit>
    bool any_near(const Vec3& center, double radius, const Visit& visit) const {
        for (const auto& [exponent, level] : levels_) {
            if (level.any_near(center, radius, visit)) return true;
        }
        return false;
    }

  private:
    struct Entry {
        Vec3 center;
        double radius;
        std::uint32_t number;
        std::uint32_t next;  ///< entry of the same bucket, or none
    };

    struct Level {
        static constexpr std::uint32_t none = 0xffffffffU;
        double cell = 0.0;            ///< edge [m]; at least the largest diameter of the level
        double largest_radius = 0.0;  ///< [m]
        std::vector<Entry> entries;
        std::vector<std::uint32_t> buckets;  ///< first entry of each; a power of two of them

        std::size_t bucket(double i, double j, double k) const;
        void add(const Entry& entry);

        template <class Visit>
        bool any_near(const Vec3& center, double radius, const Visit& visit) const {
            const double reach = radius + largest_radius;
            const Vec3 low = ((center.array() - reach) / cell).floor();
            const Vec3 high = ((center.array() + reach) / cell).floor();
            const auto hit = [&](const Entry& entry) {
                return (entry.center - center).squaredNorm() < square(entry.radius + radius) &&
                       visit(entry.number);
            };
            if ((high - low + Vec3::Ones()).prod() > static_cast<double>(entries.size())) {
                for (const Entry& entry : entries) {
                    if (hit(entry)) return true;
                }
                return false;
            }
            for (double k = low.z(); k <= high.z(); ++k) {
                for (double j = low.y(); j <= high.y(); ++j) {
                    for (double i = low.x(); i <= high.x(); ++i) {
                        std::uint32_t e = buckets[bucket(i, j, k)];
                        for (; e != none; e = entries[e].next) {
                            if (hit(entries[e])) return true;
                        }
                    }
                }
            }
            return false;
        }
    };

    std::map<int, Level> levels_;  ///< by the binary exponent of the radius
    std::uint32_t count_ = 0;
};

}  // namespace dem::runtime
