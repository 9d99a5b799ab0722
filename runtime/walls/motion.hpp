// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace dem::runtime {

class PoseTable;

/// One piece of a motion, active for from <= t < until of the motion's time; before it everything
/// stands, after it everything stays where it is.
struct MotionPiece {
    enum class Kind : std::uint8_t { translate, rotate, oscillate, table };
    Kind kind = Kind::translate;
    Vec3 velocity = Vec3::Zero();  ///< translate [m/s]
    Vec3 axis = Vec3::UnitZ();     ///< rotate: unit axis; oscillate: unit direction
    Vec3 point = Vec3::Zero();     ///< rotate: a point of the axis [m]
    double rate = 0.0;             ///< rotate [rad/s]
    double amplitude = 0.0;        ///< oscillate [m]
    double frequency = 0.0;        ///< oscillate [Hz]
    double from = 0.0;             ///< [s]
    double until = std::numeric_limits<double>::infinity();  ///< [s]

    /// So long does the velocity, the rate or the amplitude take from its first value to the one
    /// above [s]; amplitudes begin at 0.
    double ramp = 0.0;
    bool is_ramp_smooth = true;            ///< as x^2 (3 - 2 x), without a jump of acceleration
    Vec3 initial_velocity = Vec3::Zero();  ///< translate [m/s]
    double initial_rate = 0.0;             ///< rotate [rad/s]
    /// Of Kind::table alone, whose times are its times.
    std::shared_ptr<const PoseTable> table = nullptr;
};

/// A prescribed motion. Whatever it carries is where a closed form of time says: no drift, nothing
/// to store for a restart but the moment when the bodies had settled.
struct Motion {
    std::string name;                 ///< of its section; empty: a wall's own
    std::string where;                ///< "case.ini:31", for messages
    std::vector<MotionPiece> pieces;  ///< one after the other; each moves what those before left
    double start = 0.0;               ///< when the motion's own time begins [s] ...
    bool from_settled = false;        ///< ... or that it begins when all bodies have settled
    double period = std::numeric_limits<double>::infinity();  ///< begins anew after it [s]
    std::shared_ptr<const Motion> within;  ///< carries the axes and points of this one

    bool moves() const { return !pieces.empty() || within != nullptr; }
};

/// A time as motions see it.
struct MotionTime {
    double now;                                                ///< [s]
    double settled = std::numeric_limits<double>::infinity();  ///< when all bodies had; not yet [s]

    // NOLINTNEXTLINE(google-explicit-constructor): before anything has settled it is a time
    MotionTime(double time) : now(time) {}
    MotionTime(double time, double moment) : now(time), settled(moment) {}
};

/// Where something is and how it moves, world frame.
struct MovingPose {
    Vec3 position = Vec3::Zero();          ///< [m]
    Quat orientation = Quat::Identity();   ///< own -> world
    Vec3 velocity = Vec3::Zero();          ///< of the position [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
};

/// Takes what stands at `pose` to where the motion has it, and adds the motion's velocities.
void carry(MovingPose& pose, const Motion& motion, const MotionTime& at);

/// No point within `reach` [m] of every axis is ever moved faster [m/s].
double largest_speed(const Motion& motion, double reach);

/// Half the shortest time in which the motion repeats itself [s].
double half_period(const Motion& motion);

/// The time after its start from which no piece is still to begin or to be ramped [s].
double time_to_begin(const Motion& motion);

}  // namespace dem::runtime
