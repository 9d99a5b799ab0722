// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/cover.hpp"

#include "shapegen/voxel/voxelize.hpp"
#include "tests/shapegen/clump/sample_balls.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

VoxelImage cube_cells() {
    return voxelize(sample::box(Vec3::Constant(-1.0), Vec3::Constant(1.0)), 0.0413);
}

bool holds(const Ball& ball, const Vec3& p) {
    return (p - ball.center).norm() <= ball.radius;
}

std::size_t count_uncovered(const VoxelImage& cells, const std::vector<Ball>& balls) {
    std::size_t count = 0;
    for (const Voxel& v : cells.voxels()) {
        const Vec3 p = cells.grid().center(v);
        bool covered = false;
        for (const Ball& ball : balls) covered = covered || holds(ball, p);
        count += covered ? 0U : 1U;
    }
    return count;
}

TEST(CellCover, CountsAsALoopOverAllCellsDoes) {
    const VoxelImage cells = cube_cells();
    const std::vector<Ball> balls = test::random_balls(12, 1);
    CellCover cover(cells);
    std::vector<Ball> in;
    for (const Ball& ball : balls) {
        const std::size_t before = count_uncovered(cells, in);
        in.push_back(ball);
        const std::size_t after = count_uncovered(cells, in);
        EXPECT_EQ(cover.gain(ball), before - after);
        for (const Ball& other : balls) EXPECT_GE(cover.gain_bound(other), cover.gain(other));
        cover.insert(ball);
        EXPECT_EQ(cover.uncovered(), after);
        EXPECT_EQ(cover.exclusive(ball), before - after);
    }
    std::vector<Vec3> opened;
    cover.erase(balls[3], opened);
    in.erase(in.begin() + 3);
    EXPECT_EQ(cover.uncovered(), count_uncovered(cells, in));
    for (const Vec3& p : opened) EXPECT_TRUE(holds(balls[3], p));
    for (const Ball& ball : in) cover.erase(ball);
    EXPECT_EQ(cover.uncovered(), cover.cells());
    EXPECT_EQ(cover.gain_bound({{0.0, 0.0, 0.0}, 10.0}), cover.cells());
}

TEST(Cover, LazyGreedyChoosesWhatPlainGreedyChooses) {
    const VoxelImage cells = cube_cells();
    const std::vector<Ball> balls = test::random_balls(80, 2);
    CellCover lazy(cells);
    std::vector<std::uint32_t> chosen;
    cover_greedily(balls, {.coverage = 1.0, .count = 25}, lazy, chosen);
    CellCover plain(cells);
    ASSERT_EQ(chosen.size(), 25U);
    for (const std::uint32_t choice : chosen) {
        std::size_t most = 0;
        std::uint32_t best = 0;
        for (std::uint32_t i = 0; i < balls.size(); ++i) {
            if (plain.gain(balls[i]) > most) {
                most = plain.gain(balls[i]);
                best = i;
            }
        }
        EXPECT_EQ(choice, best);
        plain.insert(balls[best]);
    }
}

TEST(Cover, ExchangesCoverMoreWithAsManyBalls) {
    const VoxelImage cells = cube_cells();
    const std::vector<Ball> balls = test::random_balls(400, 3);
    const CoverGoal goal{.coverage = 1.0, .count = 15};
    CoverSearch greedy(cells);
    CoverSearch exchanged(cells);
    greedy.reach(balls, goal, 0);
    exchanged.reach(balls, goal, 10);
    EXPECT_EQ(exchanged.chosen().size(), goal.count);
    EXPECT_GT(exchanged.coverage(), greedy.coverage());
    std::vector<Ball> chosen;
    for (const std::uint32_t i : exchanged.chosen()) chosen.push_back(balls[i]);
    EXPECT_EQ(exchanged.coverage(), 1.0 - static_cast<double>(count_uncovered(cells, chosen)) /
                                              static_cast<double>(cells.count()));
}

TEST(Cover, GoesOnFromWhatIsChosenWithMoreCandidates) {
    const VoxelImage cells = cube_cells();
    const std::vector<Ball> balls = test::random_balls(400, 4);
    CoverSearch search(cells);
    search.reach(std::span(balls).first(100), {.coverage = 0.6}, 5);
    EXPECT_GE(search.coverage(), 0.6);
    search.reach(balls, {.coverage = 0.8}, 5);
    EXPECT_GE(search.coverage(), 0.8);
    CoverSearch at_once(cells);
    at_once.reach(balls, {.coverage = 0.8}, 5);
    EXPECT_LE(search.chosen().size(), at_once.chosen().size() + 3);
}

TEST(Cover, TakesOutBallsThatOthersCover) {
    const VoxelImage cells = cube_cells();
    // The two in the corners are inside the large ones that cover the cube between them.
    const std::vector<Ball> balls{{Vec3(-0.9, -0.9, -0.9), 0.05},
                                  {Vec3(-0.5, 0.0, 0.0), 1.6},
                                  {Vec3(0.5, 0.0, 0.0), 1.6},
                                  {Vec3(0.9, 0.9, 0.9), 0.05}};
    CellCover cover(cells);
    std::vector<std::uint32_t> chosen{0, 1, 2, 3};
    for (const std::uint32_t i : chosen) cover.insert(balls[i]);
    drop_redundant(balls, 1.0, cover, chosen);
    EXPECT_EQ(chosen, (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace dem::shapegen
