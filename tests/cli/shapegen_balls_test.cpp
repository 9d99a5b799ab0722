// SPDX-License-Identifier: BSD-3-Clause
// Bodies that are spheres, or unions of them, as clumps: nothing is fitted.
#include "tests/cli/shapegen_fixture.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace dem {
namespace {

class ShapegenBalls : public ShapegenFixture {};

std::map<std::string, double> certificate(const ParticleTemplate& shape) {
    return {shape.certificate.begin(), shape.certificate.end()};
}

TEST_F(ShapegenBalls, ASphereIsItsOwnClumpWhateverIsAskedFor) {
    write("ball.profile", "units = mm\nshape = sphere\ndiameter = 6\n");
    write("spheroid.profile", "units = mm\nshape = spheroid\na = 3\nc = 3\n");
    write("arcs.profile", "units = mm\nstart 0 -3\narc 3 0 radius 3\narc 0 3 radius 3\n");
    for (const char* profile : {"ball", "spheroid", "arcs"}) {
        for (const char* goal :
             {"--clump-spheres 20", "--clump-error 1%", "--clump 0.9999 --inscribed"}) {
            const ParticleTemplate shape = cook(std::string(profile) + ".profile " + goal);
            const auto& spheres = std::get<Clump>(shape.shape).spheres;
            ASSERT_EQ(spheres.size(), 1U) << profile << goal;
            EXPECT_EQ(spheres[0].center(), Vec3::Zero());
            EXPECT_NEAR(spheres[0].radius, 3e-3, 1e-18);
            EXPECT_NEAR(spheres[0].volume_share, 4.0 / 3.0 * pi * cube(3e-3), 1e-20);
            EXPECT_NEAR(shape.bounding_radius, 3e-3, 1e-17);
            EXPECT_EQ(certificate(shape).at("coverage"), 1.0);
            EXPECT_EQ(certificate(shape).at("outside"), 0.0);
            EXPECT_EQ(certificate(shape).at("mass_tolerance"), 0.0);
            EXPECT_LT(certificate(shape).at("rms_deviation"), 1e-15);
        }
    }
    cook("ball.profile --clump 0.9 --convergence rows.csv");
    const std::string rows = content(folder_ / "rows.csv");
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2) << rows;
    EXPECT_NE(rows.find("\n1,1,0,1,"), std::string::npos) << rows;
    EXPECT_NE(run("ball.profile --clump-spheres 20").output.find("nothing to fit"),
              std::string::npos);
}

TEST_F(ShapegenBalls, ADumbbellIsTheClumpOfItsBalls) {
    write("dumbbell.profile", "units = mm\nstart 0 -1.6\narc 0.8 0 radius 1\narc 0 1.6 radius 1\n");
    const ParticleTemplate shape = cook("dumbbell.profile --clump 0.95");
    const auto& spheres = std::get<Clump>(shape.shape).spheres;
    ASSERT_EQ(spheres.size(), 2U);
    for (const ClumpSphere& s : spheres) {
        EXPECT_LT((s.center().cwiseAbs() - Vec3(0.0, 0.0, 0.6e-3)).norm(), 1e-16);
        EXPECT_NEAR(s.radius, 1e-3, 1e-17);
    }
    // Two balls less what they share, a lens of two caps of height 0.4.
    const double volume = pi * (8.0 / 3.0 - 2.0 / 3.0 * square(0.4) * (3.0 - 0.4));
    EXPECT_NEAR(shape.mass_properties.volume, 1e-9 * volume, 1e-21);
}

// Ten spheres on top of each other stand as long as nothing pushes them aside. A center or a radius
// that is off by a rounding of the fit does: it grows e-fold in about sqrt(r/g) = 10 ms.
TEST_F(ShapegenBalls, AColumnOfTenSpheresAsClumpsStands) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 1\n");
    cook("ball.profile --clump-spheres 1");
    std::ostringstream bodies;
    bodies << "x,y,z\n";
    for (int i = 0; i < 10; ++i) bodies << "0,0," << 1.001e-3 * (1 + 2 * i) << '\n';
    write("column.csv", bodies.str());
    write("case.ini",
          "[run]\nend_time = 0.5 s\n"
          "[material.m]\ndensity = 1000\nyoungs_modulus = 5 MPa\npoissons_ratio = 0.3\n"
          "[contact]\nrestitution = 0.5\nfriction = 0.5\n"
          "[particles.column]\ntemplate = out.tpl\nmaterial = m\ninsert = file\nfile = column.csv\n"
          "[wall.floor]\nshape = plane\npoint = 0 0 0\nnormal = 0 0 1\nmaterial = m\n");
    const Outcome outcome = run_command(program("demrun") + " case.ini --quiet", folder_);
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    std::istringstream rows(content(folder_ / "case/final.csv"));
    std::string row;
    std::getline(rows, row);
    std::istringstream names(row);
    std::map<std::string, std::size_t> column;
    for (std::string name; std::getline(names, name, ',');) column.emplace(name, column.size());
    int bodies_found = 0;
    for (; std::getline(rows, row); ++bodies_found) {
        std::istringstream cells(row);
        std::vector<std::string> values;
        for (std::string value; std::getline(cells, value, ',');) values.push_back(value);
        EXPECT_EQ(std::stod(values.at(column.at("x"))), 0.0);
        EXPECT_EQ(std::stod(values.at(column.at("y"))), 0.0);
        EXPECT_NEAR(std::stod(values.at(column.at("z"))), 1e-3 * (1 + 2 * bodies_found), 0.05e-3);
    }
    EXPECT_EQ(bodies_found, 10);
}

}  // namespace
}  // namespace dem
