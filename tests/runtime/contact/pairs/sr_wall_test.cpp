// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/sr_wall.hpp"

#include "common/math/elementary.hpp"
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/smooth/sr_rod.hpp"
#include "runtime/contact/smooth/sr_tube.hpp"
#include "runtime/contact/smooth/tube_place.hpp"
#include "runtime/contact/walls/wall_frame.hpp"
#include "runtime/integrator/rigid_body.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/memory_of.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace dem::test {

using namespace runtime;

namespace {

const Vec3 z = Vec3::UnitZ();

std::vector<SolidBody> bodies() {
    return {candy(), tablet(), cylinder(4e-3, 6e-3), cylinder(6e-3, 1.5e-3),
            spheroid(2.5e-3, 5e-3)};
}

/// Local maxima above the wall of the distance from the axis over a fine division of the circle.
std::vector<double> maxima_by_sampling(const SrSupport& support, const Vec3& off_axis,
                                       double radius, std::size_t count = 200'000) {
    std::vector<double> f(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double psi = 2.0 * pi * static_cast<double>(k) / static_cast<double>(count);
        const Vec3 e(std::cos(psi), std::sin(psi), 0.0);
        f[k] = off_axis.dot(e) + support(e).h - radius;
    }
    std::vector<double> found;
    for (std::size_t k = 0; k < count; ++k) {
        const double before = f[(k + count - 1) % count];
        const double after = f[(k + 1) % count];
        if (f[k] > 0.0 && f[k] > before && f[k] >= after) found.push_back(f[k]);
    }
    return found;
}

TEST(SrInsideCylinder, FindsEveryPlaceThatTouches) {
    Random random(61, 1);
    int several = 0;
    for (const SolidBody& body : bodies()) {
        for (int k = 0; k < 12; ++k) {
            Vec3 axis = random.direction();
            const double angle = random.uniform(0.0, 2.0 * pi);
            const Vec3 radial(std::cos(angle), std::sin(angle), 0.0);
            if (k % 4 == 1) axis = radial;           // flat against the wall
            if (k % 4 == 2) axis = z.cross(radial);  // rolling along it
            if (k % 4 == 3) axis = z;                // its band along the wall
            const SrSupport support{body.shape.support, axis};
            const CylinderWall wall{25.3e-3};
            // Push it out until the farthest point is 20 um beyond the wall.
            double low = 0.0;
            double high = wall.radius;
            for (int m = 0; m < 50; ++m) {
                const double r = 0.5 * (low + high);
                const WallTouch t = touch_inside(body.shape, support, wall, {z, r * radial}, {});
                double deepest = -1.0;
                for (std::size_t n = 0; n < t.count; ++n)
                    deepest = std::max(deepest, t.points[n].overlap);
                (deepest > 20e-6 ? high : low) = r;
            }
            const WallTouch touch = touch_inside(body.shape, support, wall, {z, low * radial}, {});
            std::vector<double> found;
            for (std::size_t n = 0; n < touch.count; ++n) found.push_back(touch.points[n].overlap);
            std::vector<double> expected = maxima_by_sampling(support, low * radial, wall.radius);
            std::sort(found.begin(), found.end());
            std::sort(expected.begin(), expected.end());
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t n = 0; n < found.size(); ++n)
                EXPECT_NEAR(found[n], expected[n], 1e-10);
            several += found.size() > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(several, 5);
}

// The body is put where it touches at e as deep as wanted; the search knows nothing of that.
TEST(SrInsideCylinder, APlaceThatIsFollowedIsTheOnlyOneAndWhereItIs) {
    Random random(65, 1);
    const CylinderWall wall{25.3e-3};
    for (const SolidBody& body : bodies()) {
        const double size = body.shape.bounding_radius;
        int followed = 0;
        int touching = 0;
        for (int k = 0; k < 2000; ++k) {
            const double angle = random.uniform(0.0, 2.0 * pi);
            const Vec3 e(std::cos(angle), std::sin(angle), 0.0);
            const Vec3 tau = z.cross(e);
            Vec3 axis = random.direction();
            if (k % 5 == 1) axis = (e + 0.2 * random.direction()).normalized();
            if (k % 5 == 2) axis = (tau + 0.1 * random.direction()).normalized();
            if (k % 5 == 3) axis = (z + 0.1 * random.direction()).normalized();
            const SrSupport support{body.shape.support, axis};
            const double overlap = random.uniform(1e-7, 1e-4);
            const Vec3 center = (wall.radius + overlap) * e - support(e).point(e);
            const double turn = math::exp(random.uniform(-16.0, -5.6));  // to 3.7e-3
            const TubePoseOf<double> pose{z, center, wall.radius, size};
            const auto place = followed_place(support, pose, Vec3(-(e + turn * tau).normalized()));
            ++touching;
            if (!place.is_only) continue;
            ++followed;
            EXPECT_NEAR(place.at.f, overlap, 1e-12 * size);
            EXPECT_LE((place.at.n - e).norm(), 2e-9);
            EXPECT_LE((place.at.middle - (support(e).point(e) - 0.5 * overlap * e)).norm(),
                      2e-9 * size);
            EXPECT_NEAR(place.z, (center + support(e).point(e)).z(), 2e-9 * size);
            const WallTouch touch = touch_inside(body.shape, support, wall, {z, center}, {});
            ASSERT_EQ(touch.count, 1U);
            EXPECT_NEAR(touch.points[0].overlap, overlap, 1e-11 * size);
        }
        EXPECT_GT(followed, touching / 4) << "of " << touching;
        RecordProperty("followed", followed);
    }
}

TEST(SrInsideCylinder, TheProvenGapIsSafe) {
    Random random(62, 1);
    const CylinderWall wall{25.3e-3};
    for (const SolidBody& body : bodies()) {
        for (int k = 0; k < 50; ++k) {
            const SrSupport support{body.shape.support, random.direction()};
            const Vec3 radial = random.direction().cross(z).normalized();
            const Vec3 center = random.uniform(0.0, 22e-3) * radial;
            const WallTouch t = touch_inside(body.shape, support, wall, {z, center}, {});
            if (t.count > 0) continue;
            // A body that moves by less than the gap, any way, touches nothing.
            ASSERT_LT(t.gap, wall.radius);
            for (int m = 0; m < 40; ++m) {
                const Vec3 way = (m % 2 == 0 ? radial : random.direction()) * 0.999 * t.gap;
                const Vec3 moved = center + random.uniform() * way;
                EXPECT_TRUE(maxima_by_sampling(support, moved, wall.radius, 720).empty());
            }
        }
    }
}

/// Overlap of a body with a rod by minimizing over directions of the whole sphere: the rod's
/// support function is R n_r + max(0, L n_z).
double rod_overlap_by_descent(const SrSupport& support, const CylinderWall& rod, const Vec3& center,
                              Random& random) {
    const auto f = [&](const Vec3& n) {
        return support(-n).h + rod.radius * std::hypot(n.x(), n.y()) +
               rod.length * std::max(0.0, n.z()) - n.dot(center);
    };
    Vec3 best = (center - Vec3(0.0, 0.0, 0.5 * rod.length)).normalized();
    for (int k = 0; k < 2000; ++k) {
        const Vec3 n = random.direction();
        if (f(n) < f(best)) best = n;
    }
    for (double spread = 0.1; spread > 1e-9; spread *= 0.5)
        for (int k = 0; k < 60; ++k) {
            Vec3 n = (best + spread * random.direction()).normalized();
            if (k % 3 == 0) n = Vec3(n.x(), n.y(), 0.0).normalized();
            if (f(n) < f(best)) best = n;
        }
    return f(best);
}

TEST(SrOutsideRod, OverlapIsTheLeastOfAllDirections) {
    Random random(63, 1);
    const CylinderWall rod{5e-3, 20e-3, false};
    int touching = 0;
    for (const SolidBody& body : bodies()) {
        for (int k = 0; k < 60; ++k) {
            const SrSupport support{body.shape.support, random.direction()};
            const double phi = random.uniform(0.0, 2.0 * pi);
            const double r = random.uniform(0.0, 12e-3);
            const double height =
                random.uniform() < 0.5 ? random.uniform(18e-3, 26e-3) : random.uniform(-6e-3, 2e-3);
            const Vec3 center(r * std::cos(phi), r * std::sin(phi), height);
            const WallTouch t = touch_rod(body.shape, support, rod, {z, center});
            const double expected = rod_overlap_by_descent(support, rod, center, random);
            if (expected > 1e-3) continue;  // deeper than any contact
            if (t.count == 0) {
                EXPECT_LT(expected, 2e-7);
                EXPECT_LE(t.gap, -expected + 2e-7);
            } else {
                ++touching;
                EXPECT_NEAR(t.points[0].overlap, expected, 2e-7);
            }
        }
    }
    EXPECT_GT(touching, 20);
}

TEST(SrWall, ASphereAsSurfaceOfRevolutionTouchesLikeASphere) {
    Random random(64, 1);
    const Sphere sphere{3e-3};
    const SolidBody body = round_body(3e-3);
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6);
    law.friction = 0.3;
    const CylinderWall inside{20e-3, 50e-3, true};
    const CylinderWall rod{5e-3, 50e-3, false};
    for (int k = 0; k < 400; ++k) {
        PairState pair;
        pair.i.orientation = random.orientation();
        pair.i.velocity = random.direction();
        pair.i.angular_velocity = 30.0 * random.direction();
        pair.i.inverse_inertia = body.inverse(1000.0);
        pair.i.inverse_inertia.moments.setConstant(pair.i.inverse_inertia.moments.x());
        pair.j.orientation = random.orientation();
        const Vec3 local_radial = random.direction().cross(z).normalized();
        const auto place = [&](const Vec3& local) {
            pair.displacement = -(pair.j.orientation * local);
        };
        const auto expect_same = [](const PairContact& a, const PairContact& b) {
            ASSERT_EQ(a.touches(), b.touches());
            EXPECT_NEAR(a.overlap, b.overlap, 1e-16);
            EXPECT_LE((a.force - b.force).norm(), 1e-7 * a.force.norm());
            EXPECT_LE((a.torque_i - b.torque_i).norm(), 1e-7 * 3e-3 * a.force.norm());
        };
        PointHistory h1;
        PointHistory h2;
        PatchHistory h3;
        MissCache miss;
        place(random.uniform(-20e-3, 20e-3) * local_radial + random.uniform(2.9e-3, 3.05e-3) * z);
        const PlaneWall disc{15e-3};
        expect_same(collide(sphere, disc, Call{pair, law, 1e-6, memory_of(h1)}),
                    collide(body.shape, disc, Call{pair, law, 1e-6, Memory{h2, miss}}));
        h1 = {};
        place(random.uniform(16.95e-3, 17.1e-3) * local_radial + random.uniform(-5e-3, 55e-3) * z);
        expect_same(collide(sphere, inside, Call{pair, law, 1e-6, memory_of(h1)}),
                    collide(body.shape, inside, Call{pair, law, 1e-6, Memory{h3, miss}}));
        h1 = {};
        h3 = {};
        place(random.uniform(0.0, 8e-3) * local_radial + random.uniform(50.0e-3, 53e-3) * z);
        expect_same(collide(sphere, rod, Call{pair, law, 1e-6, memory_of(h1)}),
                    collide(body.shape, rod, Call{pair, law, 1e-6, Memory{h3, miss}}));
    }
}

/// Holds the work of the force in a step against the change of the overlap while a cylinder rocks
/// on its side: over a wall at z = 0 whose lines run along x where it touches. `displacement`: from
/// the body to the wall when the body stands over its middle.
template <class Wall, class History>
void expect_work_of_rocking(const Wall& wall, const Quat& of_wall, const Vec3& displacement) {
    const SolidBody body = cylinder(3e-3, 8e-3);
    const ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 1.0);
    const double dt = 1e-5;
    for (int k = -20; k <= 20; ++k) {
        PairState pair;
        pair.i.inverse_inertia = body.inverse(1000.0);
        pair.i.velocity = Vec3(0.3, 0.0, -0.01);
        pair.i.angular_velocity = Vec3(0.0, 40.0, 0.0);
        pair.j.orientation = of_wall;
        const double passed = 0.05 * k;  // of a step since the axis was level
        const auto contact_at = [&](double steps) {
            PairState at = pair;
            at.displacement = displacement - steps * dt * pair.i.velocity;
            at.i.orientation = rotation(Vec3(0.0, 0.5 * pi + (passed + steps) * dt * 40.0, 0.0));
            History history;
            MissCache miss;
            return collide(body.shape, wall, Call{at, law, dt, Memory{history, miss}});
        };
        const PairContact now = contact_at(0.0);
        ASSERT_TRUE(now.touches());
        const double work =
            dt * (now.force.dot(pair.i.velocity) + now.torque_i.dot(pair.i.angular_velocity));
        const double change = contact_at(0.5).overlap - contact_at(-0.5).overlap;
        // The ends of the side go up and down by 4 mm * 4e-4 = 1.6e-6 m in a step.
        EXPECT_NEAR(work / now.force.norm(), -change, 1e-8) << passed;
    }
}

