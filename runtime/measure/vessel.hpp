// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <cstdint>
#include <optional>

namespace dem::runtime {

/// The container that the walls of a scene form: an upright cylinder or box on a floor, at time 0.
struct Vessel {
    enum class Shape : std::uint8_t { cylinder, box };

    Shape shape = Shape::cylinder;
    Vec3 up = Vec3::UnitZ();     ///< unit, against gravity; z without gravity
    Vec3 center = Vec3::Zero();  ///< a point of its axis
    double floor = 0.0;          ///< height of the floor along `up` from the world's origin [m]
    double radius = 0.0;         ///< of the circle about `center` that holds the cross-section [m]
    double cross_section = 0.0;  ///< [m^2]
    Vec3 side = Vec3::UnitX();   ///< unit, horizontal; of a box normal to two of its walls
    double width = 0.0;          ///< of a box along `side` [m]
};

/// None when the walls are not such a container. The floor is the highest plane that looks up;
/// without one it is the end of the cylinder. With several upright cylinders the first one counts.
std::optional<Vessel> find_vessel(const Scene& scene);

}  // namespace dem::runtime
