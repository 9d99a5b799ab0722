// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_reader.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

const std::string profiles = DEM_SOURCE_DIR "/data/profiles/";

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

/// Runs the program in an empty folder of its own.
class ShapegenCli : public TemporaryFolder {
  protected:
    struct Result {
        int code;
        std::string out, err;
    };

    /// `before`: shell words in front of the program, `after`: behind the arguments.
    Result run(const std::string& arguments, const std::string& before = "",
               const std::string& after = "") const {
        const fs::path streams = folder_.string() + ".streams";
        fs::create_directory(streams);
        const std::string command = "cd " + folder_.string() + " && { " + before + " " +
                                    DEM_BINARY_DIR "/bin/shapegen " + arguments + " >" +
                                    (streams / "out").string() + " 2>" +
                                    (streams / "err").string() + " " + after + "; }";
        const int status = std::system(command.c_str());
        Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(streams / "out"),
                      content(streams / "err")};
        fs::remove_all(streams);
        return result;
    }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            names.insert(entry.path().filename().string());
        }
        return names;
    }

    /// One line that starts as promised and holds the words; nothing on stdout, no file left.
    void expect_failure(const Result& result, int code, const std::string& words) const {
        EXPECT_EQ(result.code, code) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err.rfind("shapegen: error: ", 0), 0U) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    }
};

TEST_F(ShapegenCli, CooksEveryProfileThatShips) {
    int cooked = 0;
    for (const auto& entry : fs::directory_iterator(profiles)) {
        if (entry.path().extension() != ".profile") continue;
        const Result result = run(entry.path().string() + " --quiet");
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.out + result.err, "");
        const fs::path made = folder_ / entry.path().filename().replace_extension(".tpl");
        const TemplateFile file = read_template(made);
        ASSERT_EQ(file.shapes.size(), 1U);
        EXPECT_EQ(std::get<SrShape>(file.shapes[0].shape).nodes.count, 2000U);
        for (const auto& [name, value] : file.shapes[0].certificate) {
            EXPECT_TRUE(std::isfinite(value)) << made << " " << name;
            if (name == "sdf_error_mean") {
                EXPECT_LT(value, 3e-5) << made;
            }
            if (name == "volume_error") {
                EXPECT_LT(value, 1e-8) << made;
            }
            if (name == "display_mesh_error_max") {
                EXPECT_LT(value, 1.2e-3) << made;
            }
        }
        ++cooked;
    }
    EXPECT_GE(cooked, 14);
}

TEST_F(ShapegenCli, GivesTheSameBytesTwiceAndForAnyNumberOfThreads) {
    ASSERT_EQ(run(profiles + "tablet.profile -q --threads 1").code, 0);
    const std::string first = content(folder_ / "tablet.tpl");
    ASSERT_EQ(run(profiles + "tablet.profile -q --threads 2").code, 0);
    EXPECT_EQ(content(folder_ / "tablet.tpl"), first);
    EXPECT_EQ(files(), std::set<std::string>{"tablet.tpl"});
}

TEST_F(ShapegenCli, ReportsWhatItCooked) {
    const Result result = run(profiles + "tablet.profile -o a.tpl --nodes 500");
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* word :
         {"tablet", "convex", "531.1042 mm^3", "500", "distance field", "a.tpl"}) {
        EXPECT_NE(result.out.find(word), std::string::npos) << word << " in\n" << result.out;
    }
}

TEST_F(ShapegenCli, InspectsAsTextAndAsJson) {
    ASSERT_EQ(run(profiles + "candy.profile -q").code, 0);
    EXPECT_NE(run("inspect candy.tpl").out.find("candy: sr, convex"), std::string::npos);
    const Result result = run("inspect candy.tpl --json");
    EXPECT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    const auto& shape = json["shapes"][0];
    EXPECT_EQ(shape["kind"], "sr");
    EXPECT_NEAR(shape["volume"].get<double>(), 6.166517e-7, 1e-13);
    EXPECT_EQ(shape["counts"]["nodes"], 2000);
    EXPECT_TRUE(shape["certificate"].contains("support_error_max"));
}

