// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/random.hpp"
#include "runtime/contact/fields/node_fields.hpp"
#include "runtime/contact/fields/node_search.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"
#include "shapegen/pipeline/cook.hpp"
#include "shapegen/profile/profile_file.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// Contacts by nodes on the shapes that shapegen cooks from data/profiles.
namespace dem::shapegen {

using namespace runtime;

namespace {

SrShape cooked(const std::string& name, std::uint32_t nodes = 2000) {
    const std::string path = std::string(DEM_SOURCE_DIR) + "/data/profiles/" + name + ".profile";
    CookOptions options;
    options.nodes = nodes;
    return std::get<SrShape>(cook(read_profile(path).profile, name, options).shape);
}

SrField field_of(const SrShape& slave, const PairState& pair) {
    const Quat to_body = pair.i.orientation.conjugate();
    return {slave, to_body * pair.displacement, to_body * (pair.j.orientation * Vec3::UnitZ())};
}

/// Random attitudes, from well apart to deep in each other.
PairState random_pair(const SrShape& a, const SrShape& b, Random& random) {
    PairState pair;
    pair.i.orientation = random.orientation();
    pair.j.orientation = random.orientation();
    pair.i.inverse_inertia = pair.j.inverse_inertia = {1e3, Vec3::Constant(1e8)};
    pair.displacement =
        random.uniform(0.35, 1.02) * (a.bounding_radius + b.bounding_radius) * random.direction();
    return pair;
}

struct Remembered {
    PatchHistory patch{};
    PointHistory point{};
    MissCache miss{};
    NearCache cache{};
    ContactScratch scratch;

    explicit Remembered(const SrShape& shape) : scratch(shape.nodes.nodes.size()) {}
    PatchCall call(const PairState& pair, const ContactLaw& law, double dt) {
        return {pair, law, dt, {patch, cache}, 0.0, {&scratch}};
    }
};

/// Overlaps by nodes are those of the deepest node.
ContactLaw law() {
    ContactLaw options;
    options.geometry.multi_contact = ContactLaw::MultiContact::deepest;
    return pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0, options);
}

/// Calls check(k, distance) with the distance of every node of i from j.
template <class Check>
void for_all_nodes(const SrShape& a, const SrShape& b, const PairState& pair, const Check& check) {
    const SrField field = field_of(b, pair);
    for (std::uint32_t k = 0; k < a.nodes.count; ++k) {
        const SurfaceNodes::Node& n = a.nodes.nodes[k];
        check(k, field.sample({n.x, n.y, n.z}).distance);
    }
}

TEST(CookedNodes, TheKernelTouchesWithTheNodesThatAWalkOverAllFinds) {
    std::vector<SrShape> shapes;
    for (const char* name : {"candy", "tablet", "cylinder", "peanut", "red_blood_cell", "frustum"})
        shapes.push_back(cooked(name));
    Random random(41, 0);
    int touching = 0;
    for (const SrShape& a : shapes)
        for (const SrShape& b : shapes)
            for (int trial = 0; trial < 60; ++trial) {
                const PairState pair = random_pair(a, b, random);
                std::vector<std::uint64_t> inside;
                for_all_nodes(a, b, pair, [&](std::uint32_t k, double distance) {
                    if (distance < 0.0) inside.push_back(k);
                });
                Remembered remembered(a);
                ContactLaw sum = law();
                sum.geometry.multi_contact = ContactLaw::MultiContact::sum;
                const PairContact c = collide(a, b, remembered.call(pair, sum, 1e-6));
                ASSERT_EQ(c.points, inside.size());
                for (std::size_t n = 0; n < inside.size(); ++n)
                    ASSERT_EQ(remembered.scratch[n].feature, inside[n]);
                touching += c.touches() ? 1 : 0;
            }
    EXPECT_GT(touching, 600);
}

/// The kernel by nodes finds less overlap than there is, by as much as a node can be away from the
/// deepest point: (0.7 spacing)^2 / 2 times the sum of the curvatures there.
TEST(CookedNodes, TheOverlapOfConvexShapesIsThatOfTheCommonNormalUpToTheSpacingOfNodes) {
    const SrShape coarse = cooked("candy", 500);
    const SrShape fine = cooked("candy", 8000);
    Random random(42, 0);
    double coarse_error = 0.0;
    double fine_error = 0.0;
    int touching = 0;
    for (int trial = 0; trial < 2000 && touching < 300; ++trial) {
        const PairState pair = random_pair(fine, fine, random);
        Remembered exact(fine);
        const PairContact c =
            collide(fine, fine, Call{pair, law(), 1e-6, Memory{exact.point, exact.miss}});
        if (c.overlap < 2e-4 || c.overlap > 8e-4) continue;
        ++touching;
        Remembered by_few(coarse);
        Remembered by_many(fine);
        const PairContact few = collide(coarse, coarse, by_few.call(pair, law(), 1e-6));
        const PairContact many = collide(fine, fine, by_many.call(pair, law(), 1e-6));
        EXPECT_LT(few.overlap, c.overlap + 2e-6);
        EXPECT_LT(many.overlap, c.overlap + 2e-6);
        EXPECT_GT(many.force.normalized().dot(c.force.normalized()), 0.98);
        coarse_error += c.overlap - few.overlap;
        fine_error += c.overlap - many.overlap;
    }
    ASSERT_GT(touching, 100);
    // Quadratic in the spacing: 16 times the nodes, a sixteenth of the error.
    EXPECT_LT(fine_error / touching, 1e-5);
    EXPECT_NEAR(coarse_error / fine_error, 16.0, 8.0);
}

TEST(CookedNodes, AWallFeelsTheSameOverlapByNodesAndBySupport) {
    const SrShape shape = cooked("candy", 8000);
    Random random(43, 0);
    for (int trial = 0; trial < 200; ++trial) {
        PairState pair;
        pair.i.orientation = random.orientation();
        pair.j.orientation = random.orientation();
        pair.i.inverse_inertia = {1e3, Vec3::Constant(1e8)};
        pair.displacement = -random.uniform(3e-3, 7e-3) * (pair.j.orientation * Vec3::UnitZ());
        Remembered exact(shape);
        Remembered by_nodes(shape);
        const PairContact c =
            collide(shape, PlaneWall{}, Call{pair, law(), 1e-6, Memory{exact.point, exact.miss}});
        const PairContact n = collide(shape, PlaneWall{}, by_nodes.call(pair, law(), 1e-6));
        if (c.overlap > 2e-5) {
            EXPECT_NEAR(n.overlap, c.overlap, 1.5e-5);
        }
        if (n.touches()) {
            EXPECT_TRUE(c.touches());
        }
    }
}

}  // namespace
}  // namespace dem::shapegen
