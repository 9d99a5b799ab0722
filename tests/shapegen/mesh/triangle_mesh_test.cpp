// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/mesh/triangle_mesh.hpp"

#include "common/random.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

Mat3 inertia_in_input_frame(const MassProperties& m) {
    const Mat3 axes = m.principal_axes.toRotationMatrix();
    return axes * m.principal_moments_per_density.asDiagonal() * axes.transpose();
}

TEST(TriangleMesh, BoxHasItsClosedFormsFarFromTheOrigin) {
    const Vec3 side(3e-3, 5e-3, 7e-3);
    const Vec3 lower(1.0, -2.0, 0.5);
    const TriangleMesh mesh = sample::box(lower, lower + side);
    const MassProperties m = mass_properties(mesh);
    const double volume = side.prod();
    // Coordinates a thousand sizes away from the origin carry 1e-16 * 2 m / 3 mm of rounding.
    EXPECT_NEAR(m.volume / volume, 1.0, 1e-12);
    EXPECT_NEAR((m.center_of_mass - lower - 0.5 * side).norm(), 0.0, 1e-15);
    const Vec3 squares = side.cwiseProduct(side);
    const Vec3 moments = volume / 12.0 * (Vec3::Constant(squares.sum()) - squares);
    EXPECT_LT((m.principal_moments_per_density - moments).norm(), 1e-11 * moments.norm());
    EXPECT_NEAR(m.principal_axes.angularDistance(Quat::Identity()), 0.0, 1e-9);
    EXPECT_NEAR(surface_area(mesh), 2.0 * (15e-6 + 21e-6 + 35e-6), 1e-16);
    EXPECT_NEAR(enclosed_volume(sample::inside_out(mesh)) / volume, -1.0, 1e-12);
}

TEST(TriangleMesh, TetrahedronHasItsClosedForms) {
    const double a = 0.7;
    const double b = 1.1;
    const double c = 1.9;
    const auto m = mass_properties(sample::tetrahedron({a, 0, 0}, {0, b, 0}, {0, 0, c}));
    const double volume = a * b * c / 6.0;
    EXPECT_NEAR(m.volume, volume, 1e-15);
    EXPECT_NEAR((m.center_of_mass - Vec3(a, b, c) / 4.0).norm(), 0.0, 1e-15);
    // Integrals of x^2 and x y over the right tetrahedron: V a^2 / 10 and V a b / 20.
    const Vec3 legs(a, b, c);
    Mat3 second = volume / 20.0 * legs * legs.transpose();
    second.diagonal() *= 2.0;
    second -= volume * m.center_of_mass * m.center_of_mass.transpose();
    const Mat3 inertia = second.trace() * Mat3::Identity() - second;
    EXPECT_LT((inertia_in_input_frame(m) - inertia).norm(), 1e-14 * inertia.norm());
}

TEST(TriangleMesh, RotationTurnsTheAxesAndKeepsTheMoments) {
    Random random(7, 0);
    const TriangleMesh ellipsoid = sample::moved(
        sample::sphere(1.0, 3), Vec3(1.0, 2.0, 3.5).asDiagonal().toDenseMatrix(), Vec3::Zero());
    const MassProperties still = mass_properties(ellipsoid);
    for (int k = 0; k < 20; ++k) {
        const Mat3 turn = random.orientation().toRotationMatrix();
        const MassProperties m =
            mass_properties(sample::moved(ellipsoid, turn, random.direction()));
        const Mat3 expected = turn * inertia_in_input_frame(still) * turn.transpose();
        EXPECT_LT((inertia_in_input_frame(m) - expected).norm(), 1e-13 * expected.norm());
        EXPECT_NEAR(m.principal_axes.toRotationMatrix().determinant(), 1.0, 1e-14);
    }
}

TEST(TriangleMesh, AlignedAndSymmetricShapesKeepTheirAxes) {
    const auto angle = [](const TriangleMesh& mesh) {
        return mass_properties(mesh).principal_axes.angularDistance(Quat::Identity());
    };
    EXPECT_LT(angle(sample::sphere(2.0, 3)), 1e-12);
    EXPECT_LT(angle(sample::torus(3.0, 1.0, 32, 16)), 1e-12);
    EXPECT_LT(angle(sample::box({-3, -1, -2}, {3, 1, 2})), 1e-12);
    // A body of revolution that leans by 0.1 rad is turned by 0.1 rad, not more.
    const Mat3 lean = Eigen::AngleAxisd(0.1, Vec3::UnitX()).toRotationMatrix();
    EXPECT_NEAR(angle(sample::moved(sample::torus(3.0, 1.0, 32, 16), lean, Vec3::Zero())), 0.1,
                1e-12);
}

TEST(TriangleMesh, HollowIsTakenOff) {
    const TriangleMesh shell =
        sample::together(sample::box({-2, -2, -2}, {2, 2, 2}),
                         sample::inside_out(sample::box({-1, -1, -1}, {1, 1, 1})));
    const MassProperties m = mass_properties(shell);
    EXPECT_NEAR(m.volume, 64.0 - 8.0, 1e-13);
    EXPECT_NEAR(m.principal_moments_per_density.x(), 64.0 * 32.0 / 12.0 - 8.0 * 8.0 / 12.0, 1e-12);
}

TEST(TriangleMesh, SphereConvergesQuadratically) {
    const auto errors = [](int levels) {
        const TriangleMesh mesh = sample::sphere(1.0, levels);
        return std::array<double, 3>{4.0 * pi / 3.0 - mass_properties(mesh).volume,
                                     4.0 * pi - surface_area(mesh),
                                     1.0 - mean_squared_surface_distance(mesh, Vec3::Zero())};
    };
    const auto coarse = errors(4);
    const auto fine = errors(5);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(coarse[k] / fine[k], 4.0, 0.05);
}

TEST(TriangleMesh, MeanSquaredSurfaceDistanceOfACube) {
    // A face of the cube of half side h at distance h: h^2 + 2 h^2 / 3.
    const TriangleMesh cube = sample::box({-3, -3, -3}, {3, 3, 3});
    EXPECT_NEAR(mean_squared_surface_distance(cube, Vec3::Zero()), 9.0 * 5.0 / 3.0, 1e-13);
    // Steiner: moving the center by d adds d^2.
    EXPECT_NEAR(mean_squared_surface_distance(cube, Vec3(1, 2, -2)), 15.0 + 9.0, 1e-13);
}

}  // namespace
}  // namespace dem::shapegen
