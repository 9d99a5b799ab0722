// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/voxel/exact_orientation.hpp"

#include "common/random.hpp"

#include <array>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

__extension__ using Wide = __int128;
using Integers = std::array<std::int64_t, 3>;

/// Up to 2^30 in size, so that determinants fit and doubles hold the coordinates.
std::int64_t coordinate(Random& random) {
    return static_cast<std::int64_t>(random.next() % (1ULL << 31)) - (1LL << 30);
}

int sign(Wide x) {
    return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0);
}

Wide minor(const Integers& u, const Integers& v, std::size_t x, std::size_t y) {
    return static_cast<Wide>(u[x]) * v[y] - static_cast<Wide>(u[y]) * v[x];
}

Integers minus(const Integers& a, const Integers& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// In units far from 1, as meshes in meters are.
Vec3 scaled(const Integers& p) {
    return 0x1p-40 *
           Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

/// A point of the plane of a, b, c up to one step off: b or c of the line or the plane itself
/// every now and then.
Integers nearly_between(Random& random, const Integers& a, const Integers& b, const Integers& c) {
    const double s = random.uniform();
    const double t = random.next() % 4 == 0 ? 0.0 : random.uniform(0.0, 1.0 - s);
    Integers p{};
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = a[i] + std::llround(s * static_cast<double>(b[i] - a[i]) +
                                   t * static_cast<double>(c[i] - a[i]));
        p[i] += static_cast<std::int64_t>(random.next() % 3) - 1;
    }
    return p;
}

TEST(ExactOrientation, IsThatOfIntegerArithmetic) {
    Random random(4, 0);
    int flat = 0;
    for (int n = 0; n < 100000; ++n) {
        // Small triangles make exact zeros frequent, large ones make doubles fail.
        const std::int64_t step = n % 2 == 0 ? 1 : 1LL << 28;
        std::array<Integers, 3> t{};
        for (Integers& p : t)
            for (std::int64_t& x : p) x = step * (coordinate(random) / (1LL << 28)) + n % 7;
        const auto& [a, b, c] = t;
        const Integers d = nearly_between(random, a, b, c);
        const Integers u = minus(b, a);
        const Integers v = minus(c, a);
        const Integers w = minus(d, a);
        const Wide volume =
            minor(u, v, 1, 2) * w[0] + minor(u, v, 2, 0) * w[1] + minor(u, v, 0, 1) * w[2];
        flat += volume == 0 ? 1 : 0;
        ASSERT_EQ(orientation(scaled(a), scaled(b), scaled(c), scaled(d)), sign(volume));
        const Integers e = nearly_between(random, a, b, a);
        const Vec3 p = scaled(e);
        ASSERT_EQ(
            orientation(Vec2(scaled(a).head<2>()), Vec2(scaled(b).head<2>()), Vec2(p.head<2>())),
            sign(minor(u, minus(e, a), 0, 1)));
    }
    EXPECT_GT(flat, 1000);
}

TEST(ExactOrientation, SurvivesUnderflow) {
    const double tiny = 0x1p-1000;
    EXPECT_EQ(orientation(Vec2(0, 0), Vec2(tiny, 0), Vec2(0, tiny)), 1);
    EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(tiny, 0, 0), Vec3(0, tiny, 0), Vec3(0, 0, tiny)), 1);
}

}  // namespace
}  // namespace dem::shapegen
