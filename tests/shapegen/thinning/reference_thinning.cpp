// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/shapegen/thinning/reference_thinning.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace dem::test {

using namespace shapegen;

namespace {

constexpr std::uint32_t center = 1U << 13;

Voxel step_of(int place) {
    return {place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1};
}

Voxel moved(const Voxel& v, const Voxel& step) {
    return {v[0] + step[0], v[1] + step[1], v[2] + step[2]};
}

/// Unit steps from one place of the block to another, or 4 where they do not even share a corner.
int steps_between(int a, int b) {
    int sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int d = std::abs(step_of(a)[axis] - step_of(b)[axis]);
        if (d > 1) return 4;
        sum += d;
    }
    return sum;
}

/// Places at most `reach` unit steps from `place` that share a corner with it.
std::uint32_t near(int place, int reach) {
    std::uint32_t places = 0;
    for (int n = 0; n < 27; ++n)
        if (n != place && steps_between(place, n) <= reach) places |= 1U << n;
    return places;
}

/// What can be reached from `seed` inside `set`.
std::uint32_t flood(std::uint32_t seed, std::uint32_t set, int reach) {
    static const auto tables = [] {
        std::array<std::array<std::uint32_t, 27>, 4> t{};
        for (int r = 1; r <= 3; ++r)
            for (int n = 0; n < 27; ++n)
                t[static_cast<std::size_t>(r)][static_cast<std::size_t>(n)] = near(n, r);
        return t;
    }();
    const auto& neighbors = tables[static_cast<std::size_t>(reach)];
    std::uint32_t reached = seed;
    for (std::uint32_t front = seed; front != 0;) {
        const auto place = static_cast<std::size_t>(std::countr_zero(front));
        front &= front - 1;
        const std::uint32_t fresh = neighbors[place] & set & ~reached;
        reached |= fresh;
        front |= fresh;
    }
    return reached;
}

std::uint32_t lowest_bit(std::uint32_t set) {
    return set & (~set + 1);
}

Neighbors neighbors_of(const VoxelImage& X, const Voxel& v) {
    Neighbors neighbors = 0;
    for (int n = 0; n < 27; ++n)
        if (n != 13 && X.contains(moved(v, step_of(n)))) neighbors |= 1U << n;
    return neighbors;
}

/// The voxels of X that hold a face of the grid, given by its middle in steps of half a voxel: an
/// even coordinate is that of voxel centers.
std::vector<Voxel> voxels_around(const VoxelImage& X, const Voxel& face) {
    std::vector<Voxel> clique;
    for (int k = face[2] / 2; k <= (face[2] + 1) / 2; ++k)
        for (int j = face[1] / 2; j <= (face[1] + 1) / 2; ++j)
            for (int i = face[0] / 2; i <= (face[0] + 1) / 2; ++i)
                if (X.contains({i, j, k})) clique.push_back({i, j, k});
    return clique;
}

/// The dimension of what the voxels have in common.
int rank_of(const std::vector<Voxel>& clique) {
    int rank = 3;
    for (std::size_t axis = 0; axis < 3; ++axis)
        rank -= std::any_of(clique.begin(), clique.end(),
                            [&](const Voxel& v) { return v[axis] != clique.front()[axis]; })
                    ? 1
                    : 0;
    return rank;
}

bool touch(const Voxel& a, const Voxel& b) {
    return std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
}

/// Regular: the voxels that touch all of the clique without belonging to it are reducible to one.
bool is_critical(const VoxelImage& X, const std::vector<Voxel>& clique) {
    const Voxel v = clique.front();
    if (clique.size() == 1) return !is_simple(X, v);
    std::uint32_t set = 0;
    for (int n = 0; n < 27; ++n) {
        const Voxel u = moved(v, step_of(n));
        if (X.contains(u) && std::find(clique.begin(), clique.end(), u) == clique.end() &&
            std::all_of(clique.begin(), clique.end(), [&](const Voxel& c) { return touch(c, u); }))
            set |= 1U << n;
    }
    return !is_reducible(set);
}

