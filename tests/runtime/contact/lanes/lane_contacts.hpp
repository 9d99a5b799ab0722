// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/random.hpp"
#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <gtest/gtest.h>

/// Bodies, laws and comparisons for tests of kernels in lanes.
namespace dem::test {

using namespace runtime;

template <class Shape>
struct LaneTestBody {
    Shape shape;
    InverseInertia inertia;
    LaneKind kind;
};

inline LaneTestBody<Sphere> body(double radius) {
    const double mass = 1200.0 * 4.0 / 3.0 * pi * cube(radius);
    InverseInertia inertia;
    inertia.mass = 1.0 / mass;
    inertia.moments = Vec3::Constant(2.5 / (mass * square(radius)));
    inertia.surface = square(radius) * inertia.moments.x();
    return {{radius}, inertia, {inertia.mass, inertia.moments.x(), inertia.surface, radius}};
}

inline LaneTestBody<SrShape> body(const SolidBody& solid) {
    LaneTestBody<SrShape> b{solid.shape, solid.inverse(1200.0), {}};
    b.kind = {b.inertia.mass, b.inertia.moments.x(), b.inertia.surface, b.shape.bounding_radius,
              b.shape.equivalent_diameter};
    return b;
}

inline LaneRow row(const Vec3& position, const BodyState& state) {
    const auto plain = [](const Vec3& v) { return std::array{v.x(), v.y(), v.z()}; };
    return {plain(position), plain(body_axis(state.orientation)), plain(state.velocity),
            plain(state.angular_velocity)};
}

inline void move(PairState& pair, double dt) {
    pair.displacement += dt * (pair.j.velocity - pair.i.velocity);
    for (BodyState* b : {&pair.i, &pair.j})
        b->orientation = Quat(
            Eigen::AngleAxisd(dt * b->angular_velocity.norm(), b->angular_velocity.normalized()) *
            b->orientation);
}

inline bool same(const StoredVec3& a, const Vec3& b) {
    return Vec3(a) == b;
}

/// Whether two histories are the same byte for byte.
template <class History>
bool same_bytes(const History& a, const History& b) {
    return std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
}

/// What went in lanes, and what was left to collide().
struct Count {
    int in_lanes = 0;
    int rare = 0;
};

/// Holds what a kernel found against what collide() says.
inline void expect_same(const PairResult& found, double overlap, const PairContact& expected) {
    EXPECT_TRUE(expected.touches());
    EXPECT_TRUE(same(found.force, expected.force) && same(found.torque_i, expected.torque_i) &&
                same(found.torque_j, expected.torque_j))
        << Vec3(found.force).transpose() << " but " << expected.force.transpose();
    EXPECT_EQ(found.elastic_energy, expected.elastic_energy);
    EXPECT_EQ(found.dissipated_energy, expected.dissipated_energy);
    EXPECT_EQ(overlap, expected.overlap);
}

inline std::vector<ContactLaw> laws() {
    std::vector<ContactLaw> all;
    ContactLaw options;
    options.friction = 0.3;
    const auto hertz = [&] { all.push_back(pair_law({5e7, 0.3}, {5e7, 0.3}, 0.6, options)); };
    hertz();
    options.tangential = ContactLaw::Tangential::ratio;
    options.damping_mass = ContactLaw::DampingMass::reduced;
    hertz();
    options.limit_force = true;
    options.geometry.radius = ContactLaw::Radius::local;
    hertz();
    options.geometry.radius = ContactLaw::Radius::equivalent;
    hertz();
    options = {};
    options.friction = 0.05;
    all.push_back(linear_law(2e4, 0.6, 0.5, options));
    return all;
}

}  // namespace dem::test
