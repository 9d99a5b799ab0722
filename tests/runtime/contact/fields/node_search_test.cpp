// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/fields/node_search.hpp"

#include "common/random.hpp"
#include "runtime/contact/fields/node_fields.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dem::runtime {
namespace {

struct NamedShape {
    std::string name;
    SrShape shape;
};

const std::vector<NamedShape>& shapes() {
    static const std::vector<NamedShape> all = {{"candy", test::candy()},
                                                {"tablet", test::sharp_tablet()},
                                                {"peanut", test::peanut()},
                                                {"red blood cell", test::red_blood_cell()}};
    return all;
}

Vec3 position(const SurfaceNodes& nodes, std::uint32_t k) {
    return {nodes.nodes[k].x, nodes.nodes[k].y, nodes.nodes[k].z};
}

template <class Field>
std::vector<std::uint32_t> walk_over_all(const SurfaceNodes& nodes, const Field& field,
                                         double margin = 0.0) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t k = 0; k < nodes.count; ++k) {
        const Vec3 x = position(nodes, k);
        if (field.sample(x).distance < margin && field.accepts(x)) found.push_back(k);
    }
    return found;
}

template <class Field>
std::vector<std::uint32_t> touching(const SurfaceNodes& nodes, const Field& field, double margin,
                                    double travel, NearCache& cache) {
    std::vector<std::uint32_t> found;
    visit_touching_nodes(nodes, field, margin, travel, cache,
                         [&](std::uint32_t k, const auto&) { found.push_back(k); });
    return found;
}

/// The slave at a distance at which the bodies are between well apart and deep in each other.
SrField random_pose(const SrShape& master, const SrShape& slave, Random& random) {
    const Vec3 axis = random.direction();
    const Vec3 towards = random.direction();
    const double far = master.bounding_radius + slave.bounding_radius;
    return {slave, random.uniform(0.35, 1.02) * far * towards, axis};
}

TEST(NodeSearch, FindsTheSameNodesAsAWalkOverAllOfThem) {
    Random random(1, 0);
    int touching_pairs = 0;
    for (const NamedShape& master : shapes())
        for (const NamedShape& slave : shapes())
            for (int trial = 0; trial < 120; ++trial) {
                const SrField field = random_pose(master.shape, slave.shape, random);
                NearCache cache;
                const auto found = touching(master.shape.nodes, field, 2e-5, 1.0, cache);
                ASSERT_EQ(found, walk_over_all(master.shape.nodes, field))
                    << master.name << " on " << slave.name << ", trial " << trial;
                touching_pairs += found.empty() ? 0 : 1;
            }
    EXPECT_GT(touching_pairs, 500);
}

TEST(NodeSearch, ATangentPlaneOfTheSlaveHidesNoNode) {
    Random random(6, 0);
    const SrShape& slave = shapes()[0].shape;  // has a support map
    ASSERT_FALSE(slave.support.pieces.empty());
    for (const NamedShape& master : shapes())
        for (int trial = 0; trial < 200; ++trial) {
            SrField field = random_pose(master.shape, slave, random);
            field.set_floor(slave, random.direction());
            const double margin = random.uniform(0.0, 1e-3);
            for (std::uint32_t k = 0; k < master.shape.nodes.count; ++k) {
                const Vec3 x = position(master.shape.nodes, k);
                // Outside its grid the field itself is only a bound.
                const double distance = field.sample(x).distance;
                if (distance < slave.sdf.margin) {
                    ASSERT_LE(field.floor(x), distance);
                }
            }
            const auto all = walk_over_all(master.shape.nodes, field, margin);
            std::vector<std::uint32_t> found;
            visit_near_nodes(master.shape.nodes, field, margin,
                             [&](std::uint32_t k, const auto&) { found.push_back(k); });
            ASSERT_EQ(found, all);
        }
}

