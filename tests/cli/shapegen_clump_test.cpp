// SPDX-License-Identifier: BSD-3-Clause
// `shapegen MESH|PROFILE --clump ...` as a user types it.
#include "tests/cli/shapegen_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dem {
namespace {

namespace fs = std::filesystem;

const std::string candy = "'" DEM_SOURCE_DIR "/data/profiles/candy.profile'";
const std::string coarse = " --resolution 20";

/// An OFF file of boxes, each with a corner and a size; a negative size along x is inside out.
std::string boxes(const std::vector<std::pair<Vec3, Vec3>>& all) {
    std::ostringstream points;
    std::ostringstream faces;
    points.precision(17);
    int first = 0;
    for (const auto& [corner, size] : all) {
        for (int k = 0; k < 8; ++k)
            points << corner.x() + (k & 1) * size.x() << ' ' << corner.y() + (k >> 1 & 1) * size.y()
                   << ' ' << corner.z() + (k >> 2) * size.z() << '\n';
        constexpr int corners[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                        {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                        {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
        for (const auto& [a, b, c] : corners)
            faces << "3 " << first + a << ' ' << first + b << ' ' << first + c << '\n';
        first += 8;
    }
    return "OFF\n" + std::to_string(first) + ' ' + std::to_string(12 * all.size()) + " 0\n" +
           points.str() + faces.str();
}

std::string box(const Vec3& corner = Vec3(10.0, -20.0, 5.0)) {
    return boxes({{corner, Vec3(2.0, 3.0, 4.0)}});
}

class ShapegenClump : public ShapegenFixture {};

double entry(const ParticleTemplate& shape, const std::string& name) {
    for (const auto& [key, value] : shape.certificate)
        if (key == name) return value;
    ADD_FAILURE() << "no " << name;
    return NAN;
}

TEST_F(ShapegenClump, KeepsTheMassAndTheFrameOfTheMesh) {
    write("box.off", box());
    const ParticleTemplate shape = cook("box.off --clump-spheres 30 --unit mm" + coarse);
    const auto& clump = std::get<Clump>(shape.shape);
    ASSERT_EQ(clump.spheres.size(), 30U);
    const MassProperties& mass = shape.mass_properties;
    EXPECT_NEAR(mass.volume, 24e-9, 1e-17);
    EXPECT_LT((mass.center_of_mass - Vec3(11e-3, -18.5e-3, 7e-3)).norm(), 1e-12);
    EXPECT_EQ(shape.input_unit, 1e-3);
    EXPECT_TRUE(shape.is_convex);
    // About the body axes, which are those of the box in some order, spheres must stay inside but
    // for the protrusion, and their masses add up to the box's volume and center.
    const double protrusion = 0.01 * equivalent_diameter(mass.volume);
    double volume = 0.0;
    Vec3 center = Vec3::Zero();
    for (const ClumpSphere& s : clump.spheres) {
        const Vec3 in_input = mass.center_of_mass + mass.principal_axes * s.center();
        const Vec3 offset = (in_input - Vec3(11e-3, -18.5e-3, 7e-3)).cwiseAbs();
        const Vec3 room = Vec3(1e-3, 1.5e-3, 2e-3) - offset - Vec3::Constant(s.radius);
        EXPECT_GT(room.minCoeff(), -1.001 * protrusion);
        volume += s.volume_share;
        center += s.volume_share * s.center();
    }
    EXPECT_NEAR(volume, mass.volume, 1e-9 * mass.volume);
    EXPECT_LT(center.norm(), 1e-9 * mass.volume * shape.bounding_radius);
}

TEST_F(ShapegenClump, ReachesTheCoverageWithInscribedSpheres) {
    const ParticleTemplate shape = cook(candy + " --clump 85% --inscribed" + coarse);
    EXPECT_GE(entry(shape, "coverage"), 0.85);
    EXPECT_EQ(entry(shape, "outside"), 0.0);
    EXPECT_LT(entry(shape, "max_deviation_out"), 1e-9);
    EXPECT_LT(std::get<Clump>(shape.shape).spheres.size(), 25U);
}

TEST_F(ShapegenClump, ReachesTheErrorWithFewSpheres) {
    write("box.off", box());
    const ParticleTemplate shape = cook("box.off --clump-error 6%" + coarse);
    EXPECT_LE(entry(shape, "rms_deviation"), 0.06);
    EXPECT_GT(entry(shape, "rms_deviation"), 0.04);
    EXPECT_LT(std::get<Clump>(shape.shape).spheres.size(), 16U);
}

TEST_F(ShapegenClump, GivesTheSameSpheresForAnyNumberOfThreads) {
    cook(candy + " --clump-spheres 12" + coarse + " --threads 1");
    const std::string first = content(folder_ / "out.tpl");
    cook(candy + " --clump-spheres 12" + coarse + " --threads 3");
    EXPECT_EQ(content(folder_ / "out.tpl"), first);
}

TEST_F(ShapegenClump, ShowsItsCertificate) {
    write("box.off", box());
    const Outcome cooked = run("box.off --clump-spheres 1" + coarse);
    EXPECT_EQ(cooked.code, 0) << cooked.errors;
    for (const char* word : {"12 triangles, 2 x 3 x 4 mm (assumed", "spheres           1\n",
                             "surface of the spheres against", "about z", "box.tpl: "})
        EXPECT_NE(cooked.output.find(word), std::string::npos) << word << " in\n" << cooked.output;
    const auto json = nlohmann::json::parse(run("inspect box.tpl --json").output);
    const auto& shape = json["shapes"][0];
    EXPECT_EQ(shape["kind"], "clump");
    EXPECT_EQ(shape["counts"]["spheres"], 1);
    const auto& certificate = shape["certificate"];
    for (const char* name : {"coverage", "volume_ratio", "rms_deviation", "max_deviation_in",
                             "max_deviation_out", "slope_rms", "ceiling"})
        EXPECT_TRUE(certificate[name].is_number()) << name;
    EXPECT_EQ(certificate["moment_errors"].size(), 3U);
    // The largest ball in a box: of radius 1 in a volume of 24.
    EXPECT_NEAR(certificate["coverage"].get<double>(), 4.0 * pi / 3.0 / 24.0, 0.03);
}

/// Rows of numbers of a table, without what is no number.
std::vector<std::vector<double>> numbers(const fs::path& path, char separator) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(content(path));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) continue;
        std::vector<double> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, separator);) {
            char* end = nullptr;
            const double value = std::strtod(cell.c_str(), &end);
            if (end != cell.c_str() && *end == '\0') row.push_back(value);
        }
        if (row.size() > 2) rows.push_back(row);
    }
    return rows;
}

