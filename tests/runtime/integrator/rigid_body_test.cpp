// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrator/rigid_body.hpp"

#include "common/random.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

const Vec3 asymmetric = Vec3(1.0, 2.0, 3.5).cwiseInverse();
const Vec3 symmetric = Vec3(2.0, 2.0, 0.7).cwiseInverse();

double energy(const Quat& q, const Vec3& L, const Vec3& m) {
    return rotational_energy(L, angular_velocity(q, L, m));
}

double angle_between(const Quat& a, const Quat& b) {
    return 2.0 * std::asin(std::min(1.0, (a.conjugate() * b).vec().norm()));
}

Quat advanced(Quat q, const Vec3& L, const Vec3& m, double time, int steps) {
    for (int k = 0; k < steps; ++k) q = rotated(q, L, m, time / steps);
    return q;
}

TEST(Rotation, IsTheExponentialForSmallAndLargeAngles) {
    Random random(1, 2);
    for (int k = 0; k < 1000; ++k) {
        const Vec3 axis = random.direction();
        const double angle = std::pow(10.0, random.uniform(-9.0, 0.5));
        const Quat expected(Eigen::AngleAxisd(angle, axis));
        const Quat q = rotation(angle * axis);
        EXPECT_LT((q.coeffs() - expected.coeffs()).norm(), 4e-16);
    }
}

TEST(FreeTop, OrientationConvergesAtSecondOrder) {
    const Vec3 L(0.3, -1.0, 2.0);
    const Quat start = Random(3, 1).orientation();
    const Quat exact = advanced(start, L, asymmetric, 2.0, 20'000);
    const double coarse = angle_between(advanced(start, L, asymmetric, 2.0, 50), exact);
    const double fine = angle_between(advanced(start, L, asymmetric, 2.0, 100), exact);
    EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

TEST(FreeTop, EnergyOfAnAsymmetricBodyErrsAtSecondOrderWithoutDrift) {
    const Vec3 L(0.05, 1.0, 0.02);  // near the unstable axis: it tumbles
    const Quat start = Quat::Identity();
    const double exact = energy(start, L, asymmetric);
    const auto worst = [&](double dt, int from, int to) {
        Quat q = start;
        double error = 0.0;
        for (int k = 0; k < to; ++k) {
            q = rotated(q, L, asymmetric, dt);
            if (k >= from)
                error = std::max(error, std::abs(energy(q, L, asymmetric) / exact - 1.0));
        }
        return error;
    };
    const double coarse = worst(0.02, 0, 50'000);
    EXPECT_LT(coarse, 1e-4);
    EXPECT_NEAR(coarse / worst(0.01, 0, 100'000), 4.0, 0.2);
    EXPECT_NEAR(worst(0.02, 0, 25'000) / worst(0.02, 25'000, 50'000), 1.0, 0.02);
}

TEST(FreeTop, BodyOfRevolutionIsExactForAnyStep) {
    Random random(5, 5);
    for (int k = 0; k < 50; ++k) {
        const Quat start = random.orientation();
        const Vec3 L = 3.0 * random.direction();
        const Quat one = advanced(start, L, symmetric, 1.0, 1);
        const Quat many = advanced(start, L, symmetric, 1.0, 1000);
        EXPECT_LT(angle_between(one, many), 1e-12);
        EXPECT_NEAR(energy(one, L, symmetric), energy(start, L, symmetric), 1e-14 * 9.0);
    }
}

TEST(FreeTop, BodyOfRevolutionAgreesWithTheMidpointOfANearlyEqualBody) {
    const Vec3 nearly(symmetric.x(), symmetric.x() * (1.0 + 1e-9), symmetric.z());
    const Vec3 L(0.4, -1.1, 0.9);
    const Quat start = Random(5, 6).orientation();
    const Quat a = advanced(start, L, symmetric, 1.0, 1);
    const Quat b = advanced(start, L, nearly, 1.0, 20'000);
    EXPECT_LT(angle_between(a, b), 1e-7);
}

TEST(FreeTop, TheQuaternionStaysAUnitOne) {
    Quat q = Random(9, 9).orientation();
    for (int k = 0; k < 200'000; ++k) q = rotated(q, Vec3(1.0, 2.0, -0.4), symmetric, 1e-3);
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
}

TEST(FreeTop, NoSurfacePointIsFasterThanTheBound) {
    Random random(8, 1);
    for (const Vec3& m : {asymmetric, symmetric}) {
        Quat q = random.orientation();
        const Vec3 L = random.direction();
        const double bound = largest_spin(L, m) * (1.0 + 1e-14);
        for (int k = 0; k < 1000; ++k) {
            q = rotated(q, L, m, 0.05);
            EXPECT_LE(angular_velocity(q, L, m).norm(), bound);
        }
    }
}

}  // namespace
}  // namespace dem::runtime
