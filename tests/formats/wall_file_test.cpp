// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "formats/memory_map.hpp"
#include "formats/template_reader.hpp"
#include "formats/template_writer.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/support/sample_walls.hpp"

#include <functional>
#include <limits>

namespace dem {
namespace {

WallTemplate sample_wall() {
    return {"tray", 1e-3, {{"area", 22.0}}, sample::box_inside({0, 0, 0}, {1, 2, 3}).wall()};
}

template <class T>
void replace(SharedArray<T>& array, std::size_t i, const T& value) {
    std::vector<T> values(array.begin(), array.end());
    values.at(i) = value;
    array = std::move(values);
}

class WallFileTest : public TemporaryFolder {
  protected:
    std::filesystem::path path() const { return folder_ / "wall.tpl"; }
    std::string refusal(const WallTemplate& wall) const {
        return message_of<Error>([&] { write_template(path(), TemplateFile{}, wall); });
    }
};

TEST_F(WallFileTest, EveryArraySurvivesTheRoundTrip) {
    const WallTemplate written = sample_wall();
    TemplateFile head;
    head.command = "shapegen tray.stl --wall";
    write_template(path(), head, written);
    const TemplateLibrary library(path());
    EXPECT_TRUE(library.is_wall(0));
    EXPECT_EQ(library.head().command, head.command);
    const WallTemplate read = library.wall(0);
    EXPECT_EQ(read.name, "tray");
    EXPECT_EQ(read.input_unit, 1e-3);
    EXPECT_EQ(read.certificate, written.certificate);
    EXPECT_TRUE(std::ranges::equal(read.mesh.vertices, written.mesh.vertices));
    EXPECT_TRUE(std::ranges::equal(read.mesh.triangles, written.mesh.triangles));
    EXPECT_TRUE(std::ranges::equal(read.mesh.twins, written.mesh.twins));
    EXPECT_TRUE(std::ranges::equal(read.mesh.bends, written.mesh.bends));
    EXPECT_TRUE(std::ranges::equal(read.mesh.patches, written.mesh.patches));
    EXPECT_TRUE(std::ranges::equal(read.mesh.blends, written.mesh.blends));
    EXPECT_EQ(read.mesh.boxes.size(), written.mesh.boxes.size());
    EXPECT_EQ(read.mesh.crease_angle, written.mesh.crease_angle);
    EXPECT_EQ(read.mesh.normals.size(), 12U);
    EXPECT_EQ(read.mesh.fan.size(), 36U);
}

TEST_F(WallFileTest, AWallIsNoParticleAndAParticleIsNoWall) {
    write_template(path(), TemplateFile{}, sample_wall());
    EXPECT_NE(message_of<Error>([&] {
                  TemplateLibrary(path()).shape(0);
              }).find("is a wall made by shapegen --wall, expected a particle"),
              std::string::npos);
    TemplateFile ball;
    ball.shapes.push_back(sample::sphere(1e-3));
    write_template(path(), ball);
    EXPECT_FALSE(TemplateLibrary(path()).is_wall(0));
    EXPECT_NE(message_of<Error>([&] {
                  TemplateLibrary(path()).wall(0);
              }).find("expected a wall made by shapegen --wall"),
              std::string::npos);
}

TEST_F(WallFileTest, WallsThatContradictThemselvesAreRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::pair<const char*, std::function<void(WallTemplate&)>> wrong[] = {
        {"vertex of a wall is nan",
         [&](auto& w) { replace(w.mesh.vertices, 0, Vec3(nan, 0.0, 0.0)); }},
        {"farther than 1e6 m", [](auto& w) { replace(w.mesh.vertices, 0, Vec3(2e6, 0.0, 0.0)); }},
        {"names a vertex",
         [](auto& w) {
             replace(w.mesh.triangles, 0, {0U, 1U, 99U});
         }},
        {"has no area",
         [](auto& w) {
             replace(w.mesh.triangles, 0, {1U, 1U, 2U});
         }},
        {"has a twin that does not", [](auto& w) { replace(w.mesh.twins, 0, 99U); }},
        {"do not share it",
         [](auto& w) { replace(w.mesh.twins, 0, w.mesh.twins[0] == 5U ? 7U : 5U); }},
        {"bends by more", [](auto& w) { replace(w.mesh.bends, 0, 4.0); }},
        {"bends by more", [&](auto& w) { replace(w.mesh.bends, 0, nan); }},
        {"has no patch", [](auto& w) { replace(w.mesh.patches, 0, 6U); }},
        {"blending of a patch is -1", [](auto& w) { replace(w.mesh.blends, 0, -1.0); }},
        {"crease angle", [&](auto& w) { w.mesh.crease_angle = nan; }},
        {"crease angle", [&](auto& w) { w.mesh.crease_angle = 4.0; }},
        {"match its triangles", [](auto& w) { w.mesh.bends = std::vector<double>{0.0}; }},
        {"unit of the input", [](auto& w) { w.input_unit = 0.0; }},
        {"do not nest",
         [](auto& w) {
             auto box = w.mesh.boxes[1];
             box.next = 0;
             replace(w.mesh.boxes, 1, box);
         }},
        {"outside of its box",
         [](auto& w) {
             auto box = w.mesh.boxes[0];
             box.upper.x() = 0.5;
             replace(w.mesh.boxes, 0, box);
         }},
        {"in their order",
         [](auto& w) {
             auto box = w.mesh.boxes[1];
             box.first = 1;
             replace(w.mesh.boxes, 1, box);
         }},
        {"hold all of its", [](auto& w) { w.mesh.boxes = std::vector<WallMesh::Box>{}; }},
    };
    for (const auto& [expected, change] : wrong) {
        WallTemplate wall = sample_wall();
        change(wall);
        EXPECT_NE(refusal(wall).find(expected), std::string::npos)
            << expected << " <> " << refusal(wall);
        EXPECT_FALSE(std::filesystem::exists(path()));
    }
}

}  // namespace
}  // namespace dem