TEST_F(ShapegenClump, ExportsSpheresThatLieOnTheInput) {
    write("box.off", box());
    cook("box.off --clump-spheres 12 --unit cm --scale 2" + coarse);
    EXPECT_EQ(run("export out.tpl -o spheres.csv").code, 0);
    const auto rows = numbers(folder_ / "spheres.csv", ',');
    ASSERT_EQ(rows.size(), 12U);
    double mass = 0.0;
    Vec3 center = Vec3::Zero();
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 5U);
        const Vec3 offset = (Vec3(row[0], row[1], row[2]) - Vec3(11.0, -18.5, 7.0)).cwiseAbs();
        EXPECT_GT((Vec3(1.0, 1.5, 2.0) - offset).minCoeff() - row[3], -0.05);
        mass += row[4];
        center += row[4] * Vec3(row[0], row[1], row[2]);
    }
    EXPECT_NEAR(mass, 24.0, 1e-9);
    EXPECT_LT((center / mass - Vec3(11.0, -18.5, 7.0)).norm(), 1e-7);
}

TEST_F(ShapegenClump, ExportsPicturesAndSurfaces) {
    write("box.off", box());
    cook("box.off --clump-spheres 3" + coarse);
    for (const char* name : {"c.vtu", "c.stl", "c.obj", "c.svg"})
        EXPECT_EQ(run("export out.tpl -o " + std::string(name)).code, 0) << name;
    const std::string vtu = content(folder_ / "c.vtu");
    EXPECT_NE(vtu.find("Name=\"deviation\""), std::string::npos);
    EXPECT_NE(vtu.find("Name=\"part\""), std::string::npos);
    const std::string obj = content(folder_ / "c.obj");
    EXPECT_NE(obj.find("o body\n"), std::string::npos);
    EXPECT_NE(obj.find("o clump\n"), std::string::npos);
    EXPECT_NE(content(folder_ / "c.svg").find("3 spheres; coverage"), std::string::npos);
    // The box has 12 triangles, the spheres have the others.
    const auto faces = std::count(obj.begin(), obj.end(), 'f');
    EXPECT_EQ(fs::file_size(folder_ / "c.stl"), 84 + 50 * static_cast<std::size_t>(faces - 12));
}

