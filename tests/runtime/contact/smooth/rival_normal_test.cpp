// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/rival_normal.hpp"

#include "common/random.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

SolidBody body_with_edges(Random& random) {
    const double ratio = 0.3 * std::pow(10.0, random.uniform());
    const double r = 4e-3 / std::cbrt(ratio);
    const double h = 2.0 * r * ratio;
    const double share = random.uniform(0.15, 0.85);
    switch (random.next() % 4) {
        case 0:
            return cylinder(r, h);
        case 1:
            return tablet(r, share * h, std::min(0.5 * (1.0 - share) * h, 0.9 * r));
        case 2:
            return frustum(r, share * r, h);
        default:
            return revolved({{0.0, 0.0}, {r, share * h}, {0.0, h}});
    }
}

/// The minima that a search from many directions finds.
std::vector<NormalProbe> all_minima(const SrSupport& i, const SrSupport& j, const Vec3& d,
                                    int starts) {
    Random random(3, 1);
    std::vector<NormalProbe> minima;
    for (int k = 0; k < starts; ++k) {
        const NormalProbe p = common_normal(i, j, d, random.direction());
        const bool is_known = std::any_of(minima.begin(), minima.end(), [&](const NormalProbe& m) {
            return (m.n - p.n).norm() < 1e-4;
        });
        if (!is_known) minima.push_back(p);
    }
    return minima;
}

double least_of(const std::vector<NormalProbe>& minima) {
    double least = minima.front().f;
    for (const NormalProbe& p : minima) least = std::min(least, p.f);
    return least;
}

// Overlaps of 0.01 to 0.1 of the size, a third of the pairs with nearly parallel axes: there edges
// lie along each other.
TEST(RivalNormal, FindsTheLeastOfAllMinimaUnlessTheKnownOneIsProvenToBeIt) {
    constexpr double size = 4e-3;
    int several = 0;
    int unproven = 0;
    for (std::uint64_t k = 0; k < 1000; ++k) {
        Random random(7, k);
        const SolidBody a = body_with_edges(random);
        const SolidBody b = body_with_edges(random);
        const SrSupport i{a.shape.support, random.direction()};
        Vec3 axis = random.direction();
        if (k % 3 == 0) axis = (i.axis + 0.2 * random.uniform() * axis).normalized();
        const SrSupport j{b.shape.support, axis};
        const Vec3 direction = random.direction();
        const double depth = size * random.uniform(0.01, 0.1);
        double near = 0.0;
        double far = a.shape.bounding_radius + b.shape.bounding_radius;
        for (int step = 0; step < 12; ++step) {
            const double middle = 0.5 * (near + far);
            const bool deep = common_normal(i, j, Vec3(middle * direction), direction).f > depth;
            (deep ? near : far) = middle;
        }
        const Vec3 d = near * direction;
        const std::vector<NormalProbe> minima = all_minima(i, j, d, 100);
        const double least = least_of(minima);
        if (!(least > 0.1 * depth)) continue;
        several += minima.size() > 1 && least < 0.99 * minima.back().f ? 1 : 0;
        for (const NormalProbe& p : minima) {
            if (p.f > 4.0 * least || p.gradient.norm() > 1e-7 * size) continue;
            double found = p.f;
            if (!is_least(p, i, j, d)) {
                ++unproven;
                const auto rival = rival_normal(p, i, j, d, p.f);
                if (rival) found = std::min(found, rival->f);
            }
            EXPECT_LE(found, least * (1.0 + 1e-6)) << "pair " << k;
        }
    }
    EXPECT_GT(several, 0);
    EXPECT_GT(unproven, 10);
}

// A proof that costs two products is what keeps contacts of edges cheap.
TEST(RivalNormal, ShallowContactsAreMostlyProvenToBeTheOnlyOnes) {
    int contacts = 0;
    int unproven = 0;
    for (std::uint64_t k = 0; k < 1000; ++k) {
        Random random(8, k);
        const SolidBody a = body_with_edges(random);
        const SolidBody b = body_with_edges(random);
        const SrSupport i{a.shape.support, random.direction()};
        const SrSupport j{b.shape.support, random.direction()};
        const Vec3 direction = random.direction();
        double near = 0.0;
        double far = a.shape.bounding_radius + b.shape.bounding_radius;
        for (int step = 0; step < 30; ++step) {
            const double middle = 0.5 * (near + far);
            const bool deep = common_normal(i, j, Vec3(middle * direction), direction).f > 4e-6;
            (deep ? near : far) = middle;
        }
        const Vec3 d = near * direction;
        ++contacts;
        unproven += is_least(common_normal(i, j, d, direction), i, j, d) ? 0 : 1;
    }
    EXPECT_LT(unproven, contacts / 100);
}

}  // namespace
}  // namespace dem::test