TEST(NodeSearch, BoundsTheDistanceOfNodesItDoesNotVisit) {
    Random random(2, 0);
    for (const NamedShape& master : shapes())
        for (int trial = 0; trial < 200; ++trial) {
            const SrShape& slave = shapes()[static_cast<std::size_t>(trial) % 4].shape;
            const SrField field = random_pose(master.shape, slave, random);
            const double margin = random.uniform(0.0, 1e-3);
            std::vector<bool> visited(master.shape.nodes.count, false);
            const double others =
                visit_near_nodes(master.shape.nodes, field, margin,
                                 [&](std::uint32_t k, const auto&) { visited[k] = true; });
            for (std::uint32_t k = 0; k < master.shape.nodes.count; ++k) {
                const double distance = field.sample(position(master.shape.nodes, k)).distance;
                ASSERT_TRUE(visited[k] ? distance < margin : distance >= others);
            }
        }
}

TEST(NodeSearch, ListsHoldEveryNodeThatTouchesUntilTheyExpire) {
    Random random(3, 0);
    for (const NamedShape& master : shapes())
        for (int trial = 0; trial < 300; ++trial) {
            const SrShape& slave = shapes()[static_cast<std::size_t>(trial) % 4].shape;
            const SrField start = random_pose(master.shape, slave, random);
            NearCache cache;
            touching(master.shape.nodes, start, 1e-4, 1.0, cache);
            if (cache.listed_until < 1.0) continue;
            // A move of the slave by nearly as much as the list allows.
            const double way = 0.999 * (cache.listed_until - 1.0);
            const double shift = random.uniform(0.0, way);
            const double turn = (way - shift) / slave.bounding_radius;
            const Vec3 axis =
                Eigen::AngleAxisd(turn, random.direction()).toRotationMatrix() * start.axis;
            const SrField end(slave, start.center + shift * random.direction(), axis);
            const auto all = walk_over_all(master.shape.nodes, end);
            EXPECT_TRUE(all.empty() || 1.0 + way >= cache.clear_until);
            ASSERT_EQ(touching(master.shape.nodes, end, 1e-4, 1.0 + way, cache), all);
        }
}

/// Moves the slave along its branch vector to where the nearest node is `gap` away from it.
SrField at_gap(const SrShape& master, SrField field, double gap) {
    for (int k = 0; k < 60; ++k) {
        double nearest = visit_near_nodes(master.nodes, field, 0.5 * master.bounding_radius,
                                          [](std::uint32_t, const auto&) {});
        visit_near_nodes(
            master.nodes, field, 0.5 * master.bounding_radius,
            [&](std::uint32_t, const auto& s) { nearest = std::min(nearest, s.distance); });
        field.center += (gap - nearest) * field.center.normalized();
        if (std::abs(gap - nearest) < 1e-7) break;
    }
    return field;
}

TEST(NodeSearch, ChangesNoNodeAlongATrajectoryWhateverTheMargin) {
    for (const double margin : {1e-6, 3e-5, 3e-4}) {
        Random random(4, 0);
        int calls = 0;
        int searches = 0;
        int touches = 0;
        for (const NamedShape& master : shapes())
            for (int run = 0; run < 8; ++run) {
                const SrShape& slave = shapes()[static_cast<std::size_t>(run) % 4].shape;
                SrField field =
                    at_gap(master.shape, random_pose(master.shape, slave, random), 1e-5);
                const Vec3 velocity = -0.5 * field.center.normalized() + 0.2 * random.direction();
                const Vec3 spin = 50.0 * random.direction();
                NearCache cache;
                double travel = 0.0;
                const double dt = 1e-6;
                for (int step = 0; step < 200; ++step) {
                    field.center += dt * velocity;
                    field.axis =
                        Eigen::AngleAxisd(dt * spin.norm(), spin.normalized()) * field.axis;
                    travel += dt * (velocity.norm() + spin.norm() * slave.bounding_radius);
                    const auto all = walk_over_all(master.shape.nodes, field);
                    touches += all.empty() ? 0 : 1;
                    if (travel < cache.clear_until) {
                        ASSERT_TRUE(all.empty());
                        continue;
                    }
                    ++calls;
                    searches += travel < cache.listed_until ? 0 : 1;
                    ASSERT_EQ(touching(master.shape.nodes, field, margin, travel, cache), all);
                }
            }
        EXPECT_GT(touches, 2000);
        if (margin == 3e-5) {
            EXPECT_LT(searches, calls / 5);
        }
    }
}

