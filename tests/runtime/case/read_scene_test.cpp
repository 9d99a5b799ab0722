// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/read_scene.hpp"

#include "formats/template_writer.hpp"
#include "runtime/case/region.hpp"
#include "runtime/case/scene_summary.hpp"
#include "runtime/case/values.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/runtime/case/case_text.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

TEST(ReadScene, ASmallCaseBecomesTheSceneItDescribes) {
    const Scene scene = scene_of(sphere_case());
    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_DOUBLE_EQ(scene.materials[1].youngs_modulus, 2.0 * 20e6 * 1.25);
    ASSERT_EQ(scene.kinds.size(), 1U);
    const double mass = 1000.0 * 4.0 / 3.0 * pi * cube(5e-3);
    EXPECT_DOUBLE_EQ(scene.kinds[0].mass, mass);
    EXPECT_DOUBLE_EQ(scene.kinds[0].inertia.y(), 0.4 * mass * square(5e-3));
    EXPECT_DOUBLE_EQ(scene.kinds[0].inverse_inertia.mass, 1.0 / mass);
    EXPECT_EQ(scene.run.gravity, Vec3(0.0, 0.0, -9.81));
    EXPECT_FALSE(scene.run.time_step.has_value());
    EXPECT_FALSE(scene.output.frames_every.has_value()) << "a hundredth of the end time";
    ASSERT_EQ(scene.walls.size(), 2U);
    EXPECT_EQ(scene.walls[0].name, "vessel");
    EXPECT_EQ(scene.walls[1].name, "vessel.bottom");
    // The floor reaches under the side: a body pressed into the corner stays in front of both.
    EXPECT_GT(std::get<PlaneWall>(scene.walls[1].shape).radius, 25e-3);
}

TEST(ReadScene, APairOfMaterialsTakesItsOwnValuesAndTheRestFromContact) {
    const Scene scene = scene_of(sphere_case(), "contact.radius=local",
                                 "contact.steel.coating.damping_mass=reduced");
    const ContactLaw& own = scene.laws.at(0, 1);
    EXPECT_DOUBLE_EQ(own.friction, 0.22);
    EXPECT_EQ(own.damping_mass, ContactLaw::DampingMass::reduced);
    EXPECT_EQ(own.geometry.radius, ContactLaw::Radius::local);
    EXPECT_DOUBLE_EQ(own.damping, hertz_damping(0.6));
    EXPECT_DOUBLE_EQ(scene.laws.at(1, 0).friction, 0.22);
    const ContactLaw& general = scene.laws.at(0, 0);
    EXPECT_DOUBLE_EQ(general.friction, 0.38);
    EXPECT_EQ(general.damping_mass, ContactLaw::DampingMass::contact);
    EXPECT_EQ(general.geometry.radius, ContactLaw::Radius::local);
    EXPECT_DOUBLE_EQ(general.stiffness_ratio, ContactLaw{}.stiffness_ratio);
    EXPECT_DOUBLE_EQ(general.damping_ratio, ContactLaw{}.damping_ratio);
}

TEST(ReadScene, TangentialStiffnessIsMindlinsUnlessSaidOtherwise) {
    EXPECT_EQ(scene_of(sphere_case()).laws.at(0, 0).tangential, ContactLaw::Tangential::mindlin);
}

TEST(ReadScene, RollingResistanceIsOffUnlessSaidOtherwise) {
    EXPECT_EQ(scene_of(sphere_case()).laws.at(0, 0).rolling.friction, 0.0);
    const RollingResistance rolling =
        scene_of(sphere_case(), "contact.rolling_friction=0.1", "contact.rolling_model=constant")
            .laws.at(0, 0)
            .rolling;
    EXPECT_EQ(rolling.friction, 0.1);
    EXPECT_EQ(rolling.model, RollingResistance::Model::constant);
    EXPECT_EQ(rolling.damping, 0.3);
}

