// SPDX-License-Identifier: BSD-3-Clause
// `shapegen SHAPE.convex`, `shapegen MESH --convex` and `shapegen generate` as a user types them.
#include "shapegen/mesh/triangle_mesh.hpp"
#include "tests/cli/shapegen_fixture.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

namespace fs = std::filesystem;

const std::string bunny = "'" DEM_SOURCE_DIR "/data/meshes/bunny.ply'";

std::string off_file(const TriangleMesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
    for (const Vec3& v : mesh.vertices) text << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    for (const auto& t : mesh.triangles) text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    return text.str();
}

/// An L of three unit cubes, extruded: its hull has 3.5 of them.
std::string l_shape() {
    const double x[6] = {0, 2, 2, 1, 1, 0};
    const double y[6] = {0, 0, 1, 1, 2, 2};
    TriangleMesh mesh;
    for (const double z : {0.0, 1.0})
        for (int k = 0; k < 6; ++k) mesh.vertices.emplace_back(x[k], y[k], z);
    for (const auto& t : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
        mesh.triangles.push_back({t[0], t[2], t[1]});
        mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    }
    for (std::uint32_t k = 0; k < 6; ++k) {
        const std::uint32_t next = (k + 1) % 6;
        mesh.triangles.push_back({k, next, next + 6});
        mesh.triangles.push_back({k, next + 6, k + 6});
    }
    return off_file(mesh);
}

std::map<std::string, double> certificate(const ParticleTemplate& shape) {
    return {shape.certificate.begin(), shape.certificate.end()};
}

class ShapegenConvex : public ShapegenFixture {};

TEST_F(ShapegenConvex, CooksEveryFileOfTheData) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(DEM_SOURCE_DIR "/data/convex")) {
        const ParticleTemplate shape = cook("'" + entry.path().string() + "'");
        EXPECT_EQ(shape.name, entry.path().stem());
        EXPECT_TRUE(shape.is_convex);
        EXPECT_EQ(shape.input_unit, 1e-3);
        EXPECT_FALSE(shape.display_mesh.triangles.empty());
        EXPECT_LT(certificate(shape).at("display_mesh_error_max"), 2.5e-3);
        ++files;
    }
    EXPECT_GE(files, 10);
}

