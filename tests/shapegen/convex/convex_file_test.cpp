// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/convex/convex_file.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "tests/shapegen/convex/gridded_box.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

ConvexSolid parse(const std::string& text, const std::optional<Rounding>& rounding = {}) {
    return parse_convex(text, "x.convex", rounding).solid;
}

double volume(const std::string& text) {
    return parse(text).mass_properties.volume;
}

template <class Parse>
std::string message_of(const Parse& parse_it) {
    try {
        parse_it();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

/// The message begins with the place, holds the words and is one line.
void expect_message(const std::string& text, const std::string& place, const std::string& words,
                    const std::optional<Rounding>& rounding = {}) {
    const std::string message = message_of([&] { parse(text, rounding); });
    EXPECT_EQ(message.substr(0, place.size() + 2), place + ": ") << message;
    EXPECT_NE(message.find(words), std::string::npos) << message << "\n expected: " << words;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

const std::string cuboid = "units = mm\nshape = cuboid\nlength = 6\nwidth = 5\nheight = 4\n";

TEST(ConvexFile, AnOblongTabletHasTheExactVolumeOfTheSmoothOne) {
    for (const double cap : {0.0, 1e-5, 0.4, 1.2, 3.5}) {
        for (const int sides : {4, 7, 16}) {
            const std::string text =
                "units=mm\nshape=oblong\nlength=16\nwidth=7\nband_height=3\n"
                "rounding=0\ncap_height=" +
                std::to_string(cap) + "\nsides=" + std::to_string(sides);
            // Layer by layer: each is a stadium. Midpoints in the angle of the cap's surface.
            const double r = 3.5;
            const auto stadium = [&](double w) { return pi * w * w + 2.0 * w * (16.0 - 7.0); };
            double expected = 3.0 * stadium(r);
            const double sphere = cap > 0.0 ? (r * r + cap * cap) / (2.0 * cap) : 0.0;
            const double half_angle = cap > 0.0 ? 2.0 * std::atan(cap / r) : 0.0;
            constexpr int layers = 20'000;
            for (int k = 0; k < layers && cap > 0.0; ++k) {
                const double angle = half_angle * (k + 0.5) / layers;
                const double w = sphere * std::sin(angle);
                expected += 2.0 * stadium(w) * w * half_angle / layers;
            }
            EXPECT_NEAR(volume(text) / (1e-9 * expected), 1.0, 1e-8) << cap << ' ' << sides;
        }
    }
    const std::string flat =
        "units=mm\nshape=oblong\nlength=10\nwidth=4\nband_height=2\nrounding=0";
    EXPECT_NEAR(volume(flat) / (2.0e-9 * (4.0 * pi + 4.0 * 6.0)), 1.0, 1e-13);
}

TEST(ConvexFile, FacetsOfAnOblongTabletComeNearerWithTheSquareOfTheirNumber) {
    const auto error = [](int sides) {
        const ConvexSolid solid = parse(
            "units=mm\nshape=oblong\nlength=16\nwidth=7\nband_height=3\ncap_height=1.2\n"
            "sides=" +
            std::to_string(sides));
        // Heights are exact, whatever the facets.
        const ConvexSolid sharp = parse(
            "units=mm\nshape=oblong\nlength=16\nwidth=7\nband_height=3\ncap_height=1.2\n"
            "rounding=0\nsides=" +
            std::to_string(sides));
        const Vec3 up = sharp.mass_properties.principal_axes.conjugate() * Vec3::UnitZ();
        EXPECT_NEAR(extent(sharp.shape, up), 2.7e-3, 1e-15);
        EXPECT_NEAR(extent(sharp.shape, -up), 2.7e-3, 1e-15);
        return solid.facet_error / solid.shape.equivalent_diameter;
    };
    EXPECT_LT(error(16), 2e-3);
    EXPECT_NEAR(error(32) / error(16), 0.25, 0.1);
}

TEST(ConvexFile, AnOblongTabletThatIsNoneIsRefused) {
    const std::string start = "units=mm\nshape=oblong\nlength=16\nband_height=3\n";
    expect_message(start + "width=16", "x.convex:5", "less than the length");
    expect_message(start + "width=7\ncap_height=3.6", "x.convex:6",
                   "no higher than half the width");
    expect_message(start + "width=7\ncap_height=-1", "x.convex:6", "not negative");
    for (const char* sides : {"3", "65", "16.5", "nan"})
        expect_message(start + "width=7\nsides=" + sides, "x.convex:6", "");
    expect_message(start, "x.convex:2", "'width' is missing");
}

TEST(ConvexFile, AScaleMultipliesLengthsWhateverTheirUnitAndTheFilesOwnRounding) {
    for (const std::string& rounding :
         {std::string(""), std::string("rounding = 0.2\n"), std::string("rounding = 0.2 mm\n"),
          std::string("rounding = 3%\n")}) {
        const std::string text =
            "units = mm\nshape = cuboid\nlength = 6\nwidth = 0.5 cm\nheight = 4\n" + rounding;
        const ConvexFile plain = parse_convex(text, "x.convex");
        const ConvexFile scaled = parse_convex(text, "x.convex", {}, 10.0);
        EXPECT_NEAR(scaled.solid.mass_properties.volume / plain.solid.mass_properties.volume, 1e3,
                    1e-9);
        EXPECT_NEAR(scaled.solid.shape.rounding / plain.solid.shape.rounding, 10.0, 1e-12);
        EXPECT_NEAR(scaled.unit, 1e-2, 1e-17);
    }
    const ConvexFile points = parse_convex(
        "shape=polyhedron\nrounding=0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "x.convex", {}, 2.0);
    EXPECT_NEAR(points.solid.mass_properties.volume, 8.0 / 6.0, 1e-12);
    // What the command line says is meant as it is.
    const ConvexFile told = parse_convex(cuboid, "x.convex", Rounding{0.2e-3, false}, 10.0);
    EXPECT_EQ(told.solid.shape.rounding, 0.2e-3);
}

TEST(ConvexFile, NamedShapesHaveTheVolumesOfTheirClosedForms) {
    const auto expect_volume = [](const std::string& text, double expected) {
        EXPECT_NEAR(volume(text) / expected, 1.0, 1e-9) << text;
    };
    expect_volume(cuboid + "rounding = 0", 120e-9);
    expect_volume("shape = sphere\ndiameter = 4 mm", 4.0 / 3.0 * pi * 8e-9);
    expect_volume("units=mm\nshape = ellipsoid\na=3\nb=2\nc=1", 4.0 / 3.0 * pi * 6e-9);
    expect_volume("units=mm\nshape=cylinder\nradius=2\nheight=3\nrounding=0", pi * 12e-9);
    expect_volume("units=mm\nshape=cone\ndiameter=4\nheight=3\nrounding=0", pi * 4e-9);
    expect_volume("units=mm\nshape=capsule\nradius=1\nlength=5",
                  (3.0 * pi + 4.0 / 3.0 * pi) * 1e-9);
    // Guldin: half a circle around the axis, and what it encloses.
    expect_volume("units=mm\nshape=disc\nradius=3\nthickness=2",
                  (8.0 * pi + 0.5 * pi * 2.0 * pi * (2.0 + 4.0 / (3.0 * pi))) * 1e-9);
    expect_volume("units=mm\nshape=polyhedron\nrounding=0\n0 0 0\n1,0,0\n0;1;0\n0 0 1 # tip",
                  1e-9 / 6.0);
}

TEST(ConvexFile, PointsOfAFineBoxInSinglePrecisionMakeTheBoxSharpAndRounded) {
    const Vec3 edges(5.672, 5.387, 0.4734);
    Random random(3, 1);
    for (int k = 0; k < 20; ++k) {
        std::ostringstream text;
        text.precision(9);
        text << "shape = polyhedron\nunits = mm\n";
        for (const Vec3& p : test::gridded_box(edges, 6 + k % 10, random.orientation()))
            text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        for (const double r : {0.0, 0.02}) {
            // Steiner's formula for what is within r of the box that lies r below.
            const Vec3 a = edges - Vec3::Constant(2.0 * r);
            const double expected = a.prod() +
                                    2.0 * r * (a.x() * a.y() + a.y() * a.z() + a.z() * a.x()) +
                                    pi * r * r * a.sum() + 4.0 / 3.0 * pi * r * r * r;
            const double found = volume("rounding = " + std::to_string(r) + '\n' + text.str());
            EXPECT_NEAR(found / (1e-9 * expected), 1.0, 2e-6) << k << ' ' << r;
        }
    }
}

TEST(ConvexFile, ARoundingIsALengthAShareOfTheDiameterOrTheDefault) {
    const double d_eq = std::cbrt(6.0 * 120e-9 / pi);
    EXPECT_DOUBLE_EQ(parse(cuboid + "rounding = 0.2").shape.rounding, 2e-4);
    EXPECT_DOUBLE_EQ(parse(cuboid + "rounding = 30 um").shape.rounding, 3e-5);
    EXPECT_NEAR(parse(cuboid + "rounding = 2%").shape.rounding, 0.02 * d_eq, 1e-15);
    EXPECT_NEAR(parse(cuboid).shape.rounding, 0.01 * d_eq, 1e-15);
    EXPECT_DOUBLE_EQ(parse(cuboid + "rounding = 0.2", Rounding{3e-4, false}).shape.rounding, 3e-4);
    EXPECT_EQ(parse("shape = ellipsoid\na=3\nb=2\nc=1").shape.rounding, 0.0);
    // What a rounding takes of a cuboid, by Steiner's formula.
    const double r = 2e-4;
    const ConvexSolid solid = parse(cuboid + "rounding = 0.2");
    const Vec3 inner = Vec3(6e-3, 5e-3, 4e-3) - Vec3::Constant(2.0 * r);
    const double area =
        2.0 * (inner.x() * inner.y() + inner.y() * inner.z() + inner.z() * inner.x());
    const double expected =
        inner.prod() + area * r + pi * r * r * inner.sum() + 4.0 / 3.0 * pi * r * r * r;
    EXPECT_NEAR(solid.rounding_loss, 1.0 - expected / 120e-9, 1e-12);
    // The outer dimensions stay.
    EXPECT_NEAR(extent(solid.shape, Vec3::UnitX()), 3e-3, 1e-15);
}

TEST(ConvexFile, TheDefaultRoundingLeavesACoreInNeedlesAndPlates) {
    for (const char* sizes : {"length=1000\nwidth=1\nheight=1", "length=1000\nwidth=1000\nheight=1",
                              "length=1e6\nwidth=1e6\nheight=1"}) {
        const ConvexSolid solid = parse("units=mm\nshape=cuboid\n" + std::string(sizes));
        EXPECT_EQ(solid.shape.vertices.size(), 8U);
        EXPECT_LE(solid.shape.rounding, 0.125001e-3);
    }
    EXPECT_GT(parse("shape=cone\nradius=1 mm\nheight=1 m").mass_properties.volume, 0.0);
    const ConvexSolid needle =
        parse("shape=polyhedron\n0 0 0\n1000 0.5 0\n1000 -0.5 0\n1000 0 1\n");
    EXPECT_LT(needle.rounding_loss, 0.05);
}

TEST(ConvexFile, PointsThatAreNoCornersAreLeftOutAndCounted) {
    const std::string corners = "shape=polyhedron\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    EXPECT_TRUE(parse_convex(corners, "x.convex").lines.empty());
    const ConvexFile file = parse_convex(corners + "0 0 1\n0.2 0.2 0.2\n0.5 0.5 0\n", "x.convex");
    ASSERT_EQ(file.lines.size(), 1U);
    EXPECT_NE(file.lines[0].find("7 points, of which 3"), std::string::npos) << file.lines[0];
    EXPECT_NEAR(file.solid.mass_properties.volume, volume(corners), 1e-12);
    EXPECT_EQ(file.name, "x");
}

TEST(ConvexFile, AProfileThatIsAConvexShapeGivesTheSameAsTheConvexFile) {
    const auto profile = [](const std::string& text) {
        return parse_convex_profile(text, "x.profile").solid;
    };
    const auto expect_same = [](const ConvexSolid& a, const ConvexSolid& b) {
        EXPECT_EQ(a.shape.core, b.shape.core);
        EXPECT_EQ(a.mass_properties.volume, b.mass_properties.volume);
        EXPECT_EQ(a.shape.bounding_radius, b.shape.bounding_radius);
        EXPECT_EQ(a.shape.rounding, b.shape.rounding);
    };
    expect_same(profile("shape=sphere\nradius=2 mm"), parse("shape=sphere\nradius=2 mm"));
    expect_same(profile("shape=spheroid\na=2\nc=3"), parse("shape=ellipsoid\na=2\nb=2\nc=3"));
    expect_same(profile("shape=cylinder\nradius=2\nheight=3"),
                parse("shape=cylinder\nradius=2\nheight=3"));
    expect_same(profile("shape=disc\nradius=2\nheight=1"),
                parse("shape=cylinder\nradius=2\nheight=1"));
    expect_same(profile("shape=spherocylinder\nradius=2\ncylinder_height=3"),
                parse("shape=capsule\nradius=2\nlength=7"));
    expect_same(profile("shape=frustum\nbottom_radius=2\ntop_radius=2\nheight=3"),
                parse("shape=cylinder\nradius=2\nheight=3"));
    for (const char* other : {"shape=peanut\nlength=2\nwaist=1", "0 0\n1 1\n0 2\n"}) {
        const std::string message = message_of([&] { profile(other); });
        EXPECT_NE(message.find("expected --sr"), std::string::npos) << message;
    }
}

TEST(ConvexFile, AFrustumWithATipIsAConeWhereTheProfilePutsIt) {
    const ConvexSolid cone = parse("shape=cone\nradius=2\nheight=3\nrounding=0.01");
    for (const double up : {1.0, -1.0}) {
        const std::string radii =
            up > 0.0 ? "bottom_radius=2\ntop_radius=0" : "bottom_radius=0\ntop_radius=2";
        const ConvexSolid solid = parse_convex_profile("shape=frustum\n" + radii + "\nheight=3",
                                                       "x.profile", parse_rounding("0.01", 1.0))
                                      .solid;
        EXPECT_EQ(solid.shape.core, ConvexShape::Core::cone);
        EXPECT_EQ(solid.mass_properties.volume, cone.mass_properties.volume);
        EXPECT_NEAR(solid.mass_properties.center_of_mass.z(),
                    up * (cone.mass_properties.center_of_mass.z() - 1.5), 1e-15);
        EXPECT_NEAR(solid.mass_properties.principal_axes.norm(), 1.0, 1e-15);
        const Vec3 rim(1.9, 0.0, -1.49 * up);
        const Vec3 beside_tip(1.9, 0.0, 1.49 * up);
        EXPECT_LT(farthest_outside(solid, std::array{rim}), 0.02);
        EXPECT_GT(farthest_outside(solid, std::array{beside_tip}), 1.0);
        EXPECT_NEAR(solid.corner_retreat, cone.corner_retreat, 1e-12);
    }
    const std::string message = message_of([] {
        parse_convex_profile("shape=frustum\nbottom_radius=2\ntop_radius=1\nheight=3", "x.profile");
    });
    EXPECT_NE(message.find("--sr takes any frustum"), std::string::npos) << message;
}

TEST(ConvexFile, WhatIsWrongIsSaidInOneLineWithItsPlace) {
    expect_message("", "x.convex", "the file is empty");
    expect_message("units = mm\n", "x.convex", "found no shape");
    expect_message("0 0 0\n1 0 0\n", "x.convex", "found no shape");
    expect_message("shape = cubiod\n", "x.convex:1", "did you mean 'cuboid'?");
    expect_message("shape = sphere\nradios = 1\n", "x.convex:2", "did you mean 'radius'?");
    expect_message("shape = sphere\n", "x.convex:1", "'radius' is missing");
    expect_message("shape = sphere\nradius=1\ndiameter=2\n", "x.convex:3", "either");
    expect_message("shape = sphere\nradius = 1\n1 2 3\n", "x.convex:3", "only parameters");
    expect_message("shape = sphere\nradius = 1\nrounding = 0.1\n", "x.convex:3", "rounding");
    for (const char* bad : {"0", "-1", "-0"})
        expect_message("shape=ellipsoid\na=1\nb=" + std::string(bad) + "\nc=1", "x.convex:3",
                       "a length above zero");
    for (const char* bad : {"nan", "inf", "-inf", "1e999"})
        expect_message("shape=cone\nradius=1\nheight=" + std::string(bad), "x.convex:3", bad);
    for (const char* far : {"1e-200", "1e-13", "1e7", "1e200"})
        expect_message("shape=sphere\nradius=" + std::string(far), "x.convex:2",
                       "from 1e-12 to 1e6");
    expect_message("shape=polyhedron\n0 0 0\n1 0 0\n0 1e200 0", "x.convex:4", "within 1e6 m");
    expect_message("shape=capsule\nradius=1\nlength=1.9", "x.convex:3", "twice the radius");
    expect_message("shape=disc\nradius=1\nthickness=2", "x.convex:3", "less than twice");
    expect_message(cuboid + "rounding = 2", "x.convex:6", "rounding radius 0.002 m");
    expect_message(cuboid + "rounding = -1%", "x.convex:6", "zero or more");
    expect_message(cuboid + "rounding = much", "x.convex:6", "much");
    expect_message("shape=sphere\nradius=1", "x.convex", "no edges", Rounding{});
}

TEST(ConvexFile, PointsThatSpanNoSolidAreRefused) {
    const std::string start = "units=mm\nshape=polyhedron\n";
    expect_message(start, "x.convex:2", "0 points, expected at least four");
    expect_message(start + "0 0 0\n1 0 0\n0 1 0\n", "x.convex:2", "3 points");
    expect_message(start + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n", "x.convex:2", "lie in one plane");
    expect_message(start + "0 0 0\n1 1 1\n2 2 2\n3 3 3\n", "x.convex:2", "lie in one plane");
    expect_message(start + "1 2 3\n1 2 3\n1 2 3\n1 2 3\n", "x.convex:2", "lie in one plane");
    expect_message(start + "0 0 0\n1 0\n", "x.convex:4", "a point 'x y z'");
    expect_message(start + "0 0 0\n1 0 nan\n0 1 0\n0 0 1\n", "x.convex:4", "nan");
    expect_message(start + "0 0 0\n1 0 zero\n", "x.convex:4", "zero");
}

}  // namespace
}  // namespace dem::shapegen
