// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/certificate/certificate_text.hpp"

#include <array>
#include <cstdio>
#include <string_view>

namespace dem::shapegen {

namespace {

struct Entry {
    std::string_view name;
    const char* unit;
    const char* meaning;
};

/// Without a unit of its own: the unit of lengths of the shape. l is the major axis of the shape,
/// d_eq the diameter of the sphere of equal volume.
constexpr std::array entries = {
    Entry{"sdf_error_mean", "l", "distance field against exact distances near the surface, mean"},
    Entry{"sdf_error_rms", "l", "  the same, root mean square"},
    Entry{"sdf_error_max", "l", "  the same, largest"},
    Entry{"sdf_gradient_angle_rms", "deg", "direction of its gradient, root mean square"},
    Entry{"sdf_gradient_angle_max", "deg",
          "  the same, largest (large only in cells that hold an edge)"},
    Entry{"support_error_max", "l", "support points against the profile's"},
    Entry{"curvature_error_max", "", "curvature between the samples of its table, relative"},
    Entry{"node_spacing_mean", "l", "distance of a surface node from its nearest neighbor, mean"},
    Entry{"node_spacing_max", "l", "  the same, largest"},
    Entry{"node_surface_error_max", "l", "surface spanned by the nodes"},
    Entry{"display_mesh_error_max", nullptr, "surface shown in pictures"},
    Entry{"volume_error", "", "volume against an independent integration, relative"},
    Entry{"coverage", "", "part of the volume inside the spheres"},
    Entry{"outside", "", "  volume of the spheres outside of the shape, over that of the shape"},
    Entry{"ceiling", "", "  the largest part that inscribed candidates could cover"},
    Entry{"components", "", "number of pieces that do not touch each other"},
    Entry{"volume_ratio", "", "volume of the union of the spheres over that of the shape"},
    Entry{"rms_deviation", "d_eq",
          "surface of the spheres against that of the shape, root mean square"},
    Entry{"max_deviation_in", "d_eq", "  the same, deepest below the surface"},
    Entry{"max_deviation_out", "d_eq", "  the same, furthest outside"},
    Entry{"moment_errors_x", "", "moments of the union of the spheres, relative, about x"},
    Entry{"moment_errors_y", "", "  the same about y"},
    Entry{"moment_errors_z", "", "  the same about z"},
    Entry{"slope_rms", "deg", "direction of the surface, root mean square"},
    Entry{"mass_tolerance", "", "moments of the masses of the spheres, relative"},
    Entry{"mass_product_tolerance", "", "their products of inertia, relative to the mean moment"},
    Entry{"mass_center_tolerance", "d_eq", "their center of mass"},
    Entry{"rounding", "d_eq", "radius of edges and corners"},
    Entry{"rounding_loss", "", "volume that the rounding took, over that of the sharp body"},
    Entry{"corner_retreat", "d_eq", "how far the rounding moved the sharpest corner in"},
    Entry{"facet_error_max", "d_eq", "facets against the curved surface that they stand for"},
    Entry{"hull_excess", "", "volume that the hull adds, over that of the mesh"},
    Entry{"hull_error_max", "d_eq", "hull of the vertices kept against that of all, largest"},
    Entry{"hull_loss", "", "  volume that is missing, relative"},
    Entry{"core_scale", "", "factor of its lengths, for the volume of the mesh"},
};

}  // namespace

std::string certificate_line(const std::string& name, double value, const char* length_unit) {
    const Entry* found = nullptr;
    for (const Entry& entry : entries) {
        if (entry.name == name) found = &entry;
    }
    std::array<char, 64> number{};
    const char* unit = found == nullptr ? "" : found->unit != nullptr ? found->unit : length_unit;
    std::snprintf(number.data(), number.size(), "%10.3g %-4s", value, unit);
    return "    " + std::string(number.data()) + "  " + (found ? found->meaning : name) + "\n";
}

}  // namespace dem::shapegen