TEST_F(ShapegenConvex, SaysHowMuchTheHullAddsToAMesh) {
    write("l.off", l_shape());
    const ParticleTemplate shape = cook("l.off --convex --rounding 0% --unit m");
    EXPECT_NEAR(shape.mass_properties.volume, 3.5, 1e-12);
    EXPECT_NEAR(certificate(shape).at("hull_excess"), 0.5 / 3.0, 1e-12);
    EXPECT_EQ(std::get<ConvexShape>(shape.shape).vertices.size(), 10U);
    // Two halves of the hull: the square less the triangle at its corner, whose center is known.
    const Vec3 center((4.0 * 1.0 - 0.5 * 5.0 / 3.0) / 3.5, (4.0 * 1.0 - 0.5 * 5.0 / 3.0) / 3.5,
                      0.5);
    EXPECT_LT((shape.mass_properties.center_of_mass - center).norm(), 1e-12);
    const Outcome outcome = run("l.off --convex --unit m");
    EXPECT_NE(outcome.output.find("adds 16.7 % to the volume"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("which takes"), std::string::npos) << outcome.output;
}

TEST_F(ShapegenConvex, AConvexMeshIsItsOwnHull) {
    write("ball.off", off_file(sample::sphere(1.0, 3)));
    const ParticleTemplate shape = cook("ball.off --convex --rounding 0%");
    EXPECT_NEAR(certificate(shape).at("hull_excess"), 0.0, 1e-6);
    const ParticleTemplate rounded = cook("ball.off --convex");
    EXPECT_NEAR(certificate(rounded).at("rounding"), 0.01, 1e-5);
    EXPECT_GT(certificate(rounded).at("rounding_loss"), 0.0);
    EXPECT_LT(certificate(rounded).at("rounding_loss"), 1e-3);
}

TEST_F(ShapegenConvex, KeepsTheVerticesOfTheBunnyThatMatterMost) {
    const ParticleTemplate full = cook(bunny + " --convex");
    const ParticleTemplate few = cook(bunny + " --convex --vertices 50");
    const auto& core = std::get<ConvexShape>(few.shape);
    EXPECT_EQ(core.vertices.size(), 50U);
    const double d_eq = core.equivalent_diameter;
    const double error = certificate(few).at("hull_error_max") * d_eq;
    const MassProperties& mass = few.mass_properties;
    const auto& full_core = std::get<ConvexShape>(full.shape);
    double farthest = 0.0;
    for (const Vec3& v : full_core.vertices) {
        const Vec3 in_input =
            full.mass_properties.center_of_mass + full.mass_properties.principal_axes * v;
        const Vec3 in_few = mass.principal_axes.conjugate() * (in_input - mass.center_of_mass);
        farthest = std::max(farthest, core_distance(core, in_few).distance);
    }
    EXPECT_NEAR(farthest, error, 1e-7 * d_eq);
    EXPECT_LT(error, 0.03 * d_eq);
    EXPECT_NEAR(mass.volume / full.mass_properties.volume, 1.0 - certificate(few).at("hull_loss"),
                1e-9);
    // The hull's volume from its display mesh, which shares no code with the certificate.
    const DisplayMesh& mesh = full.display_mesh;
    const double shown = enclosed_volume({{mesh.vertices.begin(), mesh.vertices.end()},
                                          {mesh.triangles.begin(), mesh.triangles.end()}});
    EXPECT_NEAR(shown / full.mass_properties.volume, 1.0, 5e-3);
    EXPECT_NEAR(certificate(full).at("hull_excess"), 0.657, 0.001);
}

TEST_F(ShapegenConvex, KeepsTheVolumeOfTheMeshWhateverHullVerticesAndRoundingDoToIt) {
    write("l.off", l_shape());
    for (const char* options : {"", " --rounding 0%", " --rounding '50 mm' --vertices 6"}) {
        const std::string command = "l.off --convex --unit m" + std::string(options);
        const ParticleTemplate plain = cook(command);
        const ParticleTemplate kept = cook(command + " --keep-volume");
        EXPECT_NEAR(kept.mass_properties.volume, 3.0, 1e-11) << options;
        // Of the same shape about the same center, its rounding the one asked for.
        const auto& before = std::get<ConvexShape>(plain.shape);
        const auto& after = std::get<ConvexShape>(kept.shape);
        EXPECT_EQ(after.rounding, before.rounding);
        EXPECT_EQ(after.vertices.size(), before.vertices.size());
        const double scale = certificate(kept).at("core_scale");
        EXPECT_EQ(certificate(plain).at("core_scale"), 1.0);
        for (std::size_t k = 0; k < after.vertices.size(); ++k)
            EXPECT_NEAR(after.vertices[k].norm(), scale * before.vertices[k].norm(), 0.02) << k;
        EXPECT_LT(
            (kept.mass_properties.center_of_mass - plain.mass_properties.center_of_mass).norm(),
            0.01);
    }
    const Outcome said = run("l.off --convex --unit m --rounding 0%");
    EXPECT_NE(said.output.find("the body has 116.7 % of the volume of the mesh, to which "
                               "--keep-volume"),
              std::string::npos)
        << said.output;
    EXPECT_NE(run("l.off --convex --unit m --keep-volume").output.find("core scaled by 0.9"),
              std::string::npos);
}

TEST_F(ShapegenConvex, GeneratesTheSameLibraryForAnyNumberOfThreads) {
    const std::string command = "generate sand --count 300 --seed 4";
    cook(command + " --threads 1");
    const std::string first = content(folder_ / "out.tpl");
    const TemplateFile library = cook_file(command + " --threads 3");
    EXPECT_EQ(content(folder_ / "out.tpl"), first);
    ASSERT_EQ(library.shapes.size(), 300U);
    EXPECT_EQ(library.shapes[17].name, "sand_000017");
    // A shorter library is its beginning; another seed is another library.
    const TemplateFile shorter = cook_file("generate sand --count 20 --seed 4");
    const TemplateFile other = cook_file("generate sand --count 20 --seed 5");
    EXPECT_NE(other.input_hash, shorter.input_hash);
    for (std::size_t k = 0; k < 20; ++k) {
        const double volume = library.shapes[k].mass_properties.volume;
        EXPECT_EQ(shorter.shapes[k].mass_properties.volume, volume);
        EXPECT_NE(other.shapes[k].mass_properties.volume, volume);
    }
}

TEST_F(ShapegenConvex, SizesOfGeneratedShapesScaleAndPicturesShowThem) {
    const TemplateFile small = cook_file("generate woodchips --count 30 --size '6 mm'");
    const TemplateFile large = cook_file("generate woodchips --count 30 --size '12 mm'");
    for (std::size_t k = 0; k < 30; ++k)
        EXPECT_NEAR(large.shapes[k].mass_properties.volume,
                    8.0 * small.shapes[k].mass_properties.volume,
                    1e-9 * large.shapes[k].mass_properties.volume);
    EXPECT_EQ(run("export out.tpl -o sheet.svg").code, 0);
    const std::string sheet = content(folder_ / "sheet.svg");
    EXPECT_NE(sheet.find("woodchip_000024"), std::string::npos);
    EXPECT_EQ(sheet.find("woodchip_000025"), std::string::npos);
    EXPECT_EQ(run("export out.tpl --shape 3 -o one.stl").code, 0);
    EXPECT_EQ(run("export out.tpl --shape woodchip_000003 -o one.vtu").code, 0);
    EXPECT_EQ(run("export out.tpl --shape 3 -o one.svg").code, 0);
    EXPECT_EQ(run("export out.tpl -o all.stl").code, 2);
}

TEST_F(ShapegenConvex, SaysHowManyShapesFitBeforeItMakesThemAll) {
    expect_failure("generate woodchips --rounding 0% --count 100000000", 1,
                   "a template holds 2 GB");
}

TEST_F(ShapegenConvex, RefusesAWrongCommandLine) {
    write("ball.off", off_file(sample::sphere(1.0, 1)));
    write("ball.convex", "shape = sphere\nradius = 1 mm\n");
    expect_failure("ball.off --vertices 20", 2, "without --convex");
    expect_failure("ball.off --keep-volume", 2, "without --convex");
    expect_failure("ball.convex --keep-volume", 2, "expected it with a mesh");
    expect_failure("ball.off --convex --clump 0.9", 2, "expected one of them");
    expect_failure("ball.off --convex --vertices 3", 2, "from 4 to");
    expect_failure("ball.off --convex --rounding 0.1", 2, "a length with its unit");
    expect_failure("ball.off --convex --rounding ' -1%'", 2, "zero or more");
    expect_failure("ball.off --convex --nodes 500", 2, "with --sr only");
    expect_failure("ball.convex --clump 0.9", 2, "expected it with a mesh or a profile");
    expect_failure("ball.convex --vertices 9", 2, "expected it with a mesh");
    expect_failure("ball.convex --unit mm", 2, "expected it with a mesh");
    expect_failure("ball.convex --rounding 1%", 1, "no edges");
    expect_failure("generate", 2, "sand or woodchips");
    expect_failure("generate gravel --count 3", 2, "expected sand or woodchips");
    expect_failure("generate sand", 2, "found no --count");
    expect_failure("generate sand --count 0", 2, "found '0', expected a whole number from 1 to");
    expect_failure("generate sand --count 3 --seed -1", 2, "found '-1'");
    expect_failure("generate sand --count 3 --template cube", 2, "sphere or ellipsoid");
    expect_failure("generate woodchips --count 3 --template sphere", 2, "with sand");
    expect_failure("generate sand --count 3 --size 5", 2, "a length with its unit");
    expect_failure("generate sand --count 3 --size '-5 mm'", 2, "above 0");
    expect_failure("generate sand --count 3 --rounding 60%", 1, "--rounding: no hull of 1000");
}

TEST_F(ShapegenConvex, RefusesWhatIsNoBody) {
    expect_failure("none.convex", 1, "no such file");
    write("flat.convex", "shape = polyhedron\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    expect_failure("flat.convex", 1, "flat.convex:1: convex hull: all 4 points lie in one plane");
    write("nan.convex", "shape = cuboid\nlength = 1\nwidth = nan\nheight = 1\n");
    expect_failure("nan.convex", 1, "nan.convex:3");
    write("sheet.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    expect_failure("sheet.off --convex", 1, "sheet.off");
    write("ball.off", off_file(sample::sphere(1.0, 1)));
    expect_failure("ball.off --convex --rounding '2 mm'", 1, "ball.off: ");
    expect_failure("'" DEM_SOURCE_DIR "/data/profiles/peanut.profile' --convex", 1,
                   "expected --sr");
}

}  // namespace
}  // namespace dem::shapegen