TEST_F(ShapegenCli, ScalesEveryKindOfInput) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 2\n");
    write("cube.convex", "units = mm\nshape = cuboid\nlength = 3\nwidth = 3\nheight = 3\n");
    write("tetrahedron.off",
          "OFF\n4 4 0\n0 0 0\n3 0 0\n0 3 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    for (const char* arguments :
         {"ball.profile", "ball.profile --sphere", "ball.profile --convex",
          "ball.profile --clump 0.9", "cube.convex", "tetrahedron.off --convex",
          "tetrahedron.off --clump-spheres 3 --resolution 20"}) {
        const std::string command = std::string(arguments) + " -q -o a.tpl --scale ";
        EXPECT_EQ(run(command + "1").code, 0) << arguments;
        const ParticleTemplate plain = read_template(folder_ / "a.tpl").shapes[0];
        EXPECT_EQ(run(command + "2.5").code, 0) << arguments;
        const ParticleTemplate scaled = read_template(folder_ / "a.tpl").shapes[0];
        EXPECT_NEAR(scaled.mass_properties.volume / plain.mass_properties.volume, cube(2.5), 1e-11)
            << arguments;
        EXPECT_NEAR(scaled.input_unit / plain.input_unit, 2.5, 1e-15) << arguments;
    }
    expect_failure(run("ball.profile --scale 0"), 2, "a number above 0");
}

TEST_F(ShapegenCli, InspectWritesLengthsInAUnitThatSuitsTheBody) {
    const auto described = [this](const std::string& profile) {
        write("a.profile", profile);
        return run("a.profile --sphere").out;
    };
    const std::string asteroid = described("shape = sphere\nradius = 250\n");
    EXPECT_NE(asteroid.find("equal volume: 500 m)"), std::string::npos) << asteroid;
    EXPECT_NE(asteroid.find("bounding radius   250 m\n"), std::string::npos) << asteroid;
    const std::string bead = described("units = mm\nshape = sphere\nradius = 2\n");
    EXPECT_NE(bead.find("33.51032 mm^3 (sphere of equal volume: 4 mm)"), std::string::npos) << bead;
    const std::string spore = described("units = um\nshape = sphere\nradius = 3\n");
    EXPECT_NE(spore.find("bounding radius   3 um\n"), std::string::npos) << spore;
}

TEST_F(ShapegenCli, InspectPrintsTheRotationFromTheBodyToTheInput) {
    // The longest side has the least moment, which is first: x of the body is z of the input.
    write("box.convex", "units = mm\nshape = cuboid\nlength = 2\nwidth = 4\nheight = 6\n");
    EXPECT_EQ(run("box.convex -q").code, 0);
    const std::string text = run("inspect box.tpl").out;
    const std::size_t at = text.find("  rotation          ");
    ASSERT_NE(at, std::string::npos) << text;
    std::istringstream words(text.substr(at + 20));
    Quat printed;
    words >> printed.w() >> printed.x() >> printed.y() >> printed.z();
    const Quat stored = read_template(folder_ / "box.tpl").shapes[0].mass_properties.principal_axes;
    EXPECT_LT((printed.coeffs() - stored.coeffs()).norm(), 1e-5);
    EXPECT_NE(text.find("from body to input's frame"), std::string::npos);
}

TEST_F(ShapegenCli, WritesASphereAsOneAndRefusesAnythingElse) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 2\n");
    EXPECT_EQ(run("ball.profile --sphere -q").code, 0);
    const TemplateFile file = read_template(folder_ / "ball.tpl");
    EXPECT_NEAR(std::get<Sphere>(file.shapes[0].shape).radius, 2e-3, 1e-15);
    expect_failure(run(profiles + "tablet.profile --sphere"), 1, "expected a sphere");
    EXPECT_EQ(files(), (std::set<std::string>{"ball.profile", "ball.tpl"}));
}

