// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/convex_in_field.hpp"

#include "runtime/contact/fields/node_fields.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/walls/wall_shapes.hpp"
#include "tests/runtime/contact/cores/convex_poses.hpp"
#include "tests/support/sample_convex.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

/// A ball that stands in the way.
struct BallField : SphereField {
    double clearance(const Vec3& x) const { return sample(x).distance; }
};

const Vec3 axis = Vec3::UnitZ();
constexpr double endless = std::numeric_limits<double>::infinity();

/// Calls look(name, core) with every solid in many attitudes, a good way off the z axis.
template <class Look>
void for_cores(const Look& look) {
    Random random(11, 0);
    for (const auto& [name, solid] : convex_solids()) {
        for (int k = 0; k < 40; ++k) {
            const Vec3 place(random.uniform(3.0, 3.5), 0.0, random.uniform(-0.3, 0.3));
            look(name, PlacedCore(solid.shape, random.orientation(), place));
        }
    }
}

template <class Field>
double lowest_distance(const PlacedCore& core, const Field& field) {
    const CornerFeatures<Field> corners(core, field);
    return lowest_point(core, field, corners.lowest()).distance;
}

TEST(ConvexInField, TheLowestPointAtAPlaneIsTheSupport) {
    for_cores([](const std::string& name, const PlacedCore& core) {
        const Vec3 n = Vec3(1.0, 2.0, 3.0).normalized();
        const PlaneField plane{{0.0}, {Vec3::Zero(), n}, endless};
        const double support = core.support(-n, 0).position.dot(n);
        EXPECT_NEAR(lowest_distance(core, plane), support, 1e-12) << name;
    });
}

TEST(ConvexInField, TheLowestPointAtARodIsTheNearestOfTwoCores) {
    ConvexShape line;
    line.core = ConvexShape::Core::cylinder;
    line.size = Vec3(0.0, 0.0, 20.0);
    line.low = -10.0;
    line.bounding_radius = 10.0;
    for_cores([&](const std::string& name, const PlacedCore& core) {
        const RodField rod{{0.0}, {Vec3::Zero(), axis}, CylinderWall{.radius = 1.0}};
        const PlacedCore other(line, Quat::Identity(), Vec3::Zero());
        SearchStart start;
        start.direction = Vec3(1.0, 0.0, 0.0);
        const CoreDistance found = core_distance(core, other, start, 0.0);
        EXPECT_NEAR(lowest_distance(core, rod), found.distance - 1.0, 1e-9) << name;
    });
}

TEST(ConvexInField, TheLowestPointInATubeIsTheFarthestFromItsAxis) {
    for_cores([](const std::string& name, const PlacedCore& core) {
        const TubeField tube{{0.0}, {Vec3::Zero(), axis}, 6.0, endless};
        double farthest = 0.0;
        constexpr int directions = 4000;
        for (int k = 0; k < directions; ++k) {
            const auto [sine, cosine] = math::sin_cos(2.0 * pi * k / directions);
            const Vec3 e(cosine, sine, 0.0);
            farthest = std::max(farthest, core.support(e, 0).position.dot(e));
        }
        // By half the angle between two directions beside the farthest point.
        const double missed = 0.5 * square(pi / directions) * farthest;
        EXPECT_NEAR(lowest_distance(core, tube), 6.0 - farthest, 1.01 * missed) << name;
    });
}

const ContactLaw elastic = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);

/// A contact of bodies at rest that has lasted: R* does not change.
template <class MakeField>
PairContact resting_contact(const ConvexShape& a, const PairState& pair, const MakeField& make) {
    ConvexHistory history{};
    MissCache miss{};
    ConvexScratch scratch{};
    history.effective_radius = 0.25;
    const auto field = make(WallFrame{pair.displacement, body_axis(pair.j.orientation)});
    return convex_in_field(
        a, field, CoreCall{pair, elastic, 1e-6, {history, miss}, 0.0, {nullptr, &scratch}});
}

/// Largest deviation of force and torque from the derivatives of the stored energy, relative to
/// the force.
template <class Evaluate>
double gradient_error(const PairState& pair, const Evaluate& evaluate) {
    const PairContact at = evaluate(pair);
    const double h = 1e-7;
    double error = 0.0;
    for (int k = 0; k < 6; ++k) {
        const Vec3 direction = Vec3::Unit(k % 3);
        const auto moved = [&](double s) {
            PairState p = pair;
            if (k < 3)
                p.displacement -= s * direction;
            else
                p.i.orientation = turned(direction, s) * pair.i.orientation;
            return evaluate(p).elastic_energy;
        };
        const double expected = -(moved(h) - moved(-h)) / (2.0 * h);
        const Vec3& found = k < 3 ? at.force : at.torque_i;
        error = std::max(error, std::abs(found.dot(direction) - expected) / at.force.norm());
    }
    return error;
}

/// `hollow`: bodies lie inside the wall, from its axis outwards.
template <class MakeField>
void expect_potential(const MakeField& make, double far, bool hollow) {
    for (const double tilt : {pi, 0.03}) {
        for (const auto& [name, solid] : convex_solids()) {
            Random random(3, 1);
            int off = 0;
            int touching = 0;
            for (int k = 0; k < 12; ++k) {
                const Poses p = random_poses(random, tilt);
                const Vec3 outwards = p.direction.cross(axis).normalized();
                const auto pair_at = [&](double distance) {
                    return PairState{(hollow ? far - distance : -distance) * outwards, still(p.i),
                                     still(Quat::Identity())};
                };
                const auto evaluate = [&](const PairState& pair) {
                    return resting_contact(solid.shape, pair, make);
                };
                const double overlap = 0.25 * solid.shape.rounding + 1e-3;
                const double distance =
                    place_of(overlap, far, [&](double d) { return evaluate(pair_at(d)).overlap; });
                const PairState pair = pair_at(distance);
                if (!evaluate(pair).touches()) continue;
                ++touching;
                off += gradient_error(pair, evaluate) > 2e-5 ? 1 : 0;
            }
            EXPECT_GE(touching, 10) << name;
            EXPECT_LE(off, tilt < pi ? 1 : 0) << name << ' ' << tilt;
        }
    }
}

TEST(ConvexInField, ForceAndTorqueAreTheGradientOfTheStoredEnergyAtABall) {
    expect_potential(
        [](const WallFrame& f) {
            return BallField{{{0.0}, f.origin, 2.0}};
        },
        5.0, false);
}

TEST(ConvexInField, ForceAndTorqueAreTheGradientOfTheStoredEnergyAtARod) {
    expect_potential(
        [](const WallFrame& f) {
            return RodField{{0.0}, f, CylinderWall{.radius = 2.0}};
        },
        5.0, false);
}

TEST(ConvexInField, ForceAndTorqueAreTheGradientOfTheStoredEnergyInATube) {
    expect_potential(
        [](const WallFrame& f) {
            return TubeField{{0.0}, f, 5.0, endless};
        },
        5.0, true);
}

}  // namespace
}  // namespace dem::test
