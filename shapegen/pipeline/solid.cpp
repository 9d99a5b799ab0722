// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/solid.hpp"

#include "common/file_hash.hpp"
#include "formats/memory_map.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/profile/profile_file.hpp"
#include "shapegen/revolution/ball_chain.hpp"
#include "shapegen/revolution/convexity.hpp"
#include "shapegen/revolution/display_mesh.hpp"
#include "shapegen/revolution/mass_properties.hpp"
#include "shapegen/surface/decimate.hpp"
#include "shapegen/surface/mesh_convexity.hpp"

#include <future>
#include <utility>

namespace dem::shapegen {
namespace {

constexpr double revolved_tolerance = 2e-5;  // of the length of the major axis
constexpr double picture_tolerance = 1e-3;   // the same
constexpr std::size_t picture_triangles = 2000;

Solid from_profile(const std::filesystem::path& path, double scale) {
    const ProfileFile file = read_profile(path.string(), scale);
    const RevolutionMass mass = revolution_mass(file.profile);
    const Profile profile = file.profile.translated(-mass.mass_properties.center_of_mass.z());
    const double length = profile.major_axis_length();
    const DisplayMesh fine = display_mesh(profile, revolved_tolerance * length);
    Solid solid;
    solid.name = file.name;
    solid.hash = file.hash;
    solid.unit = file.unit;
    solid.mesh = {{fine.vertices.begin(), fine.vertices.end()},
                  {fine.triangles.begin(), fine.triangles.end()}};
    solid.mass_properties = mass.mass_properties;
    solid.mean_squared_surface_distance = mass.mean_squared_surface_distance;
    solid.is_convex = convexity(profile).is_convex;
    const BallChain chain = ball_chain(profile);
    for (const AxialBall& ball : chain.balls)
        solid.balls.push_back({{0.0, 0.0, ball.z}, ball.radius});
    // The center of mass, whatever rounding the integrals leave.
    if (solid.balls.size() == 1) solid.balls.front().center.setZero();
    solid.balls_deviation = chain.max_deviation;
    solid.display_mesh = std::async(std::launch::deferred, [profile, length] {
        return display_mesh(profile, picture_tolerance * length);
    });
    return solid;
}

Solid from_mesh(const std::filesystem::path& path, const MeshLoadOptions& options) {
    LoadedMesh loaded = load_mesh(path, options);
    Solid solid;
    solid.name = path.stem().string();
    solid.hash = file_hash(MemoryMap(path, "mesh").bytes());
    solid.unit = loaded.unit;
    solid.lines = std::move(loaded.lines);
    solid.mass_properties = mass_properties(loaded.mesh);
    const MassProperties& mass = solid.mass_properties;
    solid.mean_squared_surface_distance =
        mean_squared_surface_distance(loaded.mesh, mass.center_of_mass);
    solid.is_convex = is_convex(loaded.mesh);
    const Mat3 to_body = mass.principal_axes.toRotationMatrix().transpose();
    for (Vec3& p : loaded.mesh.vertices) p = to_body * (p - mass.center_of_mass);
    solid.mesh = std::move(loaded.mesh);
    // Takes a second for a large mesh, and nobody needs it before the end.
    solid.display_mesh = std::async(std::launch::async, [mesh = solid.mesh] {
        return decimated(SurfaceQuery(mesh), picture_triangles);
    });
    return solid;
}

}  // namespace

Solid load_solid(const std::filesystem::path& path, const MeshLoadOptions& options) {
    return is_mesh_file(path) ? from_mesh(path, options) : from_profile(path, options.scale);
}

}  // namespace dem::shapegen
