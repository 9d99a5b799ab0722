// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/broad_phase/hierarchical_grid.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/loop_grain.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

// Hierarchical hash grid (Ericson 2005, Sec. 7.2.1; Ogarko & Luding 2012). Level k has cells of
// edge s_k = s_0 / 2^k, s_0 the largest extent of any box. A box lies in one cell only: the one
// that holds its center, on the finest level whose cells are not smaller than the box. So a box
// that touches another of level k has the other's center within s_k / 2 of its own faces, and looks
// into at most 3 x 3 x 3 cells of every level not finer than its own.
//
// Cells are found by a hash that keeps neighbors along x in neighboring buckets; entries of other
// cells that share a bucket are told apart by their cell's coordinates.

namespace dem::runtime {

namespace {

using CellIndex = std::array<std::int64_t, 3>;

struct Entry {
    CellIndex cell;
    std::uint32_t id;
};

struct GridLevel {
    double cell_size = 0.0;
    std::uint64_t mask = 0;                   // number of buckets - 1, a power of two minus one
    std::vector<std::uint32_t> bucket_start;  // buckets + 1
    std::vector<Entry> entries;               // by bucket, ids rising within a bucket
};

constexpr int finest_level = 40;

double extent_of(const Aabb& box) {
    return (box.upper - box.lower).maxCoeff();
}

std::int64_t cell_coordinate(double x, double cell_size) {
    return static_cast<std::int64_t>(std::floor(x / cell_size));
}

std::uint64_t bucket_of(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t mask) {
    return (static_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(y) * 0x9e3779b97f4a7c15ULL +
            static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4fULL) &
           mask;
}

GridLevel fill_level(std::span<const Aabb> boxes, const std::vector<std::uint32_t>& ids,
                     double cell_size) {
    GridLevel level;
    level.cell_size = cell_size;
    // At least 8 buckets, so that a row of 4 cells never meets the same bucket twice.
    level.mask = std::bit_ceil(std::max<std::uint64_t>(8, 2 * ids.size())) - 1;
    level.bucket_start.assign(level.mask + 2, 0);
    level.entries.resize(ids.size());

    std::vector<Entry> unsorted(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
        const Vec3 center = 0.5 * (boxes[ids[k]].lower + boxes[ids[k]].upper);
        for (int axis = 0; axis < 3; ++axis) {
            unsorted[k].cell[static_cast<std::size_t>(axis)] =
                cell_coordinate(center[axis], cell_size);
        }
        unsorted[k].id = ids[k];
        const auto& c = unsorted[k].cell;
        ++level.bucket_start[bucket_of(c[0], c[1], c[2], level.mask) + 1];
    }
    for (std::size_t b = 0; b <= level.mask; ++b) {
        level.bucket_start[b + 1] += level.bucket_start[b];
    }
    std::vector<std::uint32_t> next(level.bucket_start.begin(), level.bucket_start.end() - 1);
    for (const Entry& entry : unsorted) {
        const auto& c = entry.cell;
        level.entries[next[bucket_of(c[0], c[1], c[2], level.mask)]++] = entry;
    }
    return level;
}

// Coarsest level first; levels without boxes are left out. `level_of` maps a box to its level.
std::vector<GridLevel> fill_levels(std::span<const Aabb> boxes,
                                   std::vector<std::uint32_t>& level_of) {
    double largest = 0.0;
    for (const Aabb& box : boxes) largest = std::max(largest, extent_of(box));
    if (largest == 0.0) largest = 1.0;  // points only: any cell size will do

    std::vector<std::vector<std::uint32_t>> ids(finest_level + 1);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const double extent = extent_of(boxes[i]);
        const int k =
            extent > 0.0 ? std::min(std::ilogb(largest / extent), finest_level) : finest_level;
        ids[static_cast<std::size_t>(k)].push_back(i);
    }
    std::vector<GridLevel> levels;
    level_of.resize(boxes.size());
    for (int k = 0; k <= finest_level; ++k) {
        const auto& members = ids[static_cast<std::size_t>(k)];
        if (members.empty()) continue;
        for (const std::uint32_t i : members) {
            level_of[i] = static_cast<std::uint32_t>(levels.size());
        }
        levels.push_back(fill_level(boxes, members, std::ldexp(largest, -k)));
    }
    return levels;
}

// Boxes of `level` that touch box i. On the box's own level each pair is found from both sides and
// taken from the side of the lower id.
void find_partners(const GridLevel& level, bool own_level, std::span<const Aabb> boxes,
                   std::uint32_t i, std::vector<IdPair>& pairs) {
    const Aabb& box = boxes[i];
    // Half a cell, and a little for the rounding of centers and of cell sizes.
    const double reach = 0.5 * level.cell_size * (1.0 + 1e-9);
    CellIndex low, high;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double rounding = 1e-15 * std::abs(box.lower[axis]);
        low[a] = cell_coordinate(box.lower[axis] - reach - rounding, level.cell_size);
        high[a] = cell_coordinate(box.upper[axis] + reach + rounding, level.cell_size);
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            for (std::int64_t x = low[0]; x <= high[0]; ++x) {
                const std::uint64_t bucket = bucket_of(x, y, z, level.mask);
                for (std::uint32_t e = level.bucket_start[bucket];
                     e < level.bucket_start[bucket + 1]; ++e) {
                    const Entry& entry = level.entries[e];
                    if (entry.id == i || (own_level && entry.id < i)) continue;
                    if (entry.cell[0] != x || entry.cell[1] != y || entry.cell[2] != z) continue;
                    if (!overlaps(box, boxes[entry.id])) continue;
                    pairs.push_back({std::min(i, entry.id), std::max(i, entry.id)});
                }
            }
        }
    }
}

// Sorts by i with a counting sort, then every i's few partners.
std::vector<IdPair> sorted(const std::vector<std::vector<IdPair>>& parts, std::size_t count) {
    std::vector<std::size_t> start(count + 1, 0);
    for (const auto& part : parts) {
        for (const IdPair& pair : part) ++start[pair.i + 1];
    }
    for (std::size_t i = 0; i < count; ++i) start[i + 1] += start[i];
    std::vector<IdPair> all(start[count]);
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (const auto& part : parts) {
        for (const IdPair& pair : part) all[next[pair.i]++] = pair;
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::sort(all.begin() + static_cast<std::ptrdiff_t>(start[i]),
                  all.begin() + static_cast<std::ptrdiff_t>(start[i + 1]));
    }
    return all;
}

}  // namespace

std::vector<IdPair> overlapping_pairs(std::span<const Aabb> boxes) {
    const auto count = static_cast<std::uint32_t>(boxes.size());
    std::vector<std::uint32_t> level_of;
    const std::vector<GridLevel> levels = fill_levels(boxes, level_of);

    std::vector<std::vector<IdPair>> parts(team_size_in_force());
    share_loop(count, bodies_at_a_time, [&](const LoopPart& part) {
        for (auto i = static_cast<std::uint32_t>(part.begin); i < part.end; ++i) {
            for (std::uint32_t k = 0; k <= level_of[i]; ++k) {
                find_partners(levels[k], k == level_of[i], boxes, i, parts[part.worker]);
            }
        }
    });
    return sorted(parts, count);
}

}  // namespace dem::runtime
