// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/inserter.hpp"

#include "common/random.hpp"
#include "runtime/contact/pairs/touch.hpp"
#include "runtime/insertion/occupancy.hpp"
#include "runtime/measure/fill_height.hpp"
#include "runtime/measure/solid_fraction.hpp"
#include "runtime/measure/vessel.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/runtime/case/case_text.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"

#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

Particles inserted(const Scene& scene, double time = 0.0) {
    Particles particles;
    Inserter(scene).insert_due(scene, particles, time);
    return particles;
}

std::string insertion_message(const Scene& scene) {
    try {
        inserted(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "fine";
}

double radius_of(const Scene& scene, const Particles& particles, std::uint32_t id) {
    return scene.shapes[scene.kinds[particles.kind[id]].shape].bounding_radius;
}

/// Smallest gap between any two of the spheres [m], by brute force.
double smallest_gap(const Scene& scene, const Particles& particles) {
    double gap = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        for (std::uint32_t j = i + 1; j < particles.size(); ++j) {
            gap =
                std::min(gap, (particles.position[i] - particles.position[j]).norm() -
                                  radius_of(scene, particles, i) - radius_of(scene, particles, j));
        }
    }
    return gap;
}

const char* const small_beads =
    "[particles.beads]\nradius = 1 mm\nmaterial = coating\ncount = 300\n"
    "region = cylinder 0 0 10 mm  0 0 100 mm  25 mm\n";

TEST(InsertAtOnce, NothingOverlapsAndEveryBodyIsWhollyInItsRegion) {
    const Scene scene = scene_of(sphere_case(small_beads), "particles.balls.count=60");
    const Particles particles = inserted(scene);
    ASSERT_EQ(particles.size(), 360U);
    EXPECT_GE(smallest_gap(scene, particles), 0.0);
    for (std::uint32_t id = 0; id < particles.size(); ++id) {
        const Vec3& p = particles.position[id];
        const double r = radius_of(scene, particles, id);
        EXPECT_LE(p.head<2>().norm() + r, 25e-3 + 1e-15);
        EXPECT_GE(p.z() - r, 10e-3 - 1e-15);
        EXPECT_LE(p.z() + r, 100e-3 + 1e-15);
        EXPECT_EQ(particles.group[id], id < 60 ? 0U : 1U);
    }
}

TEST(InsertAtOnce, TheSameSeedGivesTheSameBitsAndAnotherOneDoesNot) {
    const Particles a = inserted(scene_of(sphere_case()));
    const Particles b = inserted(scene_of(sphere_case()));
    const Particles c = inserted(scene_of(sphere_case(), "run.seed=2"));
    EXPECT_EQ(a.position, b.position);
    EXPECT_NE(a.position, c.position);
}

TEST(InsertAtOnce, ARegionThatIsTooSmallSaysHowManyItHeld) {
    const Scene scene = scene_of(sphere_case(), "particles.balls.count=5000");
    const std::string text = insertion_message(scene);
    int held = 0;
    int wanted = 0;
    ASSERT_EQ(
        std::sscanf(text.c_str(), "c.ini:15: the region of [particles.balls] holds %d of %d bodies",
                    &held, &wanted),
        2)
        << text;
    EXPECT_EQ(wanted, 5000);
    // Random sequential addition of spheres jams at 38 % of the volume; walls cost some.
    const double fraction = held * 4.0 / 3.0 * pi * cube(5e-3) / (pi * square(25e-3) * 90e-3);
    EXPECT_GT(fraction, 0.2);
    EXPECT_LT(fraction, 0.4);
    EXPECT_NE(
        insertion_message(scene_of(sphere_case(), "particles.balls.region=box 0 0 10 9 9 19 mm")),
        "fine")
        << "smaller than one body";
}

TEST(InsertAtOnce, BodiesKeepClearOfARodInTheirRegion) {
    // A rod without length goes on both ways from its point.
    for (const std::string z : {"-1", "0.045", "1"}) {
        const Scene scene =
            scene_of(sphere_case("[wall.rod]\nshape = cylinder\nside = outside\npoint = 0 0 " + z +
                                 "\nradius = 10 mm\nmaterial = steel\n"));
        const Particles particles = inserted(scene);
        for (const Vec3& p : particles.position) EXPECT_GE(p.head<2>().norm(), 15e-3 - 1e-15);
    }
}

TEST(InsertLattice, ABlockOfCellsIsFilledToTheLastOne) {
    const auto lattice = [](const char* count) {
        return scene_of(sphere_case(), "particles.balls.insert=lattice",
                        "particles.balls.region=box -15 -15 10 15 15 60 mm",
                        std::string("particles.balls.count=") + count);
    };
    const Scene full = lattice("45");  // 3 x 3 x 5 cells of 10 mm, no room to spare
    const Particles particles = inserted(full);
    ASSERT_EQ(particles.size(), 45U);
    EXPECT_GE(smallest_gap(full, particles), 0.0);
    EXPECT_LT(particles.position[0].x(), particles.position[1].x());
    EXPECT_EQ(particles.position[0].z(), particles.position[8].z());
    EXPECT_LT(particles.position[8].z(), particles.position[9].z());
    const std::string text = insertion_message(lattice("46"));
    EXPECT_NE(text.find("holds 45 of 46 bodies on a lattice of 3 x 3 x 5 cells"), std::string::npos)
        << text;
}

TEST(InsertLattice, CellsBeyondARoundSideOrInABodyAreLeftOut) {
    const Scene scene = scene_of(
        sphere_case("[particles.grid]\nradius = 2 mm\nmaterial = coating\ninsert = lattice\n"
                    "count = 500\nregion = cylinder 0 0 10 mm  0 0 100 mm  25 mm\n"));
    const Particles particles = inserted(scene);
    ASSERT_EQ(particles.size(), 520U);
    EXPECT_GE(smallest_gap(scene, particles), 0.0);
    for (const Vec3& p : particles.position) EXPECT_LE(p.head<2>().norm(), 23e-3 + 1e-9);
}

TEST(InsertLattice, JitterBreaksExactColumns) {
    const auto lattice = [](const char* jitter) {
        return scene_of(sphere_case(), "particles.balls.insert=lattice",
                        "particles.balls.region=box -16 -16 10 16 16 63 mm",
                        "particles.balls.count=45",
                        std::string("particles.balls.jitter=") + jitter);
    };
    const Particles exact = inserted(lattice("0"));
    EXPECT_EQ(exact.position[0].x(), exact.position[9].x());
    const Scene scene = lattice("0.05");
    const Particles shifted = inserted(scene);
    EXPECT_GE(smallest_gap(scene, shifted), 0.0);
    for (std::uint32_t k = 9; k < 45; ++k) {
        const Vec3 off = shifted.position[k] - shifted.position[k - 9];
        EXPECT_GT(off.head<2>().norm(), 1e-6) << k;
        EXPECT_LT(off.head<2>().cwiseAbs().maxCoeff(), 0.5e-3) << k;
    }
    EXPECT_EQ(shifted.position, inserted(lattice("0.05")).position);
}

TEST(InsertLattice, ATubeOfWholeDiametersHoldsNoExactColumnsWhereItsHeightAllows) {
    const Scene scene =
        scene_of(sphere_case(), "particles.balls.insert=lattice", "particles.balls.count=60",
                 "particles.balls.region=cylinder 0 0 0 mm  0 0 400 mm  25 mm");
    const Particles particles = inserted(scene);
    EXPECT_GE(smallest_gap(scene, particles), 0.0);
    for (std::uint32_t i = 0; i < 60; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            EXPECT_GT((particles.position[i] - particles.position[j]).head<2>().norm(), 1e-7);
        }
    }
}

