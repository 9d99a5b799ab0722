// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/cook_convex.hpp"

#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "common/format.hpp"
#include "common/shapes/convex_moments.hpp"
#include "common/units.hpp"
#include "formats/memory_map.hpp"
#include "shapegen/convex/convex_display.hpp"
#include "shapegen/convex/core_scale.hpp"
#include "shapegen/convex/exact_hull.hpp"
#include "shapegen/convex/fewer_vertices.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/solids/hull_faces.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <utility>

namespace dem::shapegen {

namespace {

constexpr double display_tolerance = 1e-3;  // of the display mesh, in d_eq

/// A body without rounding, in any frame.
ConvexSolid sharp_solid(const ConvexPolyhedron& hull) {
    return with_mass_properties(rounded_around(hull, 0.0));
}

double volume_of(const ConvexPolyhedron& core, double rounding) {
    return convex_moments(rounded_around(core, rounding)).volume;
}

void finish(CookedConvex& cooked, ConvexSolid solid, std::string name, Certificate hull) {
    const double d_eq = solid.shape.equivalent_diameter;
    const double loss = solid.rounding_loss;
    const double retreat = solid.corner_retreat;
    const double facets = solid.facet_error;
    DisplayMesh display = convex_display_mesh(solid.shape, display_tolerance * d_eq);
    cooked.shape = convex_template(std::move(solid), std::move(name));
    const double rounding = std::get<ConvexShape>(cooked.shape.shape).rounding;
    cooked.shape.certificate = {
        {"rounding", rounding / d_eq}, {"rounding_loss", loss}, {"corner_retreat", retreat / d_eq}};
    if (facets > 0.0) cooked.shape.certificate.emplace_back("facet_error_max", facets / d_eq);
    for (auto& entry : hull) cooked.shape.certificate.push_back(std::move(entry));
    cooked.shape.certificate.emplace_back("display_mesh_error_max", display.max_deviation / d_eq);
    cooked.shape.display_mesh = std::move(display);
    if (rounding <= 0.0 || retreat <= 0.0) return;
    const LengthUnit unit = length_unit(d_eq);
    cooked.lines.push_back(
        format("rounded with a radius of %.4g %s, which takes %.2g %% of the volume and moves "
               "corners in by %.3g %s at most",
               rounding / unit.meters, unit.name.c_str(), 1e2 * loss, retreat / unit.meters,
               unit.name.c_str()));
}

CookedConvex cook_file(const std::filesystem::path& path, const ConvexRequest& request,
                       double scale) {
    ConvexFile file = is_convex_file(path)
                          ? read_convex(path.string(), request.rounding, scale)
                          : read_convex_profile(path.string(), request.rounding, scale);
    CookedConvex cooked;
    cooked.hash = file.hash;
    cooked.lines = std::move(file.lines);
    finish(cooked, std::move(file.solid), file.name, {});
    cooked.shape.input_unit = file.unit;
    return cooked;
}

/// The hull of a mesh on its way to a rounded body, about the hull's center.
struct MeshHull {
    ConvexPolyhedron hull, core;
    Vec3 center;            ///< in the frame of the mesh [m]
    double volume;          ///< of the hull [m^3]
    double rounding;        ///< [m]
    double rounded_volume;  ///< of the core with its rounding [m^3]
};

MeshHull hull_of(const TriangleMesh& mesh, const std::optional<Rounding>& rounding) {
    MeshHull result{exact_hull(mesh.vertices), {}, {}, 0.0, 0.0, 0.0};
    // About its center: no differences of large moments.
    result.center = sharp_solid(result.hull).mass_properties.center_of_mass;
    for (Vec3& v : result.hull.vertices) v -= result.center;
    const ConvexSolid sharp = sharp_solid(result.hull);
    result.volume = sharp.mass_properties.volume;
    result.rounding =
        rounding ? rounding->radius(result.volume) : default_rounding(sharp.shape, result.volume);
    result.core = eroded(result.hull, result.rounding, exact_hull);
    result.rounded_volume = volume_of(result.core, result.rounding);
    return result;
}

/// Scales a core about the center of mass of the body around it, so that this body has a volume.
double scale_to(double volume, double rounding, ConvexPolyhedron& core) {
    const double scale = core_scale(core, rounding, volume);
    const Vec3 center =
        with_mass_properties(rounded_around(core, rounding)).mass_properties.center_of_mass;
    for (Vec3& v : core.vertices) v = center + scale * (v - center);
    return scale;
}

CookedConvex cook_mesh(const std::filesystem::path& path, const ConvexRequest& request,
                       const MeshLoadOptions& options) {
    LoadedMesh loaded = load_mesh(path, options);
    CookedConvex cooked;
    cooked.hash = file_hash(MemoryMap(path, "mesh").bytes());
    cooked.lines = std::move(loaded.lines);

    const double mesh_volume = enclosed_volume(loaded.mesh);
    const MeshHull full = hull_of(loaded.mesh, request.rounding);
    const std::size_t vertices = full.core.vertices.size();
    FewerVertices fewer = with_fewer_vertices(full.core, request.vertices.value_or(vertices));
    const double loss = 1.0 - volume_of(fewer.solid, full.rounding) / full.rounded_volume;
    const double scale =
        request.keeps_volume ? scale_to(mesh_volume, full.rounding, fewer.solid) : 1.0;
    ConvexSolid solid = with_mass_properties(rounded_around(fewer.solid, full.rounding));
    if (full.rounding > 0.0) solid.rounding_loss = 1.0 - full.rounded_volume / full.volume;
    solid.corner_retreat = farthest_outside(
        with_mass_properties(rounded_around(full.core, full.rounding)), full.hull.vertices);
    solid.mass_properties.center_of_mass += full.center;

    const double d_eq = solid.shape.equivalent_diameter;
    const double excess = full.volume / mesh_volume - 1.0;
    const double ratio = solid.mass_properties.volume / mesh_volume;
    cooked.lines.push_back(
        format("hull of %zu vertices and %zu faces, which adds %.3g %% to the "
               "volume of the mesh",
               full.hull.vertices.size(), full.hull.faces.size(), 1e2 * excess));
    if (fewer.solid.vertices.size() < vertices)
        cooked.lines.push_back(format(
            "core of %zu of %zu vertices: at most %.3g %% of d_eq inside "
            "the full one, %.3g %% less volume",
            fewer.solid.vertices.size(), vertices, 1e2 * fewer.error_max / d_eq, 1e2 * loss));
    constexpr double noted = 0.02;  // of the volume
    if (request.keeps_volume)
        cooked.lines.push_back(
            format("core scaled by %.5g: the body has the volume of the mesh", scale));
    else if (std::abs(ratio - 1.0) > noted)
        cooked.lines.push_back(format(
            "the body has %.4g %% of the volume of the mesh, to which --keep-volume scales it",
            1e2 * ratio));
    finish(cooked, std::move(solid), path.stem().string(),
           {{"hull_excess", excess},
            {"hull_error_max", fewer.error_max / d_eq},
            {"hull_loss", loss},
            {"core_scale", scale}});
    cooked.shape.input_unit = loaded.unit;
    return cooked;
}

}  // namespace

bool is_convex_file(const std::filesystem::path& path) {
    return path.extension() == ".convex";
}

ParticleTemplate convex_template(ConvexSolid solid, std::string name) {
    ParticleTemplate shape;
    shape.name = std::move(name);
    shape.mass_properties = solid.mass_properties;
    shape.bounding_radius = solid.shape.bounding_radius;
    shape.mean_squared_surface_distance = solid.mean_squared_surface_distance;
    shape.is_convex = true;
    shape.shape = std::move(solid.shape);
    return shape;
}

CookedConvex cook_convex(const std::filesystem::path& path, const ConvexRequest& request,
                         const MeshLoadOptions& mesh) {
    return is_mesh_file(path) ? cook_mesh(path, request, mesh)
                              : cook_file(path, request, mesh.scale);
}

}  // namespace dem::shapegen