// The words of the key table stand in the order of the enums they become.
TEST(ReadScene, EveryWordOfAChoiceBecomesTheEnumOfTheSameName) {
    const auto law = [](const std::string& assignment) {
        return scene_of(sphere_case(), assignment).laws.at(0, 0);
    };
    EXPECT_EQ(law("contact.contact=auto").geometry.method, ContactLaw::Method::automatic);
    EXPECT_EQ(law("contact.contact=continuous").geometry.method, ContactLaw::Method::continuous);
    EXPECT_EQ(law("contact.contact=nodes").geometry.method, ContactLaw::Method::nodes);
    EXPECT_EQ(law("contact.tangential=mindlin").tangential, ContactLaw::Tangential::mindlin);
    EXPECT_EQ(law("contact.tangential=ratio").tangential, ContactLaw::Tangential::ratio);
    EXPECT_EQ(law("contact.multi_contact=sum").geometry.multi_contact,
              ContactLaw::MultiContact::sum);
    EXPECT_EQ(law("contact.multi_contact=deepest").geometry.multi_contact,
              ContactLaw::MultiContact::deepest);
    EXPECT_EQ(law("contact.radius=equivalent").geometry.radius, ContactLaw::Radius::equivalent);
    EXPECT_EQ(law("contact.node_normal=normalized").geometry.node_normal,
              ContactLaw::NodeNormal::normalized);
    EXPECT_EQ(law("contact.node_normal=vectors").geometry.node_normal,
              ContactLaw::NodeNormal::vectors);
    EXPECT_EQ(law("contact.node_normal=averaged").geometry.node_normal,
              ContactLaw::NodeNormal::averaged);
    EXPECT_TRUE(law("contact.limit_force=yes").limit_force);
    const auto mode = [](const std::string& word) {
        return scene_of(sphere_case(), "particles.balls.insert=" + word).insertions[0].mode;
    };
    EXPECT_EQ(mode("at_once"), InsertionGroup::Mode::at_once);
    EXPECT_EQ(mode("lattice"), InsertionGroup::Mode::lattice);
    EXPECT_EQ(
        scene_of(sphere_case(), "particles.balls.insert=batches", "particles.balls.every=1 ms")
            .insertions[0]
            .mode,
        InsertionGroup::Mode::batches);
    const auto measure = [](const std::string& word) {
        return scene_of(sphere_case(), "measure.m.kind=" + word).measures[0].kind;
    };
    EXPECT_EQ(measure("fill_height"), MeasureSettings::Kind::fill_height);
    EXPECT_EQ(measure("contacts"), MeasureSettings::Kind::contacts);
    EXPECT_EQ(measure("solid_fraction"), MeasureSettings::Kind::solid_fraction);
}

TEST(ReadScene, AFixedBodyHasNoInverseInertiaAndItsOwnKind) {
    const Scene scene =
        scene_of(sphere_case("[particles.post]\nradius = 5 mm\nmaterial = coating\n"
                             "fixed = yes\ncount = 1\n"
                             "region = box -5 -5 10 5 5 20 mm\n"));
    ASSERT_EQ(scene.kinds.size(), 2U);
    EXPECT_EQ(scene.shapes.size(), 1U) << "equal radii share a shape";
    EXPECT_EQ(scene.kinds[1].inverse_inertia.mass, 0.0);
    EXPECT_EQ(scene.kinds[1].inverse_inertia.moments, Vec3::Zero());
    EXPECT_GT(scene.kinds[1].mass, 0.0);
}

TEST(ReadScene, AFixedBodyHasNoVelocity) {
    EXPECT_EQ(case_message(sphere_case(), "particles.balls.fixed=yes"), "fine");
    EXPECT_EQ(case_message(sphere_case(), "particles.balls.fixed=yes",
                           "particles.balls.velocity=0 0 1 mm/s"),
              "--set particles.balls.fixed: found 'yes' with a velocity, expected one of them");
}

TEST(ReadScene, KeysOfAnotherLawAreRefused) {
    EXPECT_EQ(case_message(sphere_case(), "contact.normal_stiffness=1e4"),
              "--set contact.normal_stiffness: 'normal_stiffness' means nothing here, expected it "
              "with model = linear");
    EXPECT_EQ(case_message(sphere_case(), "contact.rolling_model=constant"),
              "--set contact.rolling_model: 'rolling_model' means nothing here, expected it with a "
              "rolling_friction above 0");
    EXPECT_EQ(
        case_message(sphere_case(), "contact.tangential=mindlin", "contact.stiffness_ratio=1"),
        "--set contact.stiffness_ratio: 'stiffness_ratio' means nothing here, expected it "
        "with tangential = ratio");
}