void keep_cliques(const VoxelImage& X, int rank, VoxelImage& Y) {
    std::vector<Voxel> selected;
    for (const std::vector<Voxel>& clique : critical_cliques(X, rank)) {
        if (std::none_of(clique.begin(), clique.end(),
                         [&](const Voxel& v) { return Y.contains(v); }))
            selected.push_back(clique.front());
    }
    for (const Voxel& v : selected) Y.insert(v);
}

bool is_interior(const VoxelImage& X, const Voxel& v) {
    const Neighbors faces = near(13, 1);
    return (neighbors_of(X, v) & faces) == faces;
}

bool is_end(const VoxelImage& X, const Voxel& v, Skeleton kind) {
    if (kind == Skeleton::ultimate) return false;
    const Neighbors neighbors = neighbors_of(X, v);
    if (kind == Skeleton::curve) return std::popcount(neighbors) == 1;
    if (is_interior(X, v)) return false;
    for (int n = 0; n < 27; ++n)
        if (((neighbors & near(13, 1)) >> n & 1U) != 0 && is_interior(X, moved(v, step_of(n))))
            return false;
    return true;
}

}  // namespace

bool is_simple(Neighbors neighbors) {
    if (neighbors == 0 || flood(lowest_bit(neighbors), neighbors, 3) != neighbors) return false;
    static const std::uint32_t n6 = near(13, 1);
    static const std::uint32_t n18 = near(13, 2);
    const std::uint32_t white_faces = n6 & ~neighbors;
    if (white_faces == 0) return false;
    return (white_faces & ~flood(lowest_bit(white_faces), n18 & ~neighbors, 1)) == 0;
}

bool is_simple(const VoxelImage& X, const Voxel& v) {
    return is_simple(neighbors_of(X, v));
}

bool is_reducible(std::uint32_t set) {
    bool shrank = true;
    while (shrank && std::popcount(set) > 1) {
        shrank = false;
        for (int n = 0; n < 27; ++n) {
            if ((set >> n & 1U) == 0) continue;
            std::uint32_t neighbors = 0;
            for (int m = 0; m < 27; ++m) {
                if (m == n || (set >> m & 1U) == 0 || steps_between(n, m) > 3) continue;
                const Voxel a = step_of(n);
                const Voxel b = step_of(m);
                neighbors |= 1U << (13 + b[0] - a[0] + 3 * (b[1] - a[1]) + 9 * (b[2] - a[2]));
            }
            if (!is_simple(neighbors)) continue;
            set &= ~(1U << n);
            shrank = true;
        }
    }
    return std::popcount(set) == 1;
}

std::vector<std::vector<Voxel>> critical_cliques(const VoxelImage& X, int rank) {
    std::vector<std::vector<Voxel>> cliques;
    const auto& size = X.grid().size;
    for (int c = 2; c < 2 * size[2] - 2; ++c) {
        for (int b = 2; b < 2 * size[1] - 2; ++b) {
            for (int a = 2; a < 2 * size[0] - 2; ++a) {
                if (3 - a % 2 - b % 2 - c % 2 != rank) continue;
                const std::vector<Voxel> clique = voxels_around(X, {a, b, c});
                if (!clique.empty() && rank_of(clique) == rank && is_critical(X, clique))
                    cliques.push_back(clique);
            }
        }
    }
    return cliques;
}

VoxelImage reference_skeleton(const VoxelImage& image, Skeleton kind) {
    VoxelImage X = image;
    VoxelImage K(image.grid());
    while (true) {
        VoxelImage Y = K;
        for (int rank = 3; rank >= 0; --rank) keep_cliques(X, rank, Y);
        const bool is_thin = Y == X;
        X = Y;
        if (is_thin) return X;
        for (const Voxel& v : X.voxels())
            if (is_end(X, v, kind)) K.insert(v);
    }
}

}  // namespace dem::test