TEST_F(ShapegenClump, WritesTheFilesOfOtherCodes) {
    write("box.off", box());
    const ParticleTemplate shape = cook("box.off --clump-spheres 6" + coarse);
    const double mass = 2000.0 * shape.mass_properties.volume;
    for (const char* code : {"liggghts", "lammps", "yade", "mercurydpm", "dem-engine"}) {
        const std::string format = " --format " + std::string(code);
        EXPECT_EQ(run("export out.tpl -o " + std::string(code) + format + " --density 2000").code,
                  0)
            << code;
    }
    const auto& spheres = std::get<Clump>(shape.shape).spheres;
    const auto expect_spheres = [&](const fs::path& path, char separator, std::size_t columns) {
        const auto rows = numbers(folder_ / path, separator);
        ASSERT_EQ(rows.size(), spheres.size()) << path;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            ASSERT_EQ(rows[i].size(), columns) << path;
            EXPECT_EQ(Vec3(rows[i][0], rows[i][1], rows[i][2]), spheres[i].center());
            EXPECT_EQ(rows[i][3], spheres[i].radius);
        }
    };
    expect_spheres("liggghts", ' ', 4);
    expect_spheres("yade", ' ', 6);
    expect_spheres("mercurydpm/clump/clump.txt", ',', 4);
    expect_spheres("dem-engine", ',', 4);
    EXPECT_NEAR(std::stod(content(folder_ / "mercurydpm/inertia/mass.txt")), mass, 1e-12 * mass);
    const auto inertia = numbers(folder_ / "mercurydpm/inertia/toi.txt", ',');
    ASSERT_EQ(inertia.size(), 3U);
    EXPECT_NEAR(inertia[1][1], 2000.0 * shape.mass_properties.principal_moments_per_density.y(),
                1e-12 * inertia[1][1]);
    const std::string molecule = content(folder_ / "lammps");
    for (const char* word : {"6 atoms\n", "0 0 0 com\n", "\nCoords\n\n1 ", "\nDiameters\n\n1 ",
                             "\nMasses\n\n1 ", "\nTypes\n\n1 1\n"})
        EXPECT_NE(molecule.find(word), std::string::npos) << word;
    EXPECT_NE(run("export out.tpl -o x --format lamps").errors.find("did you mean 'lammps'?"),
              std::string::npos);
    EXPECT_NE(run("export out.tpl -o x --format yade --density -1").errors.find("density above 0"),
              std::string::npos);
    EXPECT_NE(run("export out.tpl -o x.docx").errors.find("expected .svg, .stl"),
              std::string::npos);
}

TEST_F(ShapegenClump, WritesTheConvergence) {
    write("box.off", box());
    cook("box.off --clump-spheres 3 --convergence table.csv" + coarse);
    const auto rows = numbers(folder_ / "table.csv", ',');
    ASSERT_EQ(rows.size(), 3U);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].size(), 11U);
        EXPECT_EQ(rows[i][0], static_cast<double>(i + 1));
        if (i > 0) {
            EXPECT_GT(rows[i][1], rows[i - 1][1]);
        }
    }
    cook("box.off --clump-spheres 2 --convergence plot.svg" + coarse);
    EXPECT_EQ(content(folder_ / "plot.svg").rfind("<svg", 0), 0U);
}

