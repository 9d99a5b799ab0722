// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/motion_text.hpp"
#include "runtime/case/pose_rows.hpp"
#include "runtime/time_step.hpp"
#include "tests/runtime/case/case_text.hpp"

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

const std::string lift =
    "[motion.lift]\nfrom = 0.1\nrepeat = 1 s\n"
    "[motion.lift.up]\nkind = translate\nvelocity = 0 0 10 mm/s\nuntil = 0.4\n"
    "[motion.lift.down]\nkind = translate\nvelocity = 0 0 -10 mm/s\nfrom = 0.5\nuntil = 0.9\n";
const std::string turn =
    "[motion.turn]\nkind = rotate\naxis = 0 2 0\npoint = 0 0 5 mm\nrate = 60 rpm\nramp = 200 ms\n"
    "within = lift\nfrom = settled\n";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The message of a case with these sections, which must have the parts.
void expect_error(const std::string& sections, const std::vector<std::string>& parts) {
    const std::string message = case_message(sphere_case(sections));
    for (const std::string& part : parts)
        EXPECT_TRUE(holds(message, part)) << message << "\nexpected: " << part;
}

TEST(MotionCase, GivesAMotionToEveryWallThatNamesIt) {
    const Scene scene =
        scene_of(sphere_case(turn + lift +
                             "[wall.rod]\nshape = cylinder\nside = outside\nradius = 2 mm\n"
                             "point = 0 0 200 mm\nlength = 5 mm\nmaterial = steel\n"
                             "motion = lift\n"),
                 "wall.vessel.motion=turn");
    ASSERT_EQ(scene.walls.size(), 3U);
    EXPECT_EQ(scene.motions.size(), 2U);
    for (std::size_t w = 0; w < 2; ++w) {
        const Motion& motion = scene.walls[w].motion;
        EXPECT_EQ(motion.name, "turn");
        EXPECT_TRUE(motion.from_settled);
        ASSERT_EQ(motion.pieces.size(), 1U);
        EXPECT_EQ(motion.pieces[0].axis, Vec3::UnitY());
        EXPECT_EQ(motion.pieces[0].ramp, 0.2);
        ASSERT_NE(motion.within, nullptr);
        EXPECT_EQ(motion.within->name, "lift");
    }
    const Motion& rod = scene.walls[2].motion;
    ASSERT_EQ(rod.pieces.size(), 2U);
    EXPECT_EQ(rod.start, 0.1);
    EXPECT_EQ(rod.period, 1.0);
    EXPECT_EQ(rod.pieces[1].from, 0.5);
    const std::string text = motion_text(scene);
    EXPECT_TRUE(holds(text,
                      "motion turn: turns at 6.283 rad/s about (0 1 0) through (0 0 0.005) m, "
                      "at first 0 rad/s, smooth ramp of 0.2 s, from 0 s, after the bodies "
                      "settle, within lift (vessel)\n"))
        << text;
    EXPECT_TRUE(holds(text, "motion lift: moves at (0 0 0.01) m/s, from 0 s until 0.4 s; "))
        << text;
    EXPECT_TRUE(holds(text, "counted from 0.1 s, again every 1 s (rod)\n")) << text;
    EXPECT_TRUE(holds(motion_text(scene_of(sphere_case(turn + lift))),
                      "warning: no wall takes motion turn\n"));
}

TEST(MotionCase, RefusesNamesThatAreNone) {
    const std::string text = sphere_case(turn + lift);
    EXPECT_EQ(case_message(text, "wall.vessel.motion=tun"),
              "--set wall.vessel.motion: unknown choice 'tun', did you mean 'turn'?");
    EXPECT_TRUE(holds(case_message(text, "wall.vessel.motion=turn", "wall.vessel.rate=1"),
                      "key 'rate' has no meaning for motion = turn, it needs motion=rotate"));
    expect_error(turn, {"c.ini:", "within: no motion 'lift', expected one of: turn"});
    expect_error("[motion.rotate]\nkind = translate\nvelocity = 1 0 0\n",
                 {"found the name 'rotate'", "expected another one"});
    expect_error("[motion.lift.up]\nkind = translate\nvelocity = 1 0 0\n",
                 {"is a piece of no motion, expected a section [motion.lift]"});
    expect_error("[motion.lift]\nfrom = 1\n", {"no 'kind' and no [motion.lift.PIECE]"});
    expect_error("[motion.a]\nkind = shake\n", {"kind: unknown choice 'shake'"});
}

