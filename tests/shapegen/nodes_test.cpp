// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "shapegen/revolution/node_rings.hpp"
#include "shapegen/revolution/surface_nodes.hpp"
#include "tests/shapegen/sample_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

SurfaceNodes nodes_of(const Profile& profile, std::uint32_t count) {
    return surface_nodes(node_rings(profile, count), [](const Ring& ring) { return ring.z; });
}

Vec3 position(const SurfaceNodes::Node& node) {
    return {node.x, node.y, node.z};
}

TEST(SurfaceNodes, AreExactlyAsManyAsAsked) {
    for (const auto& [name, profile] : test::all_profiles()) {
        for (const std::uint32_t count : {100U, 137U, 500U, 2000U, 8001U}) {
            const SurfaceNodes nodes = nodes_of(profile, count);
            EXPECT_EQ(nodes.count, count) << name;
            EXPECT_EQ(nodes.nodes.size(), (count + 15) / 16 * 16) << name;
            EXPECT_EQ(nodes.blocks.size(), (count + 15) / 16) << name;
            EXPECT_EQ(nodes.super_blocks.size(), (nodes.blocks.size() + 15) / 16) << name;
            EXPECT_EQ(nodes.stencil.size(), 16 * count) << name;
        }
    }
}

TEST(SurfaceNodes, LieOnTheSurfaceAndAreDifferent) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const SurfaceNodes nodes = nodes_of(profile, 2000);
        std::set<std::array<double, 3>> seen;
        for (std::uint32_t i = 0; i < nodes.count; ++i) {
            const auto& n = nodes.nodes[i];
            EXPECT_NEAR(profile.signed_distance({std::hypot(n.x, n.y), n.z}), 0.0, 1e-16) << name;
            EXPECT_EQ(n.mean_curvature, n.z) << name;
            seen.insert({n.x, n.y, n.z});
        }
        EXPECT_EQ(seen.size(), nodes.count) << name;
    }
}

TEST(SurfaceNodes, HoldThePolesAndRingsOnEveryEdge) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const std::vector<Ring> rings = node_rings(profile, 2000);
        EXPECT_EQ(rings.front().count, 1U);
        EXPECT_EQ(rings.front().z, profile.bottom_z());
        EXPECT_EQ(rings.back().count, 1U);
        EXPECT_EQ(rings.back().z, profile.top_z());
        for (const Profile::Corner& corner : profile.corners()) {
            EXPECT_TRUE(std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) {
                return (Vec2(ring.r, ring.z) - corner.point).norm() < 1e-15;
            })) << name;
        }
    }
}

TEST(SurfaceNodes, AreSpreadEvenlyByAreaOnASphere) {
    const std::vector<Ring> rings = node_rings(test::spheroid(1.0, 1.0), 4000);
    const double mean = 4.0 * pi / 4000.0;
    const auto polar = [](const Ring& ring) { return std::atan2(ring.r, ring.z); };
    for (std::size_t i = 2; i + 2 < rings.size(); ++i) {
        const double above = std::cos(0.5 * (polar(rings[i]) + polar(rings[i + 1])));
        const double below = std::cos(0.5 * (polar(rings[i]) + polar(rings[i - 1])));
        EXPECT_NEAR(2.0 * pi * (above - below) / rings[i].count, mean, 0.08 * mean) << i;
    }
}

TEST(SurfaceNodes, LeaveNoGapLargerThanTheSpacingOfTheEvenPart) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const SurfaceNodes nodes = nodes_of(profile, 2000);
        double farthest = 0.0;
        for (std::uint32_t i = 0; i < nodes.count; ++i) {
            const Vec3 p = position(nodes.nodes[i]);
            const Vec3 neighbor = position(nodes.nodes[nodes.stencil[16 * i]]);
            farthest = std::max(farthest, (p - neighbor).norm());
        }
        // l^2 pi bounds the area of every body here but not of long ones: generous by a factor.
        EXPECT_LT(farthest, 2.0 * profile.major_axis_length() / std::sqrt(2000.0 / pi)) << name;
    }
}

TEST(SurfaceNodes, BallsHoldTheirNodesAndAreTight) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const SurfaceNodes nodes = nodes_of(profile, 2000);
        double sum = 0.0;
        for (std::uint32_t i = 0; i < nodes.nodes.size(); ++i) {
            for (const auto& ball : {nodes.blocks[i / 16], nodes.super_blocks[i / 256]}) {
                const Vec3 center{ball.x, ball.y, ball.z};
                EXPECT_LE((position(nodes.nodes[i]) - center).norm(), ball.radius) << name;
            }
        }
        for (const auto& ball : nodes.blocks) sum += ball.radius;
        // A disc of 16 nodes at the mean spacing has a radius of 2.3 spacings; l^2 pi: see above.
        const double spacing = profile.major_axis_length() / std::sqrt(2000.0 / pi);
        EXPECT_LT(sum / static_cast<double>(nodes.blocks.size()), 4.0 * spacing) << name;
    }
}

TEST(SurfaceNodes, StencilHoldsTheNearestNodesInOrder) {
    for (const auto& [name, profile] : test::all_profiles()) {
        const SurfaceNodes nodes = nodes_of(profile, 500);
        for (std::uint32_t i = 0; i < nodes.count; ++i) {
            std::vector<double> all;
            for (std::uint32_t k = 0; k < nodes.count; ++k) {
                if (k == i) continue;
                all.push_back((position(nodes.nodes[i]) - position(nodes.nodes[k])).squaredNorm());
            }
            std::sort(all.begin(), all.end());
            for (std::uint32_t k = 0; k < 16; ++k) {
                const Vec3 p = position(nodes.nodes[nodes.stencil[16 * i + k]]);
                EXPECT_NEAR((position(nodes.nodes[i]) - p).squaredNorm(), all[k], 1e-12 * all[k])
                    << name;
            }
        }
    }
}

TEST(SurfaceNodes, AreDenserBesideASharpEdge) {
    const std::vector<Ring> rings = node_rings(test::cylinder(3e-3, 4e-3), 2000);
    const auto edge = std::find_if(rings.begin(), rings.end(), [](const Ring& ring) {
        return ring.r == 3e-3 && ring.z == -2e-3;
    });
    ASSERT_NE(edge, rings.end());
    const auto middle =
        std::find_if(edge, rings.end(), [](const Ring& ring) { return ring.z >= 0.0; });
    EXPECT_GT(edge->count, 1.7 * middle->count);
}

TEST(SurfaceNodes, RefuseFewerNodesThanTheEdgesNeed) {
    std::vector<ProfileSegment> comb{LineSegment{Vec2(0, 0), Vec2(2, 0)}};
    for (int i = 0; i < 100; ++i) {
        const double r = i % 2 == 0 ? 2.0 : 1.0;
        comb.emplace_back(LineSegment{Vec2(r, 0.1 * i), Vec2(3.0 - r, 0.1 * (i + 1))});
    }
    comb.emplace_back(LineSegment{Vec2(2, 10), Vec2(0, 10)});
    const Profile profile = test::labeled(comb);
    EXPECT_THROW(node_rings(profile, 120), Error);
    EXPECT_NO_THROW(node_rings(profile, 5000));
}

}  // namespace
}  // namespace dem::shapegen