TEST(InsertFill, FiveHundredSpheresFillATubeToAHalfWithoutAnOverlap) {
    const Scene scene =
        scene_of(sphere_case(), "particles.balls.insert=fill", "particles.balls.count=500",
                 "particles.balls.region=cylinder 0 0 0 mm  0 0 400 mm  25 mm");
    const Particles particles = inserted(scene);
    ASSERT_EQ(particles.size(), 500U);
    EXPECT_GE(smallest_gap(scene, particles), 0.0);
    for (const Vec3& p : particles.position) {
        EXPECT_LE(p.head<2>().norm(), 20e-3);
        EXPECT_GE(p.z(), 5e-3);
    }
    const double surface = fill_height(particles, scene).surface;
    const auto vessel = find_vessel(scene);
    ASSERT_TRUE(vessel);
    EXPECT_GT(solid_fraction(particles, scene, *vessel, {0.0, surface}).overall, 0.5);
    EXPECT_EQ(inserted(scene).position, particles.position);
}

TEST(InsertFill, ARegionThatIsTooSmallSaysHowManyItHeldMoreThanChanceDoes) {
    const auto held = [](const std::string& insert) {
        const std::string text = insertion_message(
            scene_of(sphere_case(), "particles.balls.insert=" + insert, "particles.balls.count=100",
                     "particles.balls.region=box -15 -15 10 15 15 40 mm"));
        int number = 0;
        std::sscanf(text.c_str(),
                    "c.ini:15: the region of [particles.balls] holds %d of 100 bodies p", &number);
        return number;
    };
    EXPECT_GT(held("at_once"), 0);
    EXPECT_GT(held("fill"), held("at_once"));
    EXPECT_LE(held("fill"), 27) << "three by three by three";
}