TEST_F(ShapegenCli, ExportsEveryFormat) {
    ASSERT_EQ(run(profiles + "tablet.profile -q").code, 0);
    for (const char* name : {"t.svg", "t.stl", "t.vtu", "t.csv", "t.obj"}) {
        const Result result = run("export tablet.tpl -o " + std::string(name));
        EXPECT_EQ(result.code, 0) << result.err;
    }
    const TemplateFile file = read_template(folder_ / "tablet.tpl");
    EXPECT_EQ(fs::file_size(folder_ / "t.stl"),
              84 + 50 * file.shapes[0].display_mesh.triangles.size());
    EXPECT_EQ(content(folder_ / "t.svg").rfind("<svg", 0), 0U);
    EXPECT_EQ(content(folder_ / "t.vtu").rfind("<?xml", 0), 0U);
    const std::string csv = content(folder_ / "t.csv");
    EXPECT_EQ(csv.rfind("x,y,z,mean_curvature\n", 0), 0U);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2001);
    expect_failure(run("export tablet.tpl -o t.docx"), 2, ".svg, .stl, .obj, .vtu or .csv");
    expect_failure(run("export tablet.tpl -o t.stl --shape 1"), 1, "no shape '1'");
}

TEST_F(ShapegenCli, RefusesAWrongCommandLineWithCodeTwo) {
    expect_failure(run(""), 2, "no input");
    expect_failure(run("a.profile --node 10"), 2, "did you mean '--nodes'?");
    expect_failure(run("a.profile b.profile"), 2, "second input 'b.profile'");
    expect_failure(run("a.profile --nodes many"), 2, "many");
    expect_failure(run("a.profile --nodes -5"), 2,
                   "--nodes: found '-5', expected a whole number from");
    expect_failure(run("a.profile --base-cells 0"), 2, "found '0'");
    expect_failure(run("a.profile --nodes 5"), 2, "from 100 to");
    expect_failure(run("a.profile --interface-cells 150"), 2, "power of two");
    expect_failure(run("a.profile --sr --sphere"), 2, "one of them");
    expect_failure(run("export a.tpl"), 2, "-o");
    EXPECT_TRUE(files().empty());
}

TEST_F(ShapegenCli, NamesAFileThatIsMissingOrOfTheWrongKind) {
    expect_failure(run("nothing.profile"), 1, "nothing.profile");
    expect_failure(run("inspect nothing.tpl"), 1, "nothing.tpl");
    write("rubbish.tpl", "this is no template");
    expect_failure(run("inspect rubbish.tpl"), 1, "rubbish.tpl");
    write("bunny.stl", "solid bunny");
    expect_failure(run("bunny.stl"), 2,
                   "expected --clump C, --clump-spheres N, --clump-error E%, --convex or --wall");
}

TEST_F(ShapegenCli, NeverWaitsForAPipeNorTakesAFolderForAFile) {
    const std::vector<std::string> modes = {"p.profile", "p.convex", "p.stl --convex",
                                            "p.glb --clump 0.9", "inspect p.tpl"};
    for (const std::string& mode : modes) {
        std::string name = mode.substr(mode.find("p."));
        name = name.substr(0, name.find(' '));
        ASSERT_EQ(mkfifo((folder_ / name).c_str(), 0600), 0);
        const std::string output = mode.starts_with("inspect") ? "" : " -o out.tpl";
        expect_failure(run(mode + output, "timeout 10"), 1, name + ": is a pipe");
        fs::remove(folder_ / name);
        fs::create_directory(folder_ / name);
        expect_failure(run(mode + output), 1, name + ": is a folder, expected a ");
        fs::remove(folder_ / name);
        fs::create_symlink("nothing", folder_ / name);
        expect_failure(run(mode + output), 1, name + ": is a link to nothing, expected a ");
    }
    fs::create_symlink(profiles + "tablet.profile", folder_ / "link.profile");
    EXPECT_EQ(run("link.profile -q -o out.tpl").code, 0);
}

TEST_F(ShapegenCli, TakesCountsWithAnExponent) {
    ASSERT_EQ(run(profiles + "tablet.profile -q -o a.tpl --nodes 5e2 --threads 1.0").code, 0);
    const TemplateFile file = read_template(folder_ / "a.tpl");
    EXPECT_EQ(std::get<SrShape>(file.shapes.at(0).shape).nodes.count, 500U);
    expect_failure(run("a.profile --nodes 5.5e0"), 2,
                   "--nodes: found '5.5e0', expected a whole number from 100 to 1000000");
}

