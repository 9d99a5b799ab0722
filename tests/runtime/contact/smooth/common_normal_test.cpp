// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/common_normal.hpp"

#include "common/math/elementary.hpp"
#include "common/random.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

/// Counts evaluations.
struct Counted {
    SrSupport support;
    int* count;
    SupportSample operator()(const Vec3& n) const {
        ++*count;
        return support(n);
    }
};

std::vector<SolidBody> bodies() {
    return {candy(), tablet(), cylinder(4e-3, 6e-3), cylinder(6e-3, 1.5e-3),
            spheroid(2.5e-3, 5e-3)};
}

/// Axes at random, parallel, nearly parallel and crossed; centers along `direction` at random,
/// along an axis, across it.
struct Pose {
    Vec3 axis_i, axis_j, direction;
};
Pose pose(Random& random, int k) {
    Pose p{random.direction(), random.direction(), random.direction()};
    if (k % 4 == 1) p.axis_j = p.axis_i;
    if (k % 4 == 2)
        p.axis_j = (p.axis_i + 1e-4 * random.uniform() * random.direction()).normalized();
    if (k % 8 == 3) p.axis_j = p.axis_i.cross(random.direction()).normalized();
    if (k % 16 == 5) p.direction = p.axis_i;
    if (k % 16 == 6) p.direction = (p.axis_i + 1e-3 * random.direction()).normalized();
    if (k % 16 == 9) p.direction = p.axis_i.cross(random.direction()).normalized();
    return p;
}

/// Distance of the centers at which the bodies overlap by `overlap`.
double distance_for(const SrSupport& a, const SrSupport& b, const Vec3& direction, double overlap) {
    double low = 1e-4;
    double high = 20e-3;
    for (int k = 0; k < 45; ++k) {
        const double middle = 0.5 * (low + high);
        const bool deep = common_normal(a, b, Vec3(middle * direction), direction).f > overlap;
        (deep ? low : high) = middle;
    }
    return low;
}

TEST(CommonNormal, ConvergesFromTheLineOfCentersForEveryPairOfShapes) {
    const std::vector<SolidBody> all = bodies();
    Random random(41, 1);
    double evaluations = 0.0;
    int searches = 0;
    for (const SolidBody& a : all) {
        for (const SolidBody& b : all) {
            for (int k = 0; k < 200; ++k) {
                const Pose at = pose(random, k);
                int count = 0;
                const SrSupport i{a.shape.support, at.axis_i};
                const SrSupport j{b.shape.support, at.axis_j};
                const double overlap = k % 2 == 0 ? 1e-6 : 5e-5 * random.uniform();
                const Vec3 d = distance_for(i, j, at.direction, overlap) * at.direction;
                const NormalProbe p =
                    common_normal(Counted{i, &count}, Counted{j, &count}, d, at.direction);
                EXPECT_LT(p.gradient.norm(), 1e-8 * d.norm());
                EXPECT_LT(count / 2, 300);
                evaluations += 0.5 * count;
                ++searches;
            }
        }
    }
    EXPECT_LT(evaluations / searches, 10.0);
}

TEST(CommonNormal, NoDirectionHasLessOverlap) {
    const std::vector<SolidBody> all = bodies();
    Random random(42, 1);
    for (int k = 0; k < 400; ++k) {
        const SolidBody& a = all[random.next() % all.size()];
        const SolidBody& b = all[random.next() % all.size()];
        const Pose at = pose(random, k);
        const SrSupport i{a.shape.support, at.axis_i};
        const SrSupport j{b.shape.support, at.axis_j};
        const Vec3 d = distance_for(i, j, at.direction, 2e-6) * at.direction;
        const NormalProbe p = common_normal(i, j, d, at.direction);
        for (int m = 0; m < 1000; ++m) {
            const double spread = std::pow(10.0, random.uniform(-6.0, 0.5));
            const Vec3 n = (p.n + spread * random.direction()).normalized();
            EXPECT_GE(probe(i, j, d, n).f, p.f - 1e-13);
        }
    }
}

