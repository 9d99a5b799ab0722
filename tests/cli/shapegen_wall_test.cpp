// SPDX-License-Identifier: BSD-3-Clause
// `shapegen MESH --wall` as a user types it.
#include "tests/cli/shapegen_fixture.hpp"

#include <nlohmann/json.hpp>

namespace dem {
namespace {

const std::string bunny = "'" DEM_SOURCE_DIR "/data/meshes/bunny.ply'";

/// A square funnel of four flat sides, open above and below, in millimeters.
const std::string funnel =
    "v -50 -50 80\nv 50 -50 80\nv 50 50 80\nv -50 50 80\n"
    "v -10 -10 0\nv 10 -10 0\nv 10 10 0\nv -10 10 0\n"
    "f 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n";

class ShapegenWall : public ShapegenFixture {};

TEST_F(ShapegenWall, AnOpenFunnelIsAWallOfFourPatchesThatInspectDescribes) {
    write("funnel.obj", funnel);
    const Outcome made = run("funnel.obj --wall");
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_NE(made.output.find("wall of 8 triangles, 100 x 100 x 80 mm (assumed"),
              std::string::npos)
        << made.output;
    EXPECT_NE(made.output.find("open, with 8 edges at rims"), std::string::npos) << made.output;
    const Outcome seen = run("inspect funnel.tpl --json");
    const auto json = nlohmann::json::parse(seen.output);
    EXPECT_EQ(json["shapes"][0]["kind"], "wall");
    EXPECT_EQ(json["shapes"][0]["counts"]["triangles"], 8);
    EXPECT_EQ(json["shapes"][0]["certificate"]["patches"], 4.0);
    EXPECT_EQ(json["shapes"][0]["upper"][2], 0.08);
    EXPECT_EQ(run("inspect funnel.tpl").code, 0);
    const WallTemplate wall = TemplateLibrary(folder_ / "funnel.tpl").wall(0);
    EXPECT_EQ(wall.name, "funnel");
    EXPECT_EQ(wall.input_unit, 1e-3);
}

TEST_F(ShapegenWall, AScannedSurfaceIsAWallToo) {
    const Outcome made = run(bunny + " --wall --crease 40deg -q -o out.tpl");
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_GT(TemplateLibrary(folder_ / "out.tpl").wall(0).mesh.triangles.size(), 11000U);
}

TEST_F(ShapegenWall, WrongInputIsRefusedWithALineAndLeavesNoFile) {
    write("funnel.obj", funnel);
    write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    write("nothing.obj", "v 0 0 0\n");
    write("nan.obj", "v nan 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    expect_failure("flat.obj --wall", 1, "found no area in triangle 0");
    expect_failure("nothing.obj --wall", 1, "no faces");
    expect_failure("nan.obj --wall", 1, "nan.obj");
    expect_failure("funnel.obj --wall --convex", 2, "expected one of them");
    expect_failure("funnel.obj --wall --largest", 2, "expected one of them");
    expect_failure("funnel.obj --wall --crease 200deg", 2, "--crease");
    expect_failure("funnel.obj --wall --scale 1e9", 1, "expected at most 1e6 m");
    expect_failure("x.profile --wall", 2, "expected it with a mesh");
    expect_failure("x.convex --wall", 2, "--wall");
}

TEST_F(ShapegenWall, ExportOfAWallIsRefusedWithALine) {
    write("funnel.obj", funnel);
    ASSERT_EQ(run("funnel.obj --wall -q -o wall.tpl").code, 0);
    const Outcome outcome = run("export wall.tpl -o wall.stl");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.errors.find("is a wall made by shapegen --wall"), std::string::npos);
}

}  // namespace
}  // namespace dem
