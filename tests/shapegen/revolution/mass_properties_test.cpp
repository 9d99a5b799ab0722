// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/mass_properties.hpp"

#include "tests/shapegen/profile/sample_profiles.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

void expect_relative(double value, double expected, double tolerance) {
    EXPECT_NEAR(value / expected, 1.0, tolerance);
}

TEST(RevolutionMass, TabletHasThePublishedMass) {
    // By quadrature of another program: lengths in mm, density 1191.3 kg/m^3.
    const auto m = revolution_mass(sample::tablet(5.675e-3, 4.0e-3, 1.23e-3)).mass_properties;
    EXPECT_NEAR(m.volume, 5.311042e-7, 1e-13);
    EXPECT_NEAR(1191.3 * m.volume, 6.327044e-4, 1e-10);
    EXPECT_NEAR(1191.3 * m.principal_moments_per_density.x(), 6.228876e-9, 1e-15);
    EXPECT_NEAR(1191.3 * m.principal_moments_per_density.z(), 9.392900e-9, 1e-15);
}

TEST(RevolutionMass, TabletAgreesWithBandAndTwoSphericalCaps) {
    const double R = 5.675;
    const double H = 4.0;
    const double h = 1.23;
    const double S = (R * R + h * h) / (2.0 * h);  // cap sphere
    const double cap = pi * h * h * (S - h / 3.0);
    const double volume = pi * R * R * H + 2.0 * cap;
    // Moments of a cap about its own sphere's center, z from S - h to S.
    const auto power = [](double x, int n) { return std::pow(x, n); };
    const auto z2r2 = [&](double z) { return S * S * power(z, 3) / 3.0 - power(z, 5) / 5.0; };
    const auto zr2 = [&](double z) { return S * S * z * z / 2.0 - power(z, 4) / 4.0; };
    const auto r2 = [&](double z) { return S * S * z - power(z, 3) / 3.0; };
    const auto r4 = [&](double z) {
        return power(S, 4) * z - 2.0 * S * S * power(z, 3) / 3.0 + power(z, 5) / 5.0;
    };
    const auto over_cap = [&](auto f) { return f(S) - f(S - h); };
    const double shift = 0.5 * H + h - S;
    const double axial = 0.5 * pi * (power(R, 4) * H + 2.0 * over_cap(r4));
    const double z2 =
        power(R, 2) * power(H, 3) / 12.0 +
        2.0 * (over_cap(z2r2) + 2.0 * shift * over_cap(zr2) + shift * shift * over_cap(r2));
    const auto m = revolution_mass(sample::tablet(R, H, h)).mass_properties;
    expect_relative(m.volume, volume, 1e-12);
    expect_relative(m.principal_moments_per_density.z(), axial, 1e-12);
    expect_relative(m.principal_moments_per_density.x(), 0.5 * axial + pi * z2, 1e-10);
    EXPECT_NEAR(m.center_of_mass.z(), 0.0, 1e-15);
}

TEST(RevolutionMass, SimpleSolidsHaveTheirClosedForms) {
    const RevolutionMass sphere = revolution_mass(sample::sphere(2.0));
    expect_relative(sphere.mass_properties.volume, 32.0 * pi / 3.0, 1e-14);
    expect_relative(sphere.mass_properties.principal_moments_per_density.x(),
                    0.4 * 4.0 * 32.0 * pi / 3.0, 1e-13);
    expect_relative(sphere.surface_area, 16.0 * pi, 1e-14);
    expect_relative(sphere.mean_squared_surface_distance, 4.0, 1e-14);

    const double a = 6.585;
    const double c = 3.395;
    const auto candy = revolution_mass(sample::spheroid(a, c)).mass_properties;
    const double volume = 4.0 / 3.0 * pi * a * a * c;
    expect_relative(volume * 1e-9, 6.166517e-7, 1e-6);
    expect_relative(candy.volume, volume, 1e-13);
    expect_relative(candy.principal_moments_per_density.x(), 0.2 * volume * (a * a + c * c), 1e-13);
    expect_relative(candy.principal_moments_per_density.z(), 0.4 * volume * a * a, 1e-13);

    const auto cone = revolution_mass(sample::polygon({{0, 0}, {3, 0}, {0, 8}})).mass_properties;
    expect_relative(cone.volume, pi * 9.0 * 8.0 / 3.0, 1e-14);
    expect_relative(cone.center_of_mass.z(), 2.0, 1e-13);
    expect_relative(cone.principal_moments_per_density.z(), 0.3 * cone.volume * 9.0, 1e-13);
    expect_relative(cone.principal_moments_per_density.x(),
                    cone.volume * (3.0 / 20.0 * 9.0 + 3.0 / 80.0 * 64.0), 1e-13);
}

TEST(RevolutionMass, SuperquadricsHaveTheVolumeOfTheBetaFunction) {
    // V = 2 pi a^2 c / m B(1/m, 1 + 2/m).
    for (const double m : {1.5, 2.0, 3.0, 4.0, 8.0, 40.0}) {
        const double beta =
            std::tgamma(1.0 / m) * std::tgamma(1.0 + 2.0 / m) / std::tgamma(1.0 + 3.0 / m);
        const auto body = revolution_mass(sample::superquadric(1.2, 0.7, m)).mass_properties;
        expect_relative(body.volume, 2.0 * pi * square(1.2) * 0.7 / m * beta, 1e-12);
    }
}

TEST(RevolutionMass, RedBloodCellHasItsClosedForm) {
    // Substituting u = 1 - x^2: V = pi R^2 (2/3 c0 + 4/15 c1 + 16/105 c2).
    const auto cell = revolution_mass(sample::red_blood_cell(7.82)).mass_properties;
    const double expected =
        pi * square(3.91) * (2.0 / 3.0 * 0.81 + 4.0 / 15.0 * 7.83 - 16.0 / 105.0 * 4.39);
    expect_relative(cell.volume, expected, 1e-13);
}

TEST(RevolutionMass, DoesNotDependOnWhereTheBodyStands) {
    for (const auto& [name, profile] : sample::all()) {
        const RevolutionMass here = revolution_mass(profile);
        const RevolutionMass there = revolution_mass(profile.translated(1e3));
        expect_relative(there.mass_properties.volume, here.mass_properties.volume, 1e-11);
        for (int k = 0; k < 3; ++k)
            expect_relative(there.mass_properties.principal_moments_per_density[k],
                            here.mass_properties.principal_moments_per_density[k], 1e-9);
        expect_relative(there.mean_squared_surface_distance, here.mean_squared_surface_distance,
                        1e-9);
        EXPECT_NEAR(there.mass_properties.center_of_mass.z() - 1e3,
                    here.mass_properties.center_of_mass.z(), 1e-9)
            << name;
    }
}

}  // namespace
}  // namespace dem::shapegen
