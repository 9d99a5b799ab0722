// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/pose_table.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"
#include "common/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// Axis times angle of the shorter rotation [rad].
Vec3 rotation_vector(const Quat& q) {
    const double sine = q.vec().norm();
    if (!(sine > 0.0)) return Vec3::Zero();
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    return (2.0 * sign * math::atan2(sine, sign * q.w()) / sine) * q.vec();
}

Quat rotation_by(const Vec3& vector) {
    const double angle = vector.norm();
    return angle > 0.0 ? rotation_about(vector / angle, angle) : Quat(1.0, 0.0, 0.0, 0.0);
}

/// What one step of the table changes per time.
struct Chord {
    double time;  ///< [s]
    Vec3 velocity;
    Vec3 spin;
};

/// Slope in the middle of two chords of the parabola through their three ends.
Vec3 middle_slope(double h0, const Vec3& d0, double h1, const Vec3& d1) {
    if (d0.isZero(0.0) || d1.isZero(0.0)) return Vec3::Zero();
    return (h1 * d0 + h0 * d1) / (h0 + h1);
}

/// Slope of the parabola at the other end of a chord.
Vec3 end_slope(const Vec3& chord, const Vec3& slope, bool has_more) {
    if (!has_more) return chord;
    return chord.isZero(0.0) ? Vec3(Vec3::Zero()) : Vec3(2.0 * chord - slope);
}

}  // namespace

PoseTable::PoseTable(const std::vector<Row>& rows) {
    DEM_ASSERT(rows.size() >= 2);
    for (const Row& row : rows) knots_.push_back({row});
    find_velocities();
    for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
        Knot& a = knots_[k];
        const Knot& b = knots_[k + 1];
        const double h = b.row.time - a.row.time;
        a.turn = rotation_vector(rotation_by(h / 3.0 * a.spin).conjugate() *
                                 (a.row.orientation.conjugate() * b.row.orientation) *
                                 rotation_by(h / 3.0 * b.spin).conjugate());
    }
    constexpr int looks = 16;
    for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
        for (int look = 0; look <= looks; ++look) {
            const double share = static_cast<double>(look) / looks;
            const MovingPose pose =
                at((1.0 - share) * knots_[k].row.time + share * knots_[k + 1].row.time);
            largest_speed_ = std::max(largest_speed_, pose.velocity.norm());
            largest_rate_ = std::max(largest_rate_, pose.angular_velocity.norm());
        }
    }
}

void PoseTable::find_velocities() {
    std::vector<Chord> chords;
    for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
        const Row& a = knots_[k].row;
        const Row& b = knots_[k + 1].row;
        const double h = b.time - a.time;
        chords.push_back({h, (b.position - a.position) / h,
                          rotation_vector(a.orientation.conjugate() * b.orientation) / h});
    }
    for (std::size_t k = 0; k + 1 < chords.size(); ++k) {
        const Chord& c = chords[k];
        const Chord& d = chords[k + 1];
        knots_[k + 1].velocity = middle_slope(c.time, c.velocity, d.time, d.velocity);
        knots_[k + 1].spin = middle_slope(c.time, c.spin, d.time, d.spin);
    }
    const bool has_more = chords.size() > 1;
    const auto set_end = [&](Knot& end, const Chord& chord, const Knot& next) {
        end.velocity = end_slope(chord.velocity, next.velocity, has_more);
        end.spin = end_slope(chord.spin, next.spin, has_more);
    };
    set_end(knots_.front(), chords.front(), knots_[1]);
    set_end(knots_.back(), chords.back(), knots_[knots_.size() - 2]);
}

MovingPose PoseTable::at(double time) const {
    const auto next =
        std::upper_bound(knots_.begin() + 1, knots_.end() - 1, time,
                         [](double t, const Knot& knot) { return t < knot.row.time; });
    const Knot& a = *(next - 1);
    const Knot& b = *next;
    const double h = b.row.time - a.row.time;
    const double s = (time - a.row.time) / h;
    const double r = 1.0 - s;
    MovingPose pose;
    pose.position = r * r * (1.0 + 2.0 * s) * a.row.position + s * r * r * h * a.velocity +
                    s * s * (3.0 - 2.0 * s) * b.row.position - s * s * r * h * b.velocity;
    pose.velocity = 6.0 * s * r / h * (b.row.position - a.row.position) +
                    r * (1.0 - 3.0 * s) * a.velocity + s * (3.0 * s - 2.0) * b.velocity;
    // Three rotations about fixed axes, by shares that go from 0 to 1: 1 - (1 - s)^3, 3 s^2 - 2 s^3
    // and s^3.
    const Vec3 first = h / 3.0 * a.spin;
    const Vec3 last = h / 3.0 * b.spin;
    const Quat turn1 = a.row.orientation * rotation_by((1.0 - r * r * r) * first);
    const Quat turn2 = turn1 * rotation_by(s * s * (3.0 - 2.0 * s) * a.turn);
    pose.orientation = (turn2 * rotation_by(s * s * s * last)).normalized();
    pose.angular_velocity = turn1 * Vec3(3.0 * r * r / h * first + 6.0 * s * r / h * a.turn) +
                            turn2 * Vec3(3.0 * s * s / h * last);
    return pose;
}

}  // namespace dem::runtime