TEST(SrWall, AForceDoesWhatItsOverlapChangesByAlsoWhereABodyRocksOnItsSide) {
    const double height = 3e-3 - 5e-5;
    expect_work_of_rocking<PlaneWall, PointHistory>(PlaneWall{}, Quat::Identity(),
                                                    {0.0, 0.0, -height});
    // The axis of the tube runs along x.
    const Quat along_x = rotation(Vec3(0.0, 0.5 * pi, 0.0));
    expect_work_of_rocking<CylinderWall, PatchHistory>({14e-3, 0.2, true}, along_x,
                                                       {-0.1, 0.0, 14e-3 - height});
}

TEST(SrInsideCylinder, APointKeepsItsNumberWhileItMovesAndALostOneIsNotReused) {
    PatchHistory history;
    history.used = 2;
    history.slots[0].feature = 0;
    history.slots[0].normal = Vec3(1.0, 0.0, 0.0);
    history.slots[1].feature = 1;
    history.slots[1].normal = Vec3(0.0, 1.0, 0.0);
    WallTouch touch;
    touch.count = 2;
    touch.points[0] = {Vec3::Zero(), Vec3(-1.0, 0.0, 0.0), 1e-6, 0};
    touch.points[1] = {Vec3::Zero(), Vec3(0.1, 1.0, 0.0).normalized(), 1e-6, 0};
    give_features(touch, history);
    EXPECT_EQ(touch.points[0].feature, 1U);
    EXPECT_GT(touch.points[0].gradient.y(), 0.9);
    EXPECT_EQ(touch.points[1].feature, 2U);
}

}  // namespace
}  // namespace dem::test
