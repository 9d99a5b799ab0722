// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/motion.hpp"

#include "common/math/elementary.hpp"
#include "common/math/rotation.hpp"
#include "runtime/walls/pose_table.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

using Kind = MotionPiece::Kind;

/// How far something has gone, and how fast it goes.
template <class T>
struct Course {
    T way;
    T speed;
};

struct Share {
    double value;
    double rate;      ///< [1/s]
    double integral;  ///< [s]
};

/// The share of a ramp that is done a time s after its start, s < ramp [s].
Share ramp_share(const MotionPiece& piece, double s) {
    const double x = s / piece.ramp;
    if (!piece.is_ramp_smooth) return {x, 1.0 / piece.ramp, 0.5 * x * s};
    return {x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / piece.ramp, x * x * (1.0 - 0.5 * x) * s};
}

/// A time s after the start, at a speed that goes from the first to the last one.
template <class T>
Course<T> course(const MotionPiece& piece, const T& first, const T& last, double s) {
    if (piece.ramp == 0.0) return {s * last, last};
    if (s >= piece.ramp) return {0.5 * piece.ramp * (first + last) + (s - piece.ramp) * last, last};
    const Share share = ramp_share(piece, s);
    return {s * first + share.integral * (last - first), first + share.value * (last - first)};
}

Course<double> swing(const MotionPiece& piece, double s) {
    const double omega = 2.0 * pi * piece.frequency;
    const auto [sine, cosine] = math::sin_cos(omega * s);
    const Course<double> full{piece.amplitude * sine, piece.amplitude * omega * cosine};
    if (s >= piece.ramp) return full;
    const Share share = ramp_share(piece, s);
    return {share.value * full.way, share.value * full.speed + share.rate * full.way};
}

void shift(MovingPose& pose, const Vec3& way) {
    pose.position += way;
}

/// Turns everything about an axis that rests.
void turn(MovingPose& pose, const Quat& by, const Vec3& point) {
    pose.position = point + by * Vec3(pose.position - point);
    pose.orientation = by * pose.orientation;
    pose.velocity = by * pose.velocity;
    pose.angular_velocity = by * pose.angular_velocity;
}

/// Adds the velocity of a body that turns about a point.
void add_spin(MovingPose& pose, const Vec3& spin, const Vec3& point) {
    pose.velocity += spin.cross(pose.position - point);
    pose.angular_velocity += spin;
}

/// The axes of a table, moved: what lay in the world's lies in them.
void follow(MovingPose& pose, const PoseTable& table, double time, bool is_moving) {
    const MovingPose axes = table.at(time);
    turn(pose, axes.orientation, Vec3::Zero());
    pose.position += axes.position;
    if (!is_moving) return;
    pose.velocity += axes.velocity;
    add_spin(pose, axes.angular_velocity, axes.position);
}

void carry(MovingPose& pose, const MotionPiece& piece, double s, bool is_moving) {
    switch (piece.kind) {
        case Kind::translate: {
            const Course<Vec3> c = course(piece, piece.initial_velocity, piece.velocity, s);
            shift(pose, c.way);
            if (is_moving) pose.velocity += c.speed;
            break;
        }
        case Kind::rotate: {
            const Course<double> c = course(piece, piece.initial_rate, piece.rate, s);
            turn(pose, rotation_about(piece.axis, c.way), piece.point);
            if (is_moving) add_spin(pose, c.speed * piece.axis, piece.point);
            break;
        }
        case Kind::oscillate: {
            const Course<double> c = swing(piece, s);
            shift(pose, c.way * piece.axis);
            if (is_moving) pose.velocity += c.speed * piece.axis;
            break;
        }
        case Kind::table:
            break;
    }
}

/// All pieces that have begun by a time within the first period.
void carry_in_period(MovingPose& pose, const Motion& motion, double time) {
    for (const MotionPiece& piece : motion.pieces) {
        if (piece.kind == Kind::table) {
            const bool is_moving = time >= piece.from && time < piece.until;
            follow(pose, *piece.table, std::clamp(time, piece.from, piece.until), is_moving);
            continue;
        }
        if (time < piece.from) break;
        const bool is_moving = time < piece.until;
        carry(pose, piece, (is_moving ? time : piece.until) - piece.from, is_moving);
    }
}

/// What `count` periods do, from what one does, by doubling it: their error grows like theirs.
void carry_by_periods(MovingPose& pose, const Motion& motion, double count) {
    MovingPose power;
    carry_in_period(power, motion, motion.period);
    for (; count > 0.0; count = std::floor(0.5 * count)) {
        if (std::fmod(count, 2.0) == 1.0) {
            turn(pose, power.orientation, Vec3::Zero());
            shift(pose, power.position);
        }
        power.position += power.orientation * Vec3(power.position);
        power.orientation = (power.orientation * power.orientation).normalized();
    }
}

double largest_speed(const MotionPiece& piece, double reach) {
    switch (piece.kind) {
        case Kind::translate:
            return std::max(piece.velocity.norm(), piece.initial_velocity.norm());
        case Kind::rotate:
            return std::max(std::abs(piece.rate), std::abs(piece.initial_rate)) * reach;
        case Kind::oscillate: {
            constexpr double steepest_ramp = 1.5;
            return 2.0 * pi * piece.frequency * piece.amplitude +
                   (piece.ramp > 0.0 ? steepest_ramp * piece.amplitude / piece.ramp : 0.0);
        }
        case Kind::table:
            return piece.table->largest_speed() + piece.table->largest_rate() * reach;
    }
    return 0.0;
}

}  // namespace

void carry(MovingPose& pose, const Motion& motion, const MotionTime& at) {
    double time = at.now - (motion.from_settled ? at.settled : motion.start);
    if (time >= motion.period) {
        const double periods = std::floor(time / motion.period);
        carry_by_periods(pose, motion, periods);
        time = std::max(0.0, time - periods * motion.period);
    }
    carry_in_period(pose, motion, time);
    if (motion.within) carry(pose, *motion.within, at);
}

double largest_speed(const Motion& motion, double reach) {
    double speed = 0.0;
    for (const MotionPiece& piece : motion.pieces)
        speed = std::max(speed, largest_speed(piece, reach));
    return speed + (motion.within ? largest_speed(*motion.within, reach) : 0.0);
}

double half_period(const Motion& motion) {
    double time = 0.5 * motion.period;
    for (const MotionPiece& piece : motion.pieces)
        if (piece.kind == Kind::oscillate) time = std::min(time, 0.5 / piece.frequency);
    return motion.within ? std::min(time, half_period(*motion.within)) : time;
}

double time_to_begin(const Motion& motion) {
    return motion.pieces.empty() ? 0.0 : motion.pieces.back().from + motion.pieces.back().ramp;
}

}  // namespace dem::runtime