TEST(ReadScene, WhatDoublesCannotTellApartIsRefused) {
    EXPECT_EQ(case_message(sphere_case(), "particles.balls.region=box 0 0 0 1e16 1e16 1e16 m"),
              "--set particles.balls.region: found a coordinate beyond 1e6 m, expected the region "
              "within 1e6 m of the origin");
    EXPECT_EQ(
        case_message(sphere_case(), "particles.balls.radius=1e-12",
                     "particles.balls.region=box -0.01 -0.01 0.01 0.01 0.01 1"),
        "c.ini:15: bodies of radius 1e-12 m at 1 m from the origin, expected them within 1e10 "
        "radii: positions lose the digits that contacts need");
    EXPECT_EQ(
        case_message(sphere_case(), "particles.balls.insert=batches",
                     "particles.balls.every=1e-30"),
        "--set particles.balls.every: makes more than 1e15 batches until end_time, expected a "
        "longer interval");
}

TEST(ReadScene, ARegionOutOfTheDomainIsRefused) {
    EXPECT_NE(case_message(sphere_case(), "run.domain=box 0 0 0 1 1 1 mm")
                  .find("the region of [particles.balls] reaches out of the domain"),
              std::string::npos);
}

TEST(ReadScene, MistakesAreNamedWithTheirLine) {
    EXPECT_EQ(case_message(sphere_case("[wal.floor]\nshape = plane\n")),
              "c.ini:25: unknown section [wal.floor], did you mean 'wall'?");
    EXPECT_EQ(case_message(sphere_case("[wall]\nshape = plane\n")),
              "c.ini:25: unknown section [wall], expected [wall.NAME]");
    EXPECT_EQ(case_message(sphere_case(), "particles.balls.material=coatin"),
              "--set particles.balls.material: unknown material 'coatin', did you mean 'coating'?");
    EXPECT_EQ(case_message(sphere_case("[contact.coating.gold]\nfriction = 1\n")),
              "c.ini:25: unknown material 'gold', expected one of: coating, steel");
    EXPECT_EQ(case_message(sphere_case("[contact.coating.steel]\nfriction = 1\n")),
              "c.ini:25: second section for materials 'coating' and 'steel', expected one (first "
              "at c.ini:13)");
    EXPECT_EQ(
        case_message(sphere_case(), "particles.balls.material=steel"),
        "--set particles.balls.material: material 'steel' has no density, particles need one");
    EXPECT_EQ(case_message(sphere_case(), "material.steel.youngs_modulus=1 GPa"),
              "c.ini:8: shear_modulus: both youngs_modulus and shear_modulus in [material.steel], "
              "expected one of them");
    EXPECT_EQ(case_message(sphere_case(), "particles.balls.template=a.tpl"),
              "c.ini:16: radius: both template and radius in [particles.balls], expected one of "
              "them");
    EXPECT_EQ(case_message(sphere_case(), "run.time_step=2 s"),
              "--set run.time_step: found '2 s', expected less than end_time = '1 s'");
    EXPECT_EQ(case_message("[run]\nend_time = 1\n"),
              "c.ini: no section [particles.NAME], it is required");
    const std::string missing =
        case_message(sphere_case("[particles.tablets]\nmaterial = coating\n"
                                 "template = none.tpl\ncount = 1\n"
                                 "region = box 0 0 0 1 1 1\n"));
    EXPECT_TRUE(missing.starts_with("c.ini:27: template: none.tpl: ")) << missing;
}

TEST(ReadScene, AnOutletIsARegionOrWhatLiesBehindAPlane) {
    const Scene scene =
        scene_of(sphere_case("[outlet.drain]\nregion = box -1 -1 -2 1 1 -1\n"
                             "[outlet.gate]\nkind = flow\npoint = 0 0 -10 mm\nnormal = 0 0 -3\n"
                             "radius = 4 mm\n"),
                 "run.domain_exit=remove");
    ASSERT_EQ(scene.outlets.size(), 2U);
    EXPECT_EQ(scene.outlets[0].kind, Outlet::Kind::remove);
    EXPECT_TRUE(holds(scene.outlets[0], Vec3(0.5, 0.5, -1.5)));
    EXPECT_EQ(scene.outlets[1].kind, Outlet::Kind::flow);
    EXPECT_EQ(std::get<HalfSpace>(scene.outlets[1].place).normal, Vec3(0.0, 0.0, -1.0));
    EXPECT_EQ(scene.outlets[1].radius, 4e-3);
    EXPECT_EQ(scene.run.domain_exit, DomainExit::remove);
    EXPECT_EQ(scene_of(sphere_case()).run.domain_exit, DomainExit::error);
}

