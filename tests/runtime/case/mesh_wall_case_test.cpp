// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_writer.hpp"
#include "runtime/domain.hpp"
#include "runtime/output/wall_lines.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/runtime/case/case_text.hpp"
#include "tests/support/sample_walls.hpp"

namespace dem::runtime {
namespace {

/// A folder with a wall, `box.tpl`, and particles, `shapes.tpl`.
class MeshWallCase : public TemporaryFolder {
  protected:
    MeshWallCase() {
        const WallTemplate wall{
            "box", 1.0, {}, sample::box_inside({0.0, 0.0, 0.0}, {0.2, 0.3, 0.4}).wall()};
        write_template(folder_ / "box.tpl", TemplateFile{}, wall);
        write_template(folder_ / "shapes.tpl", sample::file());
    }
    std::string path(const char* name) const { return (folder_ / name).string(); }
    std::string wall(const std::string& lines, const char* file = "box.tpl") const {
        return sphere_case("[wall.bin]\nshape = mesh\nmaterial = steel\ntemplate = " + path(file) +
                           "\n" + lines);
    }
};

TEST_F(MeshWallCase, PlacesTheTemplateScaledTurnedAndMoved) {
    const Scene scene =
        scene_of(wall("scale = 2\nposition = 1 2 3\norientation = 0.5 0.5 0.5 0.5\n"));
    const Wall& bin = scene.walls.back();
    EXPECT_EQ(bin.name, "bin");
    const WallMesh& mesh = *std::get<MeshWall>(bin.shape).mesh;
    EXPECT_EQ(mesh.bounds.upper, Vec3(0.4, 0.6, 0.8));
    // x goes to y, y to z, z to x.
    const Aabb extent = scene_extent(scene);
    EXPECT_NEAR((extent.upper - Vec3(1.8, 2.4, 3.6)).norm(), 0.0, 1e-12);
    EXPECT_EQ(scene.inputs.size(), 1U);
}

TEST_F(MeshWallCase, PicturesShowItsEdges) {
    const Scene scene = scene_of(wall("position = 1 0 0\n"));
    const std::vector<Wall> bin{scene.walls.back()};
    const Segments lines = wall_lines(bin, {0.0, Aabb{Vec3::Zero(), Vec3::Ones()}});
    ASSERT_EQ(lines.size(), 12U);
    for (const auto& [from, to] : lines) {
        EXPECT_GE(from.x(), 1.0);
        EXPECT_LE(to.x(), 1.2);
    }
}

TEST_F(MeshWallCase, WhatCannotBeAWallOrMeetOneIsRefusedWithALine) {
    const auto expect = [](const std::string& text, const std::string& words) {
        EXPECT_NE(case_message(text).find(words), std::string::npos) << case_message(text);
    };
    expect(wall("", "shapes.tpl"), "expected a wall made by shapegen --wall");
    expect(wall("", "none.tpl"), "none.tpl");
    expect(sphere_case("[wall.bin]\nshape = mesh\nmaterial = steel\n"), "template");
    expect(wall("scale = 0\n"), "scale");
    expect(wall("radius = 3\n"), "radius");
    expect(wall("scale = 1e8\n"), "reaches beyond 1e6 m");
    expect(wall("scale = 1e5\n"), "expected a ratio of at most 1e6");
    expect(wall("scale = 1e-9\n"), "expected a ratio of at most 1e6");
    expect(wall("motion = rotate\nrate = 3\n"), "a mesh that rotates needs it");
    const std::string particles =
        "[particles.more]\nmaterial = coating\ncount = 1\nregion = "
        "cylinder 0 0 10 mm  0 0 100 mm  25 mm\ntemplate = ";
    expect(wall(particles + path("box.tpl") + "\n"),
           "is a wall made by shapegen --wall, expected a particle");
    const std::string balls = wall(particles + path("shapes.tpl") + "\nshape = sr ball\n");
    EXPECT_NE(case_message(balls, "contact.contact=nodes")
                  .find("bodies of kind 'sr' with wall 'bin' of shape mesh are not in this "
                        "version, expected spheres, clumps or convex surfaces of revolution "
                        "without 'contact = nodes'"),
              std::string::npos)
        << case_message(balls, "contact.contact=nodes");
    // Those that never move may stand anywhere.
    EXPECT_EQ(
        case_message(wall(particles + path("shapes.tpl") + "\nshape = sr ball\nfixed = yes\n")),
        "fine");
}

}  // namespace
}  // namespace dem::runtime