TEST_F(ShapegenClump, RefusesAWrongCommandLine) {
    write("box.off", box());
    for (const char* value : {"1.5", "1", "0", "-0.5", "much", "101%", "nan"})
        expect_failure("box.off --clump " + std::string(value), 2, "above 0 and below 1");
    expect_failure("box.off --clump-spheres 0", 2,
                   "found '0', expected a whole number from 1 to 65535");
    expect_failure("box.off --clump-spheres 65536", 2, "from 1 to 65535");
    expect_failure("box.off --clump-error 0%", 2, "RMS deviation above 0");
    expect_failure("box.off --clump-error 0.5", 2, "'0.5', expected an RMS deviation above 0%");
    expect_failure("box.off --clump 0.9 --clump-spheres 5", 2, "expected one of them");
    expect_failure("box.off", 2, "found a mesh without a mode");
    expect_failure("box.off --inscribed", 2, "without --clump");
    expect_failure(candy + " --resolution 30", 2, "without --clump");
    expect_failure("box.off --clump 0.9 --inscribed --protrusion 1%", 2, "one of them");
    expect_failure("box.off --clump 0.9 --protrusion 60%", 2, "below 50 %");
    expect_failure("box.off --clump 0.9 --min-radius 3", 2, "a length with its unit");
    expect_failure("box.off --clump 0.9 --min-radius '3 kg'", 2, "kg");
    expect_failure("box.off --clump 0.9 --skeleton surfaces", 2, "surface or curve");
    expect_failure("box.off --clump 0.9 --resolution 5", 2, "from 10 to 500");
    expect_failure("box.off --clump 0.9 --unit parsec", 2, "parsec");
    expect_failure("box.off --clump 0.9 --scale 0", 2, "a number above 0");
    expect_failure("box.off --clump 0.9 --repair-limit 2", 2, "below 1");
    expect_failure("box.off --clump 0.9 --nodes 500", 2, "with --sr only");
    expect_failure(candy + " --clump 0.9 --sr", 2, "expected one of them");
    expect_failure(candy + " --clump 0.9 --unit mm", 2, "expected it with a mesh");
    expect_failure("box.off --clump 0.9 --convergence table.pdf", 2, ".csv or .svg");
}