TEST(NodeSearch, ManyNodesOnAFlatFaceAreAllFound) {
    const SurfaceNodes& nodes = shapes()[1].shape.nodes;
    // A plane through the tablet: hundreds of nodes behind it, more than a list holds.
    const PlaneField plane{
        {1e-12}, Vec3(0, 0, 1.5e-3), Vec3(0, 0, -1), std::numeric_limits<double>::infinity()};
    const auto all = walk_over_all(nodes, plane);
    ASSERT_GT(all.size(), 10 * std::size_t{NearCache::capacity});
    NearCache cache;
    EXPECT_EQ(touching(nodes, plane, 1e-4, 0.0, cache), all);
    EXPECT_LT(cache.listed_until, 0.0);
    EXPECT_EQ(touching(nodes, plane, 1e-4, 0.0, cache), all);
}

TEST(NodeSearch, ACacheThatKnowsNothingProvesNothing) {
    EXPECT_GE(0.0, NearCache{}.clear_until);
}

/// The gradient against central differences, and the bound on the growth of the distance.
template <class Field>
void expect_consistent(const Field& field, const Vec3& x, double tolerance) {
    const auto sample = field.sample(x);
    const Vec3 gradient = field.gradient(x, sample);
    const double h = 1e-9;
    for (int c = 0; c < 3; ++c) {
        const Vec3 step = h * Vec3::Unit(c);
        const double slope =
            (field.sample(x + step).distance - field.sample(x - step).distance) / (2.0 * h);
        EXPECT_NEAR(gradient[c], slope, tolerance);
    }
}

TEST(NodeFields, GradientsAreThoseOfTheDistance) {
    Random random(5, 0);
    const SrShape& peanut = shapes()[2].shape;
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 c = 1e-3 * random.direction();
        const Vec3 a = random.direction();
        const Vec3 sideways = a.unitOrthogonal();
        const Vec3 x = c + 4.9e-3 * sideways + random.uniform(-2e-3, 2e-3) * a;
        // Where the way to a corner of a grid cell is shorter than h the slopes differ.
        expect_consistent(SrField(peanut, c, a), x, 3e-5);
        expect_consistent(TubeField{{0.0}, c, a, 4.8e-3, 1.0}, x, 1e-5);
        expect_consistent(RodField{{0.0}, c - 5e-3 * a, a, 5e-3, 1e-2}, x, 1e-5);
        expect_consistent(SphereField{{0.0}, c, 6e-3}, x, 1e-5);
        expect_consistent(PlaneField{{0.0}, c, a, 1.0}, x, 1e-5);
    }
}

TEST(NodeFields, ARimCutsADiscAndATube) {
    const PlaneField disc{{0.0}, Vec3(0, 0, 1), Vec3(0, 0, 1), 0.5};
    EXPECT_TRUE(disc.accepts({0.3, 0.39, 0.9}));
    EXPECT_FALSE(disc.accepts({0.3, 0.41, 0.9}));
    const TubeField tube{{0.0}, Vec3(0, 0, 1), Vec3(0, 0, 1), 0.5, 2.0};
    EXPECT_TRUE(tube.accepts({0.6, 0, 1.1}));
    EXPECT_FALSE(tube.accepts({0.6, 0, 0.9}));
    EXPECT_FALSE(tube.accepts({0.6, 0, 3.1}));
}

}  // namespace
}  // namespace dem::runtime
