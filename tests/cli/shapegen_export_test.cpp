// SPDX-License-Identifier: BSD-3-Clause
// One rule for all exports of all kinds of shapes: the frame and the unit of the input, or --unit.
#include "common/math/aabb.hpp"
#include "tests/cli/shapegen_fixture.hpp"

#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

/// Corners of a file, in its own unit.
struct Extent {
    Vec3 lower = Vec3::Constant(1e300);
    Vec3 upper = Vec3::Constant(-1e300);

    void add(const Vec3& p) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
};

Extent of_stl(const std::string& bytes) {
    Extent extent;
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
        for (std::size_t k = 3; k < 12; k += 3)
            extent.add({numbers[k], numbers[k + 1], numbers[k + 2]});
    }
    return extent;
}

/// Rows of three or more numbers behind `prefix`.
Extent of_rows(const std::string& text, const std::string& prefix) {
    Extent extent;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(prefix)) continue;
        for (char& c : line)
            if (c == ',') c = ' ';
        std::istringstream words(line.substr(prefix.size()));
        Vec3 p;
        if (words >> p.x() >> p.y() >> p.z()) extent.add(p);
    }
    return extent;
}

Extent extent_of(const fs::path& path) {
    const std::string text = content(path);
    if (path.extension() == ".stl") return of_stl(text);
    if (path.extension() == ".obj") return of_rows(text, "v ");
    if (path.extension() == ".csv") return of_rows(text, "");
    const std::size_t points = text.find("Name=\"Points\"");
    return of_rows(text.substr(points, text.find("</DataArray>", points) - points), "");
}

struct Input {
    std::string file, text, options;
    std::vector<std::string> extensions;
    double meters;      ///< of the input's unit
    Vec3 lower, upper;  ///< of the body, in the input's unit
    double tolerance;   ///< of what is exported from the body, in the input's unit
};

std::vector<Input> inputs() {
    // A box from (10, -20, 5) to (12, -17, 9).
    const std::string box =
        "OFF\n8 12 0\n10 -20 5\n12 -20 5\n10 -17 5\n12 -17 5\n10 -20 9\n12 -20 9\n10 -17 9\n"
        "12 -17 9\n3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n"
        "3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n";
    const std::string cylinder = "units = mm\nstart 0 7\nline 2 7 2 10 0 10\n";
    const Vec3 low(10, -20, 5);
    const Vec3 high(12, -17, 9);
    return {{"box.off",
             box,
             "--clump-spheres 60 --unit cm --resolution 20",
             {".stl", ".vtu", ".obj", ".csv"},
             1e-2,
             low,
             high,
             0.4},
            {"box.off",
             box,
             "--convex --unit in --rounding 0%",
             {".stl", ".vtu", ".obj"},
             0.0254,
             low,
             high,
             1e-5},
            {"cylinder.profile",
             cylinder,
             "",
             {".stl", ".vtu", ".obj", ".csv"},
             1e-3,
             {-2, -2, 7},
             {2, 2, 10},
             0.02},
            {"ball.profile",
             "units = um\nstart 0 1\narc 3 4 radius 3\narc 0 7 radius 3\n",
             "--sphere",
             {".stl", ".vtu", ".obj"},
             1e-6,
             {-3, -3, 1},
             {3, 3, 7},
             0.02}};
}

class ShapegenExport : public ShapegenFixture {};