TEST(MotionCase, RefusesMotionsThatAreWithinThemselves) {
    const std::string body = "kind = translate\nvelocity = 1 0 0\n";
    expect_error("[motion.a]\n" + body + "within = a\n",
                 {"within: 'a' is within 'a', expected no circle"});
    expect_error("[motion.a]\n" + body + "within = b\n[motion.b]\n" + body +
                     "within = c\n[motion.c]\n" + body + "within = b\n",
                 {"'b' is within 'c' is within 'b', expected no circle"});
    std::string deep;
    for (int k = 0; k < 30; ++k) {
        deep += "[motion.m" + std::to_string(k) + "]\n" + body;
        if (k > 0) deep += "within = m" + std::to_string(k - 1) + "\n";
    }
    expect_error(deep, {"motions lie within one another more than 16 deep, expected less"});
}

TEST(MotionCase, RefusesPiecesOutOfOrderAndPeriodsThatDoNotHoldThem) {
    const auto with = [](const std::string& head, const std::string& up, const std::string& down) {
        const std::string body = "kind = translate\nvelocity = 1 0 0\n";
        return "[motion.l]\n" + head + "[motion.l.up]\n" + body + up + "[motion.l.down]\n" + body +
               down;
    };
    expect_error(with("", "until = 2\n", "from = 1.5\n"),
                 {"from: found from = '1.5' before the end of the piece 'up', expected pieces in "
                  "the order of time"});
    expect_error(with("", "", "from = 1.5\n"), {"before the end of the piece 'up'"});
    expect_error(with("", "from = 3\nuntil = 4\n", "until = 2\n"),
                 {"found from = '0 s' before the end"});
    expect_error(with("repeat = 3 s\n", "until = 2\n", "from = 2\n"),
                 {"repeat: found a motion without end"});
    expect_error(with("repeat = 3 s\n", "until = 2\n", "from = 2\nuntil = 4\n"),
                 {"repeat: found '3 s', expected no less than the 'until' of the last piece"});
    expect_error(with("", "until = 1\n", "from = 2\nuntil = 2\n"),
                 {"until: found '2', expected later than from = '2'"});
    expect_error(with("", "until = 1\n", "from = settled\n"),
                 {"'settled' belongs into [motion.l]"});
    expect_error(with("kind = rotate\nrate = 1\naxis = 0 0 1\n", "until = 1\n", "from = 2\n"),
                 {"kind: found 'rotate' beside pieces"});
    expect_error("[motion.a]\nkind = rotate\nrate = 1\naxis = 0 0 1\nuntil = 1\nramp = 2\n",
                 {"ramp: found '2', expected no more than the piece lasts"});
    expect_error("[motion.a]\nkind = rotate\nrate = 1\naxis = 0 0 1\ninitial_rate = 2\n",
                 {"initial_rate: found without a ramp"});
    expect_error("[motion.a]\nkind = rotate\nrate = nan\naxis = 0 0 1\n",
                 {"rate: found 'nan', expected a finite number"});
    expect_error("[motion.a]\nkind = rotate\nrate = 1\naxis = 0 0 0\n",
                 {"axis: found a zero vector"});
}

TEST(MotionCase, RefusesAStepInWhichAWallGoesFurtherThanARadius) {
    const std::string text = sphere_case(
        "[motion.shot]\nkind = translate\nvelocity = 0 0 6000\nfrom = 0.5\nuntil = 0.500001\n");
    try {
        time_step(scene_of(text, "wall.vessel.motion=shot", "run.time_step=1e-6"));
        ADD_FAILURE() << "a step of 1.2 radii";
    } catch (const Error& error) {
        EXPECT_TRUE(holds(error.what(),
                          "wall 'vessel' moves by up to 1.2 radii of the smallest "
                          "body in a time step of 1e-06 s, expected less than one"))
            << error.what();
    }
}