TEST(ReadScene, AnOutletThatCannotBeMeantIsRefused) {
    const auto message = [](const std::string& section, const std::string& assignment = {}) {
        return assignment.empty() ? case_message(sphere_case(section))
                                  : case_message(sphere_case(section), assignment);
    };
    EXPECT_EQ(message("[outlet.drain]\nregion = box -1 -1 -1 1 1 0.02\n"),
              "c.ini:25: [outlet.drain] takes out bodies where [particles.balls] puts them in, "
              "expected them apart");
    EXPECT_EQ(message("[outlet.drain]\npoint = 0 0 11 mm\nnormal = 0 0 1\n"),
              "c.ini:25: [outlet.drain] takes out bodies where [particles.balls] puts them in, "
              "expected them apart");
    EXPECT_EQ(message("[outlet.drain]\nnormal = 0 0 1\n"),
              "c.ini:25: no 'point' in [outlet.drain], expected a plane (point and normal) or a "
              "region");
    EXPECT_EQ(message("[outlet.drain]\nregion = box 0 0 -2 1 1 -1\nnormal = 0 0 1\n"),
              "c.ini:27: normal: found a plane beside 'region' in [outlet.drain], expected one of "
              "them");
    EXPECT_EQ(message("[outlet.domain]\nregion = box 0 0 -2 1 1 -1\n", "run.domain_exit=remove"),
              "c.ini:25: the columns of [outlet.domain] in the history would have "
              "'domain_bodies' twice, expected names of outlets and groups that differ");
    EXPECT_EQ(
        message("[outlet.far]\nregion = box 0 0 -2 1 1 -1\n", "run.domain=box -1 -1 -0.5 1 1 1"),
        "c.ini:25: [outlet.far] lies outside of the domain, expected it where bodies get");
    EXPECT_EQ(
        message("[outlet.cover]\npoint = 0 0 11 mm\nnormal = 0 0 1\n", "particles.balls.fixed=yes"),
        "fine");
}

TEST(ReadScene, APairThatCanMeetNeedsRestitutionAndFriction) {
    std::string text = sphere_case();
    text.replace(text.find("friction = 0.38\n"), 16, "");
    EXPECT_EQ(case_message(text),
              "c.ini:10: no friction for materials 'coating' and 'coating', expected it in "
              "[contact] or in [contact.coating.coating]");
    EXPECT_EQ(case_message(text, "contact.coating.coating.friction=0.1"), "fine")
        << "steel meets only coating";
}

TEST(ReadScene, WallsStandWhereTheCaseSays) {
    const Scene scene = scene_of(sphere_case(
        "[wall.box]\nshape = box\nlower = -1 -2 -3\nupper = 1 2 3\nopen = top\nmaterial = steel\n"
        "motion = rotate\nrate = 60 rpm\nrotation_axis = 0 0 2\n"
        "[wall.drum]\nshape = cylinder\npoint = 0 -1 0\naxis = 0 2 0\nlength = 2\nradius = 9\n"
        "ends = both\nmaterial = steel\nmotion = rotate\nrate = -1 rad/s\nfrom = 1\nuntil = 2\n"));
    ASSERT_EQ(scene.walls.size(), 2U + 5U + 3U);
    for (std::size_t w = 2; w < 7; ++w) {
        const Wall& wall = scene.walls[w];
        const Vec3 inward = wall.orientation * Vec3::UnitZ();
        EXPECT_LT(inward.dot(wall.position), 0.0) << wall.name << " faces the center";
        EXPECT_EQ(wall.motion.pieces[0].point, Vec3::Zero());
        EXPECT_NEAR(wall.motion.pieces[0].rate, 2.0 * pi, 1e-12);
        EXPECT_EQ(wall.motion.pieces[0].axis, Vec3::UnitZ());
        EXPECT_NE(wall.name, "box.top");
    }
    const Wall& top = scene.walls[9];
    EXPECT_EQ(top.name, "drum.top");
    EXPECT_TRUE(top.position.isApprox(Vec3(0.0, 1.0, 0.0)));
    EXPECT_TRUE((top.orientation * Vec3::UnitZ()).isApprox(-Vec3::UnitY()));
    EXPECT_EQ(top.motion.pieces[0].axis, Vec3::UnitY());
    EXPECT_EQ(top.motion.pieces[0].until, 2.0);
    EXPECT_NE(case_message(sphere_case(), "wall.vessel.ends=top"), "fine");
    EXPECT_NE(case_message(sphere_case(), "wall.vessel.side=outside", "wall.vessel.ends=both"),
              "fine");
    EXPECT_NE(case_message(sphere_case(), "wall.vessel.axis=0 0 0"), "fine");
}

