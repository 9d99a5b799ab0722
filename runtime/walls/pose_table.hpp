// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/walls/motion.hpp"

#include <cstddef>
#include <vector>

namespace dem::runtime {

/// A motion through poses at given times. Between them positions follow cubic and orientations
/// quaternion Hermite curves (Kim et al. 1995): position, orientation and both
/// velocities are continuous. The velocity at a row is that of the parabola through it and its
/// neighbors, at both ends through the first or last three; beside two rows of one pose it is zero,
/// so that what is to stand stands.
class PoseTable {
  public:
    struct Row {
        double time = 0.0;                    ///< [s]
        Vec3 position = Vec3::Zero();         ///< of the origin of the axes that move [m]
        Quat orientation = Quat::Identity();  ///< of these axes, unit length
    };

    /// At least two rows, in the order of time.
    explicit PoseTable(const std::vector<Row>& rows);

    double from() const { return knots_.front().row.time; }
    double until() const { return knots_.back().row.time; }
    std::size_t size() const { return knots_.size(); }
    double largest_speed() const { return largest_speed_; }  ///< of the origin [m/s]
    double largest_rate() const { return largest_rate_; }    ///< [rad/s]

    /// The axes at a time from `from` to `until` [s].
    MovingPose at(double time) const;

  private:
    struct Knot {
        Row row;
        Vec3 velocity = Vec3::Zero();  ///< [m/s]
        Vec3 spin = Vec3::Zero();      ///< angular velocity in the axes of the row [rad/s]
        Vec3 turn = Vec3::Zero();      ///< of the three rotations to the next row the second
    };
    void find_velocities();

    std::vector<Knot> knots_;
    double largest_speed_ = 0.0;
    double largest_rate_ = 0.0;
};

}  // namespace dem::runtime