TEST_F(ShapegenCli, NamesTheExtensionThatItDoesNotRead) {
    for (const char* name :
         {"part.step", "part.stp", "part.iges", "part.3mf", "part.vtk", "part.shp"}) {
        write(name, "whatever");
        const std::string extension = std::filesystem::path(name).extension().string();
        for (const char* mode : {"", " --clump 0.9", " --convex"})
            expect_failure(run(name + std::string(mode)), 1,
                           std::string(name) + ": found the extension '" + extension +
                               "', expected a mesh (.stl, .obj, .ply, .off, .gltf or .glb), a "
                               ".profile or a .convex file");
    }
    expect_failure(run("part"), 1, "part: found no extension, expected a mesh");
}

TEST_F(ShapegenCli, MakesOneBodyOfPartsWhenAsked) {
    const std::string parts =
        "'" DEM_SOURCE_DIR "/tests/shapegen/import/faults/overlapping_boxes.obj'";
    expect_failure(run(parts + " --convex"), 1, "--union joins them");
    const Result result = run(parts + " --convex --rounding 0% --union --unit m -o parts.tpl");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("parts that cross, touch or hold each other: 2"), std::string::npos);
    const TemplateFile file = read_template(folder_ / "parts.tpl");
    EXPECT_NEAR(file.shapes.at(0).mass_properties.volume, 1.9, 1e-12);
    expect_failure(run(profiles + "tablet.profile --union"), 2, "expected it with a mesh");
}

TEST_F(ShapegenCli, NeverOverwritesItsInput) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 2\n");
    const std::string before = content(folder_ / "ball.profile");
    std::filesystem::create_symlink("ball.profile", folder_ / "ball.tpl");
    expect_failure(run("ball.profile -o ball.tpl"), 2, "the input itself");
    expect_failure(run("ball.profile -o ./ball.profile"), 2, "expected a name that ends in .tpl");
    expect_failure(run("generate sand --count 3 -o sand.svg"), 2, "a name that ends in .tpl");
    EXPECT_EQ(content(folder_ / "ball.profile"), before);
}

TEST_F(ShapegenCli, LeavesNothingBehindWhenTheOutputCannotBeWritten) {
    expect_failure(run(profiles + "tablet.profile -o no/such/folder.tpl"), 1, "no/such/folder.tpl");
    // A limit on the size of files stands for a full disk.
    expect_failure(run(profiles + "tablet.profile", "trap '' XFSZ; ulimit -f 8;"), 1, "tablet.tpl");
    EXPECT_TRUE(files().empty());
    write("old.tpl", "kept");
    expect_failure(run(profiles + "tablet.profile -o old.tpl", "trap '' XFSZ; ulimit -f 8;"), 1,
                   "old.tpl");
    EXPECT_EQ(content(folder_ / "old.tpl"), "kept");
    EXPECT_EQ(files(), std::set<std::string>{"old.tpl"});
}

TEST_F(ShapegenCli, LeavesNothingBehindWhenItIsInterrupted) {
    const Result result =
        run("'" DEM_SOURCE_DIR "/data/meshes/bunny.ply' --clump 0.99 --inscribed --resolution 300",
            "timeout --preserve-status -s INT 0.5");
    EXPECT_EQ(result.code, 130);
    EXPECT_NE(result.err.find("interrupted, nothing written"), std::string::npos) << result.err;
    EXPECT_TRUE(files().empty());
}

TEST_F(ShapegenCli, KeepsOnWhenASignalIsIgnored) {
    const Result result =
        run("'" DEM_SOURCE_DIR "/data/meshes/bunny.ply' --clump-spheres 20 -o bunny.tpl",
            "sh -c 'trap \"\" HUP; (sleep 0.1; kill -HUP $$) & exec \"$@\"' sh");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(files(), std::set<std::string>{"bunny.tpl"});
}

TEST_F(ShapegenCli, FailsWhenStandardOutputIsFull) {
    const Result result = run("--help", "", ">/dev/full");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("standard output"), std::string::npos);
}

TEST_F(ShapegenCli, ExplainsItself) {
    const Result help = run("--help");
    EXPECT_EQ(help.code, 0);
    for (const char* word : {"--nodes", "inspect", "export", "Exit codes", "Example"}) {
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
    }
    const Result manual = run("--man");
    EXPECT_EQ(manual.code, 0);
    EXPECT_EQ(manual.out.rfind(".TH SHAPEGEN 1", 0), 0U);
    const Result version = run("--version");
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out, "shapegen " DEM_VERSION "\n");
}

}  // namespace
}  // namespace dem
