// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "common/shapes/convex_shape.hpp"
#include "common/shapes/mass_properties.hpp"
#include "common/shapes/sphere.hpp"
#include "common/shapes/sr_shape.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dem {

/// Triangles for looking at, body frame; counter-clockwise seen from outside.
struct DisplayMesh {
    SharedArray<Vec3> vertices;  ///< [m]
    SharedArray<std::array<std::uint32_t, 3>> triangles;
    double max_deviation = 0.0;  ///< of the mesh from the true surface [m]
};

/// What was measured about the approximation: name (snake_case, unit in the name's documentation in
/// docs/template-format.md) and value, in a fixed order.
using Certificate = std::vector<std::pair<std::string, double>>;

/// One shape as `shapegen` cooked it.
struct ParticleTemplate {
    std::string name;
    MassProperties mass_properties;
    double bounding_radius = 0.0;                ///< about the center of mass [m]
    double mean_squared_surface_distance = 0.0;  ///< area-weighted, from the center of mass [m^2]
    bool is_convex = false;
    DisplayMesh display_mesh;
    Certificate certificate;
    /// What the numbers of the input are in [m], a scale included: exports that are to lie on the
    /// input are written in it.
    double input_unit = 1.0;
    std::variant<Sphere, SrShape, Clump, ConvexShape> shape;
};

/// The content of a `.tpl` file.
struct TemplateFile {
    std::string command;           ///< the `shapegen` command line that made it
    std::uint64_t input_hash = 0;  ///< file_hash() of the input
    std::string shapegen_version;
    std::vector<ParticleTemplate> shapes;
};

/// "sphere", "sr", "clump", "convex": the word used in files and messages.
std::string kind_name(const ParticleTemplate& shape);

}  // namespace dem