TEST(CommonNormal, AWarmStartNeedsTwoEvaluationsOnSmoothBodies) {
    const SolidBody body = candy();
    Random random(43, 1);
    for (int k = 0; k < 200; ++k) {
        const Pose at = pose(random, k);
        int count = 0;
        const SrSupport i{body.shape.support, at.axis_i};
        const SrSupport j{body.shape.support, at.axis_j};
        const Vec3 d = distance_for(i, j, at.direction, 1e-5) * at.direction;
        const Vec3 n = common_normal(i, j, d, at.direction).n;
        const Vec3 moved = d + 1e-7 * random.direction();
        common_normal(Counted{i, &count}, Counted{j, &count}, moved, n);
        EXPECT_LE(count / 2, 2);
    }
}

TEST(CommonNormal, AMinimumThatIsFollowedIsWhereASearchFindsIt) {
    Random random(45, 1);
    const std::vector<SolidBody> all = bodies();
    for (const SolidBody& a : all) {
        int close = 0;
        int smooth = 0;
        for (int k = 0; k < 400; ++k) {
            const Pose at = pose(random, k);
            const SrSupport i{a.shape.support, at.axis_i};
            const SrSupport j{all[random.next() % all.size()].shape.support, at.axis_j};
            const Vec3 d = distance_for(i, j, at.direction, 2e-5) * at.direction;
            NormalProbe found = common_normal(i, j, d, at.direction);
            found = descend(i, j, d, found);
            const double turn = math::exp(random.uniform(-16.0, -5.6));  // to 3.7e-3
            const Vec3 away = found.n.cross(random.direction()).normalized();
            const double size = d.norm();
            const auto step =
                followed_step(i, j, d, size, Vec3(found.n + turn * away).normalized());
            smooth += 4.0 * square(turn) < square(std::min(found.i.room, found.j.room)) ? 1 : 0;
            if (!step.is_close || found.gradient.norm() > 1e-11 * size) continue;
            ++close;
            const CommonNormal expected = result_of(found, d);
            const CommonNormal followed = extrapolated(step.from, step.step.turn, d);
            EXPECT_NEAR(followed.f, expected.f, 1e-11 * size);
            EXPECT_LE((followed.middle - expected.middle).norm(), 2e-9 * size);
        }
        EXPECT_GT(close, smooth / 2) << "of " << smooth;
    }
}

TEST(CommonNormal, IsTheDistanceForSpheres) {
    const SolidBody body = round_body(3e-3);
    Random random(44, 1);
    for (int k = 0; k < 200; ++k) {
        const Vec3 d = random.uniform(5.5e-3, 6.5e-3) * random.direction();
        const SrSupport i{body.shape.support, random.direction()};
        const NormalProbe p = common_normal(i, SphereSupport{3e-3}, d, Vec3(d.normalized()));
        EXPECT_NEAR(p.f, 6e-3 - d.norm(), 1e-17);
    }
}

TEST(CommonNormal, CurvatureIsTheDerivativeOfTheSupportPoint) {
    Random random(45, 1);
    for (const SolidBody& body : bodies()) {
        const SrSupport s{body.shape.support, random.direction()};
        for (int k = 0; k < 200; ++k) {
            const Vec3 n = random.direction();
            const SupportSample a = s(n);
            const Vec3 tangent = random.direction().cross(n).normalized();
            const double h = 1e-6;
            const Vec3 derivative =
                (s((n + h * tangent).normalized()).point((n + h * tangent).normalized()) -
                 s((n - h * tangent).normalized()).point((n - h * tangent).normalized())) /
                (2.0 * h);
            const Vec3 expected =
                a.across * tangent + a.excess * a.meridian.dot(tangent) * a.meridian;
            // A piece border in between makes a jump.
            if ((derivative - expected).norm() > 1e-6) {
                EXPECT_GT(std::abs(s((n + h * tangent).normalized()).along() -
                                   s((n - h * tangent).normalized()).along()),
                          1e-6);
            }
        }
    }
}

}  // namespace
}  // namespace dem::test
