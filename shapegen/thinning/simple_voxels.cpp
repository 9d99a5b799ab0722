// SPDX-License-Identifier: GPL-3.0-or-later
// The test looks at the part A of the voxel's own surface that its neighbors touch: some of the 8
// corners, 12 edges and 6 faces of a cube. The voxel is simple if and only if A can be shrunk to a
// point, which is the same as conditions (i) and (ii) of [MS Theorem 1]. A part of a sphere's
// surface can if and only if it is connected and its Euler number, corners - edges + faces, is 1.
// Faces bring their edges with them, so A is connected when the graph of its corners and edges is.
#include "shapegen/thinning/simple_voxels.hpp"

namespace dem::shapegen {

namespace {

/// Corner c of the cube lies at x = +1 when bit 0 of c is set, y: bit 1, z: bit 2.
constexpr int side(std::size_t corner, std::size_t axis) {
    return ((corner >> axis) & 1U) != 0 ? 1 : -1;
}

struct Edge {
    std::size_t from, to;           ///< corners
    std::array<Step, 3> neighbors;  ///< the three that touch it
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
                {Step{diagonal[0], diagonal[1], diagonal[2]}, Step{first[0], first[1], first[2]},
                 Step{second[0], second[1], second[2]}}};
        }
    }
    return edges;
}

constexpr std::array<Edge, 12> edges = make_edges();

constexpr std::array<Step, 6> faces{unit_steps[0],  unit_steps[1],  unit_steps[2],
                                    -unit_steps[0], -unit_steps[1], -unit_steps[2]};

struct TouchedSurface {
    std::array<Brick, 8> corners{};
    std::array<Brick, 12> edges{};
    std::array<Brick, 6> faces{};
};

TouchedSurface touched_surface(const Neighborhoods& x) {
    TouchedSurface a;
    for (std::size_t c = 0; c < 8; ++c) a.corners[c] = x[Step{side(c, 0), side(c, 1), side(c, 2)}];
    for (std::size_t e = 0; e < 12; ++e) {
        for (const Step& step : edges[e].neighbors) a.edges[e] |= x[step];
        a.corners[edges[e].from] |= a.edges[e];
        a.corners[edges[e].to] |= a.edges[e];
    }
    for (std::size_t f = 0; f < 6; ++f) a.faces[f] = x[faces[f]];
    return a;
}

/// 64 counters modulo 8, the bits of each in three words.
struct Counters {
    Brick ones = 0, twos = 0, fours = 0;

    void add(Brick bits) {
        const Brick carry = ones & bits;
        ones ^= bits;
        fours ^= twos & carry;
        twos ^= carry;
    }
};

/// The Euler number plus the 12 edges is 13; it lies between -4 and 8, so 13 modulo 8 will do.
Brick has_euler_number_1(const TouchedSurface& a) {
    Counters sum;
    for (const Brick corner : a.corners) sum.add(corner);
    for (const Brick edge : a.edges) sum.add(~edge);
    for (const Brick face : a.faces) sum.add(face);
    return sum.ones & ~sum.twos & sum.fours;
}

/// Which of the candidates' graphs of corners and edges, none of them empty, are connected.
Brick is_connected(const TouchedSurface& a, Brick candidates) {
    std::array<Brick, 8> reached{};  // from the first corner there is
    Brick left = candidates;
    for (std::size_t c = 0; c < 8; ++c) {
        reached[c] = a.corners[c] & left;
        left &= ~a.corners[c];
    }
    Brick grown = 0;
    do {
        grown = 0;
        for (std::size_t e = 0; e < 12; ++e) {
            Brick& from = reached[edges[e].from];
            Brick& to = reached[edges[e].to];
            const Brick crossed = a.edges[e] & (from ^ to);
            from |= crossed;
            to |= crossed;
            grown |= crossed;
        }
    } while (grown != 0);
    Brick missed = 0;
    for (std::size_t c = 0; c < 8; ++c) missed |= a.corners[c] & ~reached[c];
    return candidates & ~missed;
}

}  // namespace

Brick simple_voxels(const Neighborhoods& x, Brick candidates) {
    const TouchedSurface a = touched_surface(x);
    return is_connected(a, candidates & has_euler_number_1(a));
}

}  // namespace dem::shapegen