// A moment's work if the search is local, hours if it is not.
TEST(InsertLattice, AHundredThousandSpheresAreNoTrouble) {
    const Scene scene = scene_of(sphere_case(), "particles.balls.insert=lattice",
                                 "particles.balls.count=100000", "particles.balls.radius=0.25 mm",
                                 "particles.balls.region=box -17 -17 0 17 17 60 mm");
    EXPECT_EQ(inserted(scene).size(), 100000U);
}

/// The case with a flat body instead of the sphere.
template <class... Overrides>
Scene tablet_scene(const Overrides&... overrides) {
    Scene scene = scene_of(sphere_case(), overrides...);
    const test::SolidBody tablet = test::tablet();
    scene.shapes[0].shape = tablet.shape;
    scene.shapes[0].bounding_radius = tablet.shape.bounding_radius;
    return scene;
}

TEST(InsertTablets, NoTwoTouchAndNoneStandsOutOfItsRegion) {
    const Scene scene = tablet_scene("particles.balls.count=60");
    const Particles particles = inserted(scene);
    ASSERT_EQ(particles.size(), 60U);
    const ParticleTemplate& tablet = scene.shapes[0];
    Random random(5, 0);
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const Quat& q = particles.orientation[i];
        const Vec3& p = particles.position[i];
        for (std::uint32_t j = i + 1; j < particles.size(); ++j) {
            PairState pair;
            pair.displacement = particles.position[j] - p;
            pair.i.orientation = q;
            pair.j.orientation = particles.orientation[j];
            EXPECT_FALSE(touches(tablet, tablet, pair)) << i << " " << j;
        }
        EXPECT_LE(p.z() + extent(tablet, q, Vec3::UnitZ()), 0.1 + 1e-12);
        EXPECT_GE(p.z() - extent(tablet, q, -Vec3::UnitZ()), 0.01 - 1e-12);
        for (int k = 0; k < 200; ++k) {  // a convex body is within a cylinder if its supports are
            const double phi = random.uniform(0.0, 2.0 * pi);
            const Vec3 e(std::cos(phi), std::sin(phi), 0.0);
            EXPECT_LE(p.dot(e) + extent(tablet, q, e), 25e-3 + 1e-9);
        }
    }
}

TEST(InsertTablets, ALatticeOfGivenOrientationIsAsCloseAsTheShapeAllows) {
    // 11.35 x 11.35 x 6.46 mm lying: 4 x 4 x 7 in a box that holds 4 x 4 x 4 turned any way.
    const auto lattice = [](const char* orientation, const char* count) {
        return tablet_scene("particles.balls.insert=lattice", "wall.vessel.radius=100 mm",
                            "particles.balls.region=box -23 -23 10 23 23 56 mm",
                            std::string("particles.balls.orientation=") + orientation,
                            std::string("particles.balls.count=") + count);
    };
    EXPECT_EQ(insertion_message(lattice("1 0 0 0", "112")), "fine");
    EXPECT_NE(insertion_message(lattice("1 0 0 0", "113")), "fine");
    EXPECT_NE(insertion_message(lattice("random", "112")), "fine");
    EXPECT_EQ(inserted(lattice("random", "27")).size(), 27U);
}

TEST(InsertFill, TurnedBodiesOfAnyShapeDoNotOverlap) {
    const Scene scene = tablet_scene("particles.balls.insert=fill", "particles.balls.count=12");
    const Particles particles = inserted(scene);
    ASSERT_EQ(particles.size(), 12U);
    Particles others;
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const Occupancy occupancy(scene, others, {Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.0);
        BodyPlacement body;
        body.position = particles.position[i];
        body.orientation = particles.orientation[i];
        body.kind = particles.kind[i];
        EXPECT_TRUE(occupancy.is_free(body)) << i;
        others.append(body.kind, 0, body, scene.kinds[body.kind]);
    }
}

