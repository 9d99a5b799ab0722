// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/cook_clump.hpp"

#include "common/error.hpp"
#include "common/format.hpp"
#include "shapegen/certificate/clump_certificate.hpp"
#include "shapegen/clump/mass_balance.hpp"

#include <algorithm>
#include <utility>

namespace dem {

namespace {

BuiltClump build(ClumpMaker& maker, const ClumpGoal& goal) {
    if (goal.rms_deviation > 0.0) return maker.clump_within(goal.rms_deviation);
    CoverGoal cover;
    if (goal.count > 0)
        cover.count = goal.count;
    else
        cover.coverage = goal.coverage;
    return maker.clump(cover);
}

/// What a user might miss in the certificate.
std::vector<std::string> remarks(const ClumpGoal& goal, const BuiltClump& clump,
                                 const MassBalance& masses) {
    std::vector<std::string> lines;
    if (clump.balls.size() < goal.count)
        lines.push_back(
            format("room for %zu of %zu spheres: more voxels (--resolution) or smaller "
                   "spheres (--min-radius) may give more",
                   clump.balls.size(), goal.count));
    constexpr double poor = 0.7;
    if (clump.quality.coverage < poor)
        lines.push_back(
            format("the spheres cover no more than %.3g %% of the body: it takes more of "
                   "them, or more voxels (--resolution)",
                   100.0 * clump.quality.coverage));
    double sum = 0.0;
    for (const double share : masses.shares) sum += share;
    const auto empty = std::count_if(masses.shares.begin(), masses.shares.end(),
                                     [sum](double share) { return share <= 1e-9 * sum; });
    if (empty > 0)
        lines.push_back(
            format("%td of %zu spheres have no mass in exports", empty, masses.shares.size()));
    return lines;
}

double bounding_radius(const Solid& solid, std::span<const Ball> balls) {
    double radius = 0.0;
    for (const Vec3& p : solid.mesh.vertices) radius = std::max(radius, p.norm());
    for (const Ball& ball : balls) radius = std::max(radius, ball.center.norm() + ball.radius);
    return radius;
}

}  // namespace

CookedClump cook_clump(const Solid& solid, const ClumpRequest& request) {
    const double d_eq = equivalent_diameter(solid.mass_properties.volume);
    ClumpOptions options = request.options;
    if (request.min_radius > 0.0) options.min_radius = request.min_radius / d_eq;
    ClumpMaker maker(solid.mesh, solid.mass_properties, options);
    const BuiltClump clump = build(maker, request.goal);
    const MassBalance masses = balance_masses(clump.balls, solid.mass_properties);

    CookedClump result;
    result.lines = remarks(request.goal, clump, masses);
    if (request.wants_convergence) result.convergence = convergence(maker, clump.balls.size());
    ParticleTemplate& shape = result.shape;
    shape.name = solid.name;
    shape.mass_properties = solid.mass_properties;
    shape.mean_squared_surface_distance = solid.mean_squared_surface_distance;
    shape.bounding_radius = bounding_radius(solid, clump.balls);
    shape.is_convex = solid.is_convex;
    if (request.options.progress) request.options.progress(0.95, "surface for pictures");
    shape.display_mesh = solid.display_mesh.get();
    shape.input_unit = solid.unit;
    shape.certificate = clump_certificate(clump, masses, shape.display_mesh.max_deviation / d_eq);
    std::vector<ClumpSphere> spheres;
    for (std::size_t i = 0; i < clump.balls.size(); ++i) {
        const Vec3& c = clump.balls[i].center;
        spheres.push_back({c.x(), c.y(), c.z(), clump.balls[i].radius, masses.shares[i]});
    }
    shape.shape = make_clump(std::move(spheres));
    return result;
}

}  // namespace dem