TEST(MotionCase, TakesSurfaceVelocitiesAlongTheSurfaceAlone) {
    const std::string plane =
        "[wall.belt]\nshape = plane\npoint = 0 0 -1\nnormal = 1 0 2\n"
        "material = steel\nsurface_velocity = ";
    const Scene scene = scene_of(sphere_case(plane + "2 0 -1\n"));
    const Wall& belt = scene.walls.back();
    EXPECT_TRUE((belt.orientation * belt.surface_velocity).isApprox(Vec3(2.0, 0.0, -1.0), 1e-12));
    EXPECT_EQ(belt.surface_velocity.z(), 0.0);
    EXPECT_TRUE(holds(motion_text(scene), "surface of wall belt moves\n"));
    expect_error(plane + "1 0 0\n",
                 {"surface_velocity: found '1 0 0', expected it along the plane"});
    EXPECT_TRUE(holds(case_message(sphere_case(), "wall.vessel.surface_velocity=0 0.1 1"),
                      "expected it along the axis"));
    const Scene tube = scene_of(sphere_case(), "wall.vessel.surface_velocity=0 0 0.3");
    EXPECT_TRUE(tube.walls[0].surface_velocity.isApprox(Vec3(0.0, 0.0, 0.3)));
    EXPECT_EQ(tube.walls[1].surface_velocity, Vec3::Zero()) << "its floor";
    const Scene box = scene_of(
        sphere_case("[wall.box]\nshape = box\nlower = -1 -1 -1\nupper = 1 1 1\nmaterial = steel\n"
                    "surface_velocity = 0.5 0 0\n"));
    for (const Wall& face : box.walls) {
        if (!face.name.starts_with("box")) continue;
        const bool is_end = face.name == "box.left" || face.name == "box.right";
        EXPECT_NEAR(face.surface_velocity.norm(), is_end ? 0.0 : 0.5, 1e-12) << face.name;
    }
}

std::string table_message(const std::string& text) {
    try {
        parse_pose_rows(text, "poses.csv");
    } catch (const Error& error) {
        return error.what();
    }
    return "fine";
}

TEST(MotionCase, ReadsTablesOfPosesAndSaysWhatIsWrongWithOthers) {
    const auto rows = parse_pose_rows(
        "t,qw,qx,qy,qz,z,y,x\n0,1,0,0,0,3,2,1\n0.5,0.8,0,0,-0.6,3,2,1\n", "poses.csv");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].position, Vec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(rows[1].orientation.z(), -0.6, 1e-15);
    EXPECT_EQ(table_message("t,x,y,z\n0.5,0,0,0\n2,0,0,1\n"), "fine");
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"", "poses.csv: is empty, expected a header row and poses"},
        {"t,x,y,z\n", "poses.csv: holds 0 poses, expected two or more"},
        {"t,x,y,z\n0,0,0,0\n", "poses.csv: holds 1 pose, expected two or more"},
        {"t,x,y\n0,0,0\n", "poses.csv:1: no column 'z'"},
        {"t,x,y,z,qw\n0,0,0,0,1\n", "poses.csv:1: no column 'qx'"},
        {"t,x,y,z,angle\n", "poses.csv:1: unknown column 'angle', expected a header row of t, x"},
        {"t,x,y,z,x\n", "poses.csv:1: column 'x' is given twice"},
        {"t,x,y,z\n0,0,0,0\n1,0,,0\n", "poses.csv:3: column 'y': found ''"},
        {"t,x,y,z\n0,0,0,0\n1,0,0\n", "poses.csv:3: 3 fields, expected 4"},
        {"t,x,y,z\n0,0,0,nan\n1,0,0,0\n", "poses.csv:2: column 'z': found 'nan'"},
        {"t,x,y,z\n0,0,0,0\n1,0,0,0\n1,0,0,1\n",
         "poses.csv:4: found t = 1 after t = 1, expected times that rise"},
        {"t,x,y,z\n-1,0,0,0\n1,0,0,0\n", "poses.csv:2: found t = -1, expected no time before 0"},
        {"t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,0,0,0,-1\n",
         "poses.csv:3: turns by half a turn from the row before"},
        {"t,x,y,z\n0,0,0,0\n1,0,0,2e6\n", "poses.csv:3: a position further than 1e6 m"},
        {"t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,1,0.1,0,0\n",
         "poses.csv:3: the quaternion qw, qx, qy, qz has length 1.00499"},
    };
    for (const auto& [text, message] : wrong)
        EXPECT_TRUE(holds(table_message(text), message)) << table_message(text) << "\n" << message;
    expect_error("[motion.a]\nkind = table\nfile = nowhere.csv\n",
                 {"file: no such file 'nowhere.csv', expected a table of poses"});
}

}  // namespace
}  // namespace dem::runtime