class InsertBatches : public testing::Test {
  protected:
    Scene scene_ =
        scene_of(sphere_case(), "particles.balls.insert=batches", "particles.balls.batch=8",
                 "particles.balls.every=100 ms", "particles.balls.start=50 ms",
                 "particles.balls.region=cylinder 0 0 80 mm 0 0 100 mm 25 mm");
    Inserter inserter_{scene_};
    Particles particles_;
};

TEST_F(InsertBatches, ComeWhenTheyAreDue) {
    EXPECT_EQ(inserter_.next_time(), 0.05);
    EXPECT_EQ(inserter_.insert_due(scene_, particles_, 0.049), 0U);
    EXPECT_EQ(inserter_.insert_due(scene_, particles_, 0.0501), 8U);
    EXPECT_DOUBLE_EQ(inserter_.next_time(), 0.15) << "a multiple of the interval, not a sum";
    EXPECT_EQ(inserter_.insert_due(scene_, particles_, 0.06), 0U);
    for (Vec3& p : particles_.position) p.z() -= 0.06;  // they have fallen
    EXPECT_EQ(inserter_.insert_due(scene_, particles_, 0.1501), 8U);
    EXPECT_DOUBLE_EQ(inserter_.next_time(), 0.25);
    for (Vec3& p : particles_.position) p.z() -= 0.06;
    EXPECT_EQ(inserter_.missing(0), 4U);
    EXPECT_EQ(inserter_.crowded_out(0), 0U) << "not due yet";
    EXPECT_EQ(inserter_.insert_due(scene_, particles_, 0.2501), 4U) << "the rest of 20";
    EXPECT_EQ(inserter_.missing(0), 0U);
    EXPECT_EQ(inserter_.next_time(), std::numeric_limits<double>::infinity());
}

TEST_F(InsertBatches, WaitWhileTheirRegionIsOccupied) {
    inserter_.insert_due(scene_, particles_, 0.05);
    std::uint32_t total = particles_.size();
    for (int k = 1; k < 6; ++k) {  // nothing falls: the region fills up
        total += inserter_.insert_due(scene_, particles_, 0.05 + 0.1 * k + 1e-9);
    }
    EXPECT_GE(smallest_gap(scene_, particles_), 0.0);
    EXPECT_EQ(total, particles_.size());
    EXPECT_LT(total, 20U);
    EXPECT_EQ(inserter_.missing(0), 20U - total);
    EXPECT_EQ(inserter_.crowded_out(0), 20U - total) << "all were due by now";
    for (Vec3& p : particles_.position) p.z() -= 0.06;
    EXPECT_GT(inserter_.insert_due(scene_, particles_, 1.0), 0U);
    EXPECT_GT(inserter_.next_time(), 1.0) << "missed times are not made up";
}

TEST(InsertBatchesAlone, ARegionTooSmallForOneBodyIsAnError) {
    const Scene scene =
        scene_of(sphere_case(), "particles.balls.insert=batches", "particles.balls.every=100 ms",
                 "particles.balls.region=box 0 0 80 9 15 100 mm");
    EXPECT_NE(insertion_message(scene).find("cannot hold one body"), std::string::npos);
}

class InsertFile : public TemporaryFolder {
  protected:
    std::string message(const std::string& rows, const std::string& more = "") {
        std::ofstream(path_) << rows;
        return insertion_message(
            scene_of(sphere_case("[particles.probe]\nradius = 5 mm\n"
                                 "material = coating\ninsert = file\nfile = " +
                                 path_ + "\n" + more)));
    }
    const std::string path_ = (folder_ / "bodies.csv").string();
};

TEST_F(InsertFile, ARowThatOverlapsIsNamed) {
    EXPECT_EQ(message("x,z\n0,0.15\n0.010001,0.15\n"), "fine");
    EXPECT_EQ(message("x,z\n0,0.15\n0.0099,0.15\n"),
              path_ +
                  ":3: the body overlaps the body of line 2, expected free places (or 'overlaps "
                  "= allow')");
    EXPECT_EQ(message("x,z\n0,0.15\n0.021,0.15\n"),
              path_ +
                  ":3: the body overlaps wall 'vessel', expected free places (or 'overlaps = "
                  "allow')");
    EXPECT_EQ(message("x,z\n0,0.15\n0.0099,0.15\n", "overlaps = allow\n"), "fine");
}

}  // namespace
}  // namespace dem::runtime
