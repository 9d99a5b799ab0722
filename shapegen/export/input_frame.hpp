// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"

#include <string>

namespace dem::shapegen {

/// From the body frame of a shape to the frame of its input, in a unit of length: what is exported
/// in it lies on the input where the unit is that of the input.
class InputFrame {
  public:
    /// `unit`: of lengths that come out [m].
    InputFrame(const ParticleTemplate& shape, double unit)
        : body_(shape.mass_properties), unit_(unit) {}

    Vec3 point(const Vec3& in_body) const {
        return (body_.center_of_mass + body_.principal_axes * in_body) / unit_;
    }
    double length(double meters) const { return meters / unit_; }
    double unit() const { return unit_; }  ///< [m]

    /// The name of the unit, or what it is in meters where it has none: "mm", "0.02 m".
    std::string unit_name() const;

  private:
    MassProperties body_;
    double unit_;
};

}  // namespace dem::shapegen
