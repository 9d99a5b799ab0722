// SPDX-License-Identifier: GPL-3.0-or-later
// 64 voxels are tested at once, one per bit, by nothing but logical operations. The test looks at
// the part A of the voxel's own surface that its neighbors touch: some of the 8 corners, 12 edges
// and 6 faces of a cube. The voxel is simple if and only if A can be shrunk to a point, which is
// the same as conditions (i) and (ii) of [MS Theorem 1]. A part of a sphere's surface can if and
// only if it is connected and its Euler number, corners - edges + faces, is 1. Faces bring their
// edges with them, so A is connected when the graph of its corners and edges is.
#include "shapegen/thinning/simple_voxels.hpp"

namespace dem {

namespace {

constexpr std::size_t place(int dx, int dy, int dz) {
    return static_cast<std::size_t>((dx + 1) + 3 * (dy + 1) + 9 * (dz + 1));
}

/// Corner c of the cube lies at x = +1 when bit 0 of c is set, y: bit 1, z: bit 2.
constexpr int side(std::size_t corner, std::size_t axis) {
    return ((corner >> axis) & 1U) != 0 ? 1 : -1;
}

struct Edge {
    std::size_t from, to;                  ///< corners
    std::array<std::size_t, 3> neighbors;  ///< the three that touch it
};

constexpr std::array<Edge, 12> make_edges() {
    std::array<Edge, 12> edges{};
    std::size_t n = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t corner = 0; corner < 8; ++corner) {
            if (side(corner, axis) > 0) continue;
            std::array<int, 3> diagonal{side(corner, 0), side(corner, 1), side(corner, 2)};
            diagonal[axis] = 0;
            std::array<int, 3> first = diagonal;
            std::array<int, 3> second = diagonal;
            first[(axis + 1) % 3] = 0;
            second[(axis + 2) % 3] = 0;
            edges[n++] = {
                corner,
                corner | (std::size_t{1} << axis),
                {place(diagonal[0], diagonal[1], diagonal[2]), place(first[0], first[1], first[2]),
                 place(second[0], second[1], second[2])}};
        }
    }
    return edges;
}

constexpr std::array<Edge, 12> edges = make_edges();

constexpr std::array<std::size_t, 6> faces{place(-1, 0, 0), place(1, 0, 0),  place(0, -1, 0),
                                           place(0, 1, 0),  place(0, 0, -1), place(0, 0, 1)};

struct TouchedSurface {
    std::array<VoxelWord, 8> corners{};
    std::array<VoxelWord, 12> edges{};
    std::array<VoxelWord, 6> faces{};
};

TouchedSurface touched_surface(const Neighborhoods& neighbors) {
    TouchedSurface a;
    for (std::size_t c = 0; c < 8; ++c)
        a.corners[c] = neighbors[place(side(c, 0), side(c, 1), side(c, 2))];
    for (std::size_t e = 0; e < 12; ++e) {
        for (const std::size_t n : edges[e].neighbors) a.edges[e] |= neighbors[n];
        a.corners[edges[e].from] |= a.edges[e];
        a.corners[edges[e].to] |= a.edges[e];
    }
    for (std::size_t f = 0; f < 6; ++f) a.faces[f] = neighbors[faces[f]];
    return a;
}

/// 64 counters from 0 to 15, the bits of each in four words.
struct Counters {
    std::array<VoxelWord, 4> bits{};

    void add(VoxelWord ones) {
        for (VoxelWord& bit : bits) {
            const VoxelWord carry = bit & ones;
            bit ^= ones;
            ones = carry;
        }
    }
};

VoxelWord has_euler_number_1(const TouchedSurface& a) {
    Counters corners_and_faces;  // at most 14
    Counters edges_and_1;        // at most 13
    for (const VoxelWord corner : a.corners) corners_and_faces.add(corner);
    for (const VoxelWord face : a.faces) corners_and_faces.add(face);
    edges_and_1.add(~VoxelWord{0});
    for (const VoxelWord edge : a.edges) edges_and_1.add(edge);
    VoxelWord differs = 0;
    for (std::size_t b = 0; b < 4; ++b) differs |= corners_and_faces.bits[b] ^ edges_and_1.bits[b];
    return ~differs;
}

/// True also of the empty set.
VoxelWord is_connected(const TouchedSurface& a) {
    std::array<VoxelWord, 8> reached{};  // from the first corner there is
    VoxelWord seen = 0;
    for (std::size_t c = 0; c < 8; ++c) {
        reached[c] = a.corners[c] & ~seen;
        seen |= a.corners[c];
    }
    VoxelWord grown = 0;
    do {
        grown = 0;
        for (std::size_t e = 0; e < 12; ++e) {
            VoxelWord& from = reached[edges[e].from];
            VoxelWord& to = reached[edges[e].to];
            const VoxelWord crossed = a.edges[e] & (from ^ to);
            from |= crossed;
            to |= crossed;
            grown |= crossed;
        }
    } while (grown != 0);
    VoxelWord missed = 0;
    for (std::size_t c = 0; c < 8; ++c) missed |= a.corners[c] & ~reached[c];
    return ~missed;
}

}  // namespace

VoxelWord simple_voxels(const Neighborhoods& neighbors) {
    const TouchedSurface a = touched_surface(neighbors);
    // The Euler number of the empty set is 0.
    return has_euler_number_1(a) & is_connected(a);
}

}  // namespace dem