TEST_F(ShapegenClump, RefusesWhatIsNoBody) {
    const std::string mode = " --clump-spheres 5" + coarse;
    write("empty.off", "");
    expect_failure("empty.off" + mode, 1, "an empty file");
    write("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_failure("triangle.off" + mode, 1, "triangle.off");
    write("sheet.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    expect_failure("sheet.off" + mode, 1, "sheet.off");
    write("nan.off",
          "OFF\n4 4 0\n0 0 0\nnan 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    expect_failure("nan.off" + mode, 1, "nan.off");
    expect_failure("none.stl" + mode, 1, "no such file");
}

TEST_F(ShapegenClump, RefusesTwoBodiesUnlessTheLargestIsWanted) {
    write("two.off", boxes({{Vec3::Zero(), Vec3::Ones()}, {Vec3(3, 0, 0), Vec3(1, 1, 2)}}));
    expect_failure("two.off --clump-spheres 5" + coarse, 1, "--largest");
    const ParticleTemplate shape = cook("two.off --clump-spheres 5 --largest" + coarse);
    EXPECT_NEAR(shape.mass_properties.volume, 2e-9, 1e-18);
    const Outcome said = run("two.off --clump-spheres 5 --largest -o said.tpl" + coarse);
    EXPECT_NE((said.output + said.errors).find("50 % of the volume of the largest"),
              std::string::npos)
        << said.output << said.errors;
}

TEST_F(ShapegenClump, TakesAnInnerShellForAHollowAndTurnsWhatIsInsideOut) {
    write("hollow.off", boxes({{Vec3::Zero(), Vec3(4, 4, 4)}, {Vec3(3, 1, 1), Vec3(-2, 2, 2)}}));
    const ParticleTemplate hollow = cook("hollow.off --clump-spheres 20" + coarse);
    EXPECT_NEAR(hollow.mass_properties.volume, 56e-9, 1e-17);
    EXPECT_FALSE(hollow.is_convex);
    for (const ClumpSphere& s : std::get<Clump>(hollow.shape).spheres)
        EXPECT_GT(s.center().cwiseAbs().maxCoeff(), 1e-3);
    write("inverted.off", boxes({{Vec3::Zero(), Vec3(-1, 1, 1)}}));
    EXPECT_NEAR(cook("inverted.off --clump-spheres 2" + coarse).mass_properties.volume, 1e-9,
                1e-18);
}

TEST_F(ShapegenClump, DoesNotDependOnTheSizeOfTheBody) {
    write("box.off", box(Vec3::Zero()));
    const std::string mode = "box.off --clump-spheres 3 --unit m" + coarse + " --scale ";
    const ParticleTemplate small = cook(mode + "1e-9");
    const ParticleTemplate large = cook(mode + "1e5");
    EXPECT_NEAR(small.mass_properties.volume / 24e-27, 1.0, 1e-9);
    EXPECT_NEAR(large.mass_properties.volume / 24e15, 1.0, 1e-9);
    EXPECT_NEAR(entry(small, "coverage"), entry(large, "coverage"), 1e-4);
}

TEST_F(ShapegenClump, SaysWhatCanBeReachedWhereTheGoalCannot) {
    write("box.off", box());
    expect_failure("box.off --clump 0.95 --min-radius 20%" + coarse, 1, "expected at most 0.");
    expect_failure("box.off --clump 0.95 --min-radius '0.8 mm'" + coarse, 1, "the best clump has");
    expect_failure("box.off --clump 0.95 --min-radius '1.1 mm'" + coarse, 1,
                   "smaller --min-radius");
}

TEST_F(ShapegenClump, SaysWhatKeepsAFitFromTheVolumeOfTheBody) {
    // A thin plate: balls no thicker than it and its 1 % leave most of it empty.
    write("plate.off", boxes({{Vec3::Zero(), Vec3(40, 40, 4)}}));
    const auto note = [this](const std::string& options) {
        const Outcome said = run("plate.off --clump-spheres 30 -o said.tpl" + options + coarse);
        EXPECT_EQ(said.code, 0) << said.errors;
        const std::size_t at = said.output.find("plate.off: the spheres have ");
        return at == std::string::npos ? std::string()
                                       : said.output.substr(at, said.output.find('\n', at) - at);
    };
    const std::string tight = note("");
    EXPECT_NE(tight.find("% of the volume of the body"), std::string::npos) << tight;
    EXPECT_NE(tight.find("more than 1 % of d_eq (--protrusion)"), std::string::npos) << tight;
    // Nothing is said where the volume is met, or where no sphere was to stand out.
    EXPECT_EQ(note(" --inscribed"), "");
    write("plate.off", box());
    EXPECT_EQ(note(" --protrusion 5%"), "");
}

TEST_F(ShapegenClump, CountsThePiecesThatDoNotTouch) {
    // Two cylinders on a thread, which takes smaller spheres than the two largest.
    write("neck.profile", "units = mm\nstart 0 -3\nline 1 -3 1 -1 0.05 -1 0.05 1 1 1 1 3 0 3\n");
    EXPECT_EQ(entry(cook("neck.profile --clump-spheres 2" + coarse), "components"), 2.0);
    EXPECT_NE(run("neck.profile --clump-spheres 2" + coarse)
                  .output.find("the spheres form 2 pieces that do not touch each other"),
              std::string::npos);
    EXPECT_EQ(entry(cook(candy + " --clump-spheres 4" + coarse), "components"), 1.0);
}

TEST_F(ShapegenClump, CooksADiscAThousandTimesWiderThanThick) {
    write("disc.off", boxes({{Vec3::Zero(), Vec3(1000, 1000, 1)}}));
    const ParticleTemplate disc = cook("disc.off --clump-spheres 5" + coarse);
    EXPECT_NEAR(disc.mass_properties.volume, 1e-3, 1e-12);
    for (const ClumpSphere& s : std::get<Clump>(disc.shape).spheres) EXPECT_GT(s.radius, 0.4e-3);
}

}  // namespace
}  // namespace dem
