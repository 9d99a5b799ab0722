// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/placement_grid.hpp"

#include <algorithm>

namespace dem::runtime {

std::size_t PlacementGrid::Level::bucket(double i, double j, double k) const {
    // Cell indices are whole numbers held as doubles; large odd factors spread them over the bits.
    const auto part = [](double index, std::uint64_t factor) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(index)) * factor;
    };
    std::uint64_t hash = part(i, 0x9e3779b97f4a7c15ULL) ^ part(j, 0xbf58476d1ce4e5b9ULL) ^
                         part(k, 0x94d049bb133111ebULL);
    hash ^= hash >> 32;
    return static_cast<std::size_t>(hash & (buckets.size() - 1));
}

void PlacementGrid::Level::add(const Entry& entry) {
    const auto link = [this](std::uint32_t e) {
        const Vec3 index = (entries[e].center / cell).array().floor();
        std::uint32_t& first = buckets[bucket(index.x(), index.y(), index.z())];
        entries[e].next = first;
        first = e;
    };
    entries.push_back(entry);
    largest_radius = std::max(largest_radius, entry.radius);
    if (entries.size() <= buckets.size()) {
        link(static_cast<std::uint32_t>(entries.size() - 1));
        return;
    }
    constexpr std::size_t smallest_table = 64;
    buckets.assign(std::max(smallest_table, 2 * buckets.size()), none);
    for (std::uint32_t e = 0; e < entries.size(); ++e) link(e);
}

void PlacementGrid::add(const Vec3& center, double radius) {
    // radius in [2^(exponent - 1), 2^exponent), so a cell of twice that holds any of the level.
    int exponent = 0;
    std::frexp(radius, &exponent);
    Level& level = levels_[exponent];
    level.cell = std::ldexp(2.0, exponent);
    level.add({center, radius, count_, Level::none});
    ++count_;
}

}  // namespace dem::runtime