TEST(ReadScene, ARegionThatReachesIntoAWallIsRefused) {
    const auto with = [](const std::string& region) {
        return case_message(sphere_case(), "particles.balls.region=" + region);
    };
    EXPECT_EQ(with("cylinder 0 0 0  0 0 50  25 mm"), "fine") << "as wide as the vessel";
    EXPECT_EQ(with("cylinder 0 0 0  0 0 50  30 mm"),
              "c.ini:15: the region of [particles.balls] reaches 5 mm into wall 'vessel', expected "
              "it inside the walls");
    EXPECT_NE(with("cylinder 0 0 -1  0 0 50  25 mm"), "fine") << "through the floor";
    EXPECT_NE(with("box -20 -20 0 20 20 50 mm"), "fine") << "corners outside";
    EXPECT_EQ(with("box -17 -17 0 17 17 50 mm"), "fine");
    EXPECT_NE(with("cylinder 10 0 0  10 0 50  25 mm"), "fine") << "off the axis";
    EXPECT_NE(with("cylinder -20 0 30  20 0 30  20 mm"), "fine") << "lying";
    EXPECT_EQ(with("cylinder -15 0 30  15 0 30  20 mm"), "fine");
}

TEST(Region, VolumeAndExtentAreThoseOfTheSolid) {
    const Region box = parse_region("box 0 0 0 1 2 3");
    EXPECT_DOUBLE_EQ(volume(box), 6.0);
    EXPECT_DOUBLE_EQ(support(box, Vec3(-1.0, 0.0, 0.0)), 0.0);
    EXPECT_DOUBLE_EQ(support(box, Vec3(0.6, 0.0, 0.8)), 0.6 + 2.4);
    const Region cylinder = parse_region("cylinder 1 0 0 3 0 0 2");
    EXPECT_DOUBLE_EQ(volume(cylinder), 8.0 * pi);
    EXPECT_DOUBLE_EQ(bounds(cylinder).lower.x(), 1.0);
    EXPECT_DOUBLE_EQ(bounds(cylinder).upper.z(), 2.0);
}

class BodyFile : public TemporaryFolder {
  protected:
    std::string message(const std::string& table, const std::string& more = "") {
        std::ofstream(path_) << table;
        return case_message(case_text(more));
    }
    std::string case_text(const std::string& more) const {
        return sphere_case(
            "[particles.probe]\nradius = 5 mm\nmaterial = coating\ninsert = file\n"
            "file = " +
            path_ + "\n" + more);
    }
    const std::string path_ = (folder_ / "bodies.csv").string();
};

TEST_F(BodyFile, RowsBecomePlacements) {
    std::ofstream(path_) << "x,z,vx,group\n0.01,0.05,2,a\n-0.01,0.05,0,b\n";
    const Scene scene = scene_of(case_text(""));
    const InsertionGroup& group = scene.insertions[1];
    ASSERT_EQ(group.count, 2U);
    EXPECT_EQ(group.placements[0].position, Vec3(0.01, 0.0, 0.05));
    EXPECT_EQ(group.placements[0].velocity, Vec3(2.0, 0.0, 0.0));
    EXPECT_EQ(group.placements[1].line, 3U);
    const Scene one = scene_of(case_text("file_group = b\n"));
    ASSERT_EQ(one.insertions[1].count, 1U);
    EXPECT_EQ(one.insertions[1].placements[0].position.x(), -0.01);
}

TEST_F(BodyFile, ARowThatCannotBeUsedIsNamed) {
    EXPECT_EQ(message("x\n0\nzero\n").substr(0, path_.size() + 2), path_ + ":3");
    EXPECT_NE(message("x,template\n0,tablet\n").find(":2: template 'tablet' is none of"),
              std::string::npos);
    EXPECT_NE(message("x,group\n0,a\n", "file_group = c\n").find("no row of group 'c'"),
              std::string::npos);
    EXPECT_NE(message("x\n0\n", "count = 3\n").find("key 'count' has no meaning"),
              std::string::npos);
}

