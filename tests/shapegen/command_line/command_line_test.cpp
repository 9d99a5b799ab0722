// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/command_line.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

double voxels_per_diameter(std::vector<const char*> options) {
    options.insert(options.begin(), {"shapegen", "candy.profile"});
    const auto command = std::get<CookCommand>(parse_command_line(options));
    return std::get<ClumpCommand>(command.recipe).request.options.per_diameter;
}

TEST(ClumpResolution, FollowsTheCoverageWhereTheUserGivesNone) {
    EXPECT_EQ(voxels_per_diameter({"--clump", "0.8"}), 60.0);
    EXPECT_EQ(voxels_per_diameter({"--clump", "0.9"}), 100.0);
    EXPECT_EQ(voxels_per_diameter({"--clump", "99%", "--inscribed"}), 100.0);
    EXPECT_EQ(voxels_per_diameter({"--clump-spheres", "500"}), 60.0);
    EXPECT_EQ(voxels_per_diameter({"--clump-error", "1%"}), 60.0);
}

TEST(ClumpResolution, IsWhatTheUserGives) {
    EXPECT_EQ(voxels_per_diameter({"--clump", "0.99", "--resolution", "60"}), 60.0);
    EXPECT_EQ(voxels_per_diameter({"--clump-spheres", "5", "--resolution", "140"}), 140.0);
}

}  // namespace
}  // namespace dem::shapegen
