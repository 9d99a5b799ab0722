// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/certificate/template_summary.hpp"

#include "tests/formats/sample_template.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dem::shapegen {
namespace {

TEST(TemplateSummary, TheJsonHoldsEveryShapeWithItsNumbersUnrounded) {
    TemplateFile file = sample::file();
    file.shapes[0].name = "\xff not UTF-8";
    const auto json = nlohmann::json::parse(template_json(file));
    EXPECT_EQ(json["schema"], 1);
    EXPECT_EQ(json["command"], file.command);
    EXPECT_EQ(json["input_hash"], "0123456789abcdef");
    ASSERT_EQ(json["shapes"].size(), 4U);
    EXPECT_EQ(json["shapes"][0]["kind"], "sphere");
    EXPECT_EQ(json["shapes"][0]["counts"]["spheres"], 1);
    const auto& sr = json["shapes"][1];
    EXPECT_EQ(sr["name"], "sr ball");
    EXPECT_EQ(sr["kind"], "sr");
    EXPECT_EQ(sr["volume"], file.shapes[1].mass_properties.volume);
    EXPECT_EQ(sr["center_of_mass"], nlohmann::json({1e-4, -2e-4, 3e-4}));
    EXPECT_EQ(sr["rotation"], nlohmann::json({0.5, -0.5, 0.5, 0.5}));
    EXPECT_EQ(sr["bounding_radius"], 2e-3);
    EXPECT_EQ(sr["convex"], true);
    EXPECT_EQ(sr["counts"]["nodes"], 20);
    EXPECT_EQ(sr["counts"]["vertices"], 18);
    EXPECT_EQ(sr["counts"]["triangles"], 32);
    // 15 base cells, 7 of them divided into four.
    EXPECT_EQ(sr["counts"]["cells"], 15 + 3 * 7);
    EXPECT_EQ(sr["certificate"]["nodes"], 20.0);
}

TEST(TemplateSummary, TheTextShowsEveryShapeOfASmallFileAndTheRangeOfALibrary) {
    TemplateFile file = sample::file();
    file.shapes[1].mass_properties.center_of_mass = Vec3(1e-4, -2e-4, 3e-20);
    EXPECT_NE(template_text(file).find("0.1 -0.2 0 mm"), std::string::npos) << template_text(file);
    EXPECT_NE(template_text(file).find("sr ball: sr, convex\n"), std::string::npos);
    // A known error is explained, an unknown one shown by its name.
    EXPECT_NE(template_text(file).find("volume against an independent integration"),
              std::string::npos);
    EXPECT_NE(template_text(file).find("20       nodes\n"), std::string::npos)
        << template_text(file);
    for (int i = 0; i < 20; ++i) {
        file.shapes.push_back(sample::sphere(1e-3 * (2 + i), "s" + std::to_string(i)));
    }
    const std::string text = template_text(file);
    EXPECT_NE(text.find("24 shapes"), std::string::npos) << text;
    EXPECT_NE(text.find("(tetrahedron) to 38792.4 mm^3"), std::string::npos) << text;
    EXPECT_EQ(text.find("s5"), std::string::npos);
}

}  // namespace
}  // namespace dem::shapegen
