// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "common/shapes/particle_template.hpp"
#include "runtime/files/png.hpp"
#include "runtime/walls/wall.hpp"

#include <span>
#include <vector>

/// A picture of the particles without any other program: their display meshes, orthographic, lit
/// from the viewer's left shoulder, outlined where one body ends and another begins. Walls are
/// drawn as thin lines.
namespace dem::runtime {

struct PictureBody {
    const DisplayMesh* mesh;
    Vec3 position;  ///< [m]
    Quat orientation;
    std::uint32_t color;  ///< index into a fixed palette (for example the body's group)
};

struct PictureView {
    double azimuth = -1.2;     ///< of the viewer about +z from +x [rad]
    double elevation = 0.25;   ///< of the viewer above the horizon [rad]
    std::size_t pixels = 900;  ///< of the longer side
};

/// Renders bodies and walls; walls without limits are cut at the bodies' extent.
Image render_picture(std::span<const PictureBody> bodies, std::span<const Wall> walls,
                     const MotionTime& time, const PictureView& view);

}  // namespace dem::runtime
