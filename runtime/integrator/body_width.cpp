// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each width, under the rules of contact/lanes/lane_width.cpp.
#include "common/math/lanes.hpp"
#include "runtime/integrator/body_widths.hpp"
#include "runtime/integrator/rigid_body.hpp"

namespace dem::runtime {

namespace {

using Real = Lanes<DEM_LANE_WIDTH>;
using Vector = Vec3Of<Real>;
using Mask = MaskOf<Real>;
constexpr std::size_t width = DEM_LANE_WIDTH;

/// The bodies of all lanes; past the last one that one again.
struct Group {
    std::size_t first, count;
    std::size_t body(std::size_t l) const { return first + (l < count ? l : count - 1); }
};

Vector vector(const double* numbers, const Group& group) {
    Vector v;
    for (std::size_t l = 0; l < width; ++l) {
        const double* const at = numbers + 3 * group.body(l);
        v.x_[l] = at[0];
        v.y_[l] = at[1];
        v.z_[l] = at[2];
    }
    return v;
}

QuatOf<Real> quaternion(const double* numbers, const Group& group) {
    QuatOf<Real> q;
    for (std::size_t l = 0; l < width; ++l) {
        const double* const at = numbers + 4 * group.body(l);
        q.x_[l] = at[0];
        q.y_[l] = at[1];
        q.z_[l] = at[2];
        q.w_[l] = at[3];
    }
    return q;
}

Real number(const double* numbers, const Group& group) {
    Real r;
    for (std::size_t l = 0; l < width; ++l) r[l] = numbers[group.body(l)];
    return r;
}

void store(const Vector& v, std::size_t l, double* numbers, std::size_t body) {
    numbers[3 * body] = v.x_[l];
    numbers[3 * body + 1] = v.y_[l];
    numbers[3 * body + 2] = v.z_[l];
}

void store(const QuatOf<Real>& q, std::size_t l, double* numbers, std::size_t body) {
    numbers[4 * body] = q.x_[l];
    numbers[4 * body + 1] = q.y_[l];
    numbers[4 * body + 2] = q.z_[l];
    numbers[4 * body + 3] = q.w_[l];
}

/// KindMotion in each lane.
struct Motion {
    Real inverse_mass;
    AxialMoments<Real> moments;
    Real reach;
    Mask is_axial, is_free;
};

Motion motion(const BodyArrays& bodies, const Group& group) {
    const auto of = [&](double KindMotion::*quantity) {
        Real r;
        for (std::size_t l = 0; l < width; ++l)
            r[l] = bodies.kinds[bodies.kind[group.body(l)]].*quantity;
        return r;
    };
    const Real inverse_mass = of(&KindMotion::inverse_mass);
    return {inverse_mass,
            {of(&KindMotion::inverse_across), of(&KindMotion::inverse_along)},
            of(&KindMotion::reach),
            of(&KindMotion::is_axial) > 0.0,
            inverse_mass > 0.0};
}

/// v += h F/m, L += h T of the bodies that are free.
void kick(const Motion& m, const Vector& force, const Vector& torque, double h, Vector& v,
          Vector& L) {
    v = select(m.is_free, v + Real(h * m.inverse_mass) * force, v);
    L = select(m.is_free, L + h * torque, L);
}

template <class Move>
std::uint64_t for_each_group(std::size_t first, std::size_t count, const Move& move) {
    std::uint64_t moved = 0;
    for (std::size_t k = 0; k < count; k += width) {
        const Group group{first + k, count - k < width ? count - k : width};
        const Mask is_moved = move(group);
        for (std::size_t l = 0; l < group.count; ++l)
            moved |= std::uint64_t{is_moved[l] != 0} << (k + l);
    }
    return moved;
}

std::uint64_t advance(const BodyArrays& bodies, std::size_t first, std::size_t count, double dt) {
    return for_each_group(first, count, [&](const Group& group) {
        const Motion m = motion(bodies, group);
        const Vector force = vector(bodies.force, group);
        const Vector torque = vector(bodies.torque, group);
        Vector v = vector(bodies.velocity, group);
        Vector L = vector(bodies.angular_momentum, group);
        kick(m, force, torque, 0.5 * dt, v, L);

        const Real inverse = larger(m.moments.across, m.moments.along);
        const Real surface_speed = m.reach * (inverse * L.norm());
        const Real speed = v.norm() + select(m.reach > 0.0, surface_speed, Real{});
        const Real travel = number(bodies.travel, group) + speed * dt;
        const Vector x = vector(bodies.position, group) + dt * v;
        Mask is_small = m.is_axial;
        const QuatOf<Real> q = precessed<Real>(m.moments, quaternion(bodies.orientation, group), L,
                                               dt, [&](const Vector& turn) {
                                                   const Real x2 = 0.25 * turn.squaredNorm();
                                                   is_small = both(is_small, x2 < small_turn2);
                                                   return small_rotation(turn, x2);
                                               });

        kick(m, force, torque, 0.5 * dt, v, L);
        const Vector omega = angular_velocity_of<Real>(m.moments, body_axis(q), L);
        for (std::size_t l = 0; l < group.count; ++l) {
            if (is_small[l] == 0) continue;
            const std::size_t body = group.body(l);
            store(x, l, bodies.position, body);
            store(q, l, bodies.orientation, body);
            store(v, l, bodies.velocity, body);
            store(L, l, bodies.angular_momentum, body);
            store(omega, l, bodies.angular_velocity, body);
            bodies.travel[body] = travel[l];
        }
        return is_small;
    });
}

std::uint64_t correct(const BodyArrays& bodies, std::size_t first, std::size_t count, double dt) {
    return for_each_group(first, count, [&](const Group& group) {
        const Motion m = motion(bodies, group);
        Vector v = vector(bodies.velocity, group);
        Vector L = vector(bodies.angular_momentum, group);
        kick(m, vector(bodies.force, group) - vector(bodies.old_force, group),
             vector(bodies.torque, group) - vector(bodies.old_torque, group), 0.5 * dt, v, L);
        const QuatOf<Real> q = quaternion(bodies.orientation, group);
        const Vector omega = angular_velocity_of<Real>(m.moments, body_axis(q), L);
        for (std::size_t l = 0; l < group.count; ++l) {
            if (m.is_axial[l] == 0) continue;
            const std::size_t body = group.body(l);
            store(v, l, bodies.velocity, body);
            store(L, l, bodies.angular_momentum, body);
            store(omega, l, bodies.angular_velocity, body);
        }
        return m.is_axial;
    });
}

}  // namespace

#define DEM_JOINED(a, b) a##b
#define DEM_NAME(name, width) DEM_JOINED(name, width)
const BodyKernels& DEM_NAME(body_kernels_, DEM_LANE_WIDTH)() {
    static const BodyKernels kernels{DEM_LANE_WIDTH, advance, correct};
    return kernels;
}

}  // namespace dem::runtime