TEST_F(ShapegenExport, EveryFileOfEveryKindLiesOnTheInputInItsUnitOrInTheOneAskedFor) {
    for (const Input& input : inputs()) {
        write(input.file, input.text);
        // The scale is part of the unit: what comes out lies on the input all the same.
        cook(input.file + ' ' + input.options + " --scale 2");
        for (const std::string& extension : input.extensions) {
            const std::string name = "e" + extension;
            ASSERT_EQ(run("export out.tpl -o " + name).code, 0) << name;
            const Extent own = extent_of(folder_ / name);
            // Centers of spheres lie inside the body.
            const bool is_centers = extension == ".csv" && input.file == "box.off";
            const double tolerance = is_centers ? 2.0 : input.tolerance;
            EXPECT_LT((own.lower - input.lower).cwiseAbs().maxCoeff(), tolerance)
                << input.file << name << ' ' << own.lower.transpose();
            EXPECT_LT((own.upper - input.upper).cwiseAbs().maxCoeff(), tolerance)
                << input.file << name << ' ' << own.upper.transpose();
            ASSERT_EQ(run("export out.tpl --unit mm -o " + name).code, 0) << name;
            const Extent in_mm = extent_of(folder_ / name);
            const double factor = 2.0 * input.meters / 1e-3;
            const double size = factor * (input.upper - input.lower).norm();
            EXPECT_LT((in_mm.lower - factor * own.lower).norm(), 1e-6 * size) << input.file << name;
            EXPECT_LT((in_mm.upper - factor * own.upper).norm(), 1e-6 * size) << input.file << name;
        }
    }
}

TEST_F(ShapegenExport, RadiiMassesAndCurvaturesFollowTheUnit) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 2\n");
    cook("ball.profile --clump 0.9");
    ASSERT_EQ(run("export out.tpl -o own.csv").code, 0);
    ASSERT_EQ(run("export out.tpl --unit cm -o cm.csv").code, 0);
    const auto last_row = [this](const std::string& name) {
        std::istringstream lines(content(folder_ / name));
        std::string line;
        std::string row;
        while (std::getline(lines, line)) row = line;
        std::vector<double> values;
        std::istringstream cells(row);
        for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
        return values;
    };
    EXPECT_NEAR(last_row("own.csv").at(3), 2.0, 1e-14);
    EXPECT_NEAR(last_row("own.csv").at(4), 4.0 / 3.0 * pi * 8.0, 1e-12);
    EXPECT_NEAR(last_row("cm.csv").at(3), 0.2, 1e-15);
    EXPECT_NEAR(last_row("cm.csv").at(4), 4.0 / 3.0 * pi * 8e-3, 1e-15);
    cook("ball.profile");
    ASSERT_EQ(run("export out.tpl -o own.csv").code, 0);
    ASSERT_EQ(run("export out.tpl --unit m -o m.csv").code, 0);
    EXPECT_NEAR(last_row("own.csv").at(3), 0.5, 1e-9);
    EXPECT_NEAR(last_row("m.csv").at(3), 500.0, 1e-6);
}

TEST_F(ShapegenExport, FilesNameTheirUnit) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 2\n");
    cook("ball.profile --sphere");
    EXPECT_EQ(run("export out.tpl -o a.stl").code, 0);
    EXPECT_TRUE(content(folder_ / "a.stl").starts_with("binary STL, unit mm: ball"));
    EXPECT_EQ(run("export out.tpl --unit in -o a.obj").code, 0);
    EXPECT_TRUE(content(folder_ / "a.obj").starts_with("# unit in\no body\n"));
    cook("ball.profile --sphere --scale 20");
    EXPECT_EQ(run("export out.tpl -o a.stl").code, 0);
    EXPECT_TRUE(content(folder_ / "a.stl").starts_with("binary STL, unit 0.02 m: ball"));
}

TEST_F(ShapegenExport, AUnitThatMeansNothingIsRefused) {
    write("ball.profile", "units = mm\nshape = sphere\nradius = 2\n");
    cook("ball.profile --clump 0.9");
    const auto refused = [this](const std::string& arguments, const std::string& words) {
        const Outcome outcome = run("export out.tpl " + arguments);
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
    };
    refused("-o a.stl --unit parsec", "--unit: unknown unit 'parsec'");
    refused("-o a.stl --unit kg", "expected a length");
    refused("-o a.svg --unit mm", "found it with a picture");
    refused("-o a --format yade --unit mm", "SI units");
}

}  // namespace
}  // namespace dem