/// Balls a, b, c, d of 1 to 4 mm in a library.
class ShapesOfALibrary : public TemporaryFolder {
  protected:
    ShapesOfALibrary() {
        TemplateFile file = sample::file();
        file.shapes.clear();
        for (const char* name : {"a", "b", "c", "d"})
            file.shapes.push_back(
                sample::sphere(1e-3 * static_cast<double>(file.shapes.size() + 1), name));
        write_template(folder_ / "balls.tpl", file);
    }
    std::string group(const std::string& lines) const {
        return sphere_case("[particles.some]\nmaterial = coating\ntemplate = " +
                           (folder_ / "balls.tpl").string() + "\n" + lines);
    }
    std::string table(const std::string& rows) const {
        write("rows.csv", rows);
        return group("insert = file\nfile = " + (folder_ / "rows.csv").string() + "\n");
    }
    /// Names of the shapes after the sphere of the case.
    static std::string shapes(const Scene& scene) {
        std::string names;
        for (std::size_t s = 1; s < scene.shapes.size(); ++s) names += scene.shapes[s].name;
        return names;
    }
    /// Names of the shapes of the first six bodies of the group.
    static std::string bodies(const Scene& scene) {
        const InsertionGroup& group = scene.insertions[1];
        std::string names;
        for (std::uint64_t k = 0; k < std::min<std::uint64_t>(group.count, 6); ++k) {
            const std::uint32_t kind = group.mode == InsertionGroup::Mode::file
                                           ? group.placements[k].kind
                                           : group.kinds[k % group.kinds.size()];
            names += scene.shapes[scene.kinds[kind].shape].name;
        }
        return names;
    }
};

TEST_F(ShapesOfALibrary, AreMadeWhenABodyTakesThem) {
    const std::string region = "region = cylinder 0 0 10 mm  0 0 100 mm  25 mm\n";
    const Scene few = scene_of(group("count = 3\n" + region));
    EXPECT_EQ(shapes(few), "abc");
    EXPECT_EQ(bodies(few), "abc");
    const Scene many = scene_of(group("count = 10\n" + region));
    EXPECT_EQ(shapes(many), "abcd");
    EXPECT_EQ(bodies(many), "abcdab");
    const Scene one = scene_of(group("count = 3\nshape = d\n" + region));
    EXPECT_EQ(shapes(one), "d");
    EXPECT_EQ(bodies(one), "ddd");
}

TEST_F(ShapesOfALibrary, AreTakenByRowsInTurnOrByName) {
    const Scene in_turn = scene_of(table("x\n0\n1\n"));
    EXPECT_EQ(shapes(in_turn), "ab");
    EXPECT_EQ(bodies(in_turn), "ab");
    const Scene round = scene_of(table("x\n0\n1\n2\n3\n4\n5\n"));
    EXPECT_EQ(bodies(round), "abcdab");
    const Scene named = scene_of(table("z,template\n0.15,d\n0.17,b\n0.19,d\n"));
    EXPECT_EQ(shapes(named), "db");
    EXPECT_EQ(bodies(named), "dbd");
    // The mass that `--check` states is that of the rows.
    const double mass = 1000.0 * 4.0 / 3.0 * pi * (2.0 * cube(4e-3) + cube(2e-3));
    std::ostringstream words;
    words << std::setprecision(4) << "some: 3 x 2 shapes, " << mass << " kg";
    EXPECT_NE(check_scene(named).find(words.str()), std::string::npos) << check_scene(named);
    EXPECT_NE(case_message(table("x,template\n0,e\n")).find(":2: template 'e' is none of"),
              std::string::npos);
    EXPECT_NE(case_message(table("x,template\n0,b\n") + "shape = c\n")
                  .find("template 'b' is none of [particles.some], expected 'c', its shape"),
              std::string::npos);
}

TEST(CaseLines, ChangeWithWhatMovesBodiesAndWithNothingElse) {
    const auto lines = [](auto... overrides) {
        return scene_of(sphere_case(), overrides...).case_lines;
    };
    const auto standard = lines();
    EXPECT_EQ(lines("run.end_time=3 s", "run.threads=2", "run.stop=at_rest", "run.skin=1 mm",
                    "output.frames_every=1 ms"),
              standard);
    EXPECT_NE(lines("run.seed=7"), standard);
    EXPECT_NE(lines("contact.restitution=0.31"), standard);
    EXPECT_NE(std::find(standard.begin(), standard.end(), "[particles.balls] radius = 5 mm"),
              standard.end());
}

}  // namespace
}  // namespace dem::runtime
