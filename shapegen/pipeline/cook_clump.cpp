// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/cook_clump.hpp"

#include "common/error.hpp"
#include "common/format.hpp"
#include "shapegen/certificate/clump_certificate.hpp"
#include "shapegen/clump/mass_balance.hpp"

#include <algorithm>
#include <optional>
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

/// True when the body is a union of balls and these balls do what was asked.
bool is_its_own_clump(const Solid& solid, const ClumpGoal& goal, double min_radius) {
    const std::size_t count = solid.balls.size();
    if (count == 0 || count > Clump::most_spheres) return false;
    if (goal.count > 0 && goal.count < count) return false;
    return std::all_of(solid.balls.begin(), solid.balls.end(),
                       [&](const Ball& ball) { return ball.radius >= min_radius; });
}

/// The balls that the body is the union of. Nothing is left to measure but how far its surface is
/// from theirs.
BuiltClump own_clump(const Solid& solid) {
    const double deviation =
        solid.balls_deviation / equivalent_diameter(solid.mass_properties.volume);
    BuiltClump clump{solid.balls, {}, 1.0};
    clump.quality.coverage = 1.0;
    clump.quality.volume_ratio = 1.0;
    clump.quality.rms_deviation = deviation;
    clump.quality.max_deviation_in = deviation;
    clump.quality.max_deviation_out = deviation;
    return clump;
}

/// What a user might miss in the certificate.
std::vector<std::string> remarks(const ClumpGoal& goal, const BuiltClump& clump,
                                 const MassBalance& masses, bool is_own) {
    std::vector<std::string> lines;
    if (is_own)
        lines.push_back(clump.balls.size() == 1
                            ? "the body is a sphere, which is its clump: nothing to fit"
                            : format("the body is the union of %zu spheres, which are its clump: "
                                     "nothing to fit",
                                     clump.balls.size()));
    else if (clump.balls.size() < goal.count)
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
    const bool is_own = is_its_own_clump(solid, request.goal, d_eq * options.min_radius);
    const bool wants_fewer = request.wants_convergence && solid.balls.size() > 1;
    std::optional<ClumpMaker> maker;
    if (!is_own || wants_fewer) maker.emplace(solid.mesh, solid.mass_properties, options);
    const BuiltClump clump = is_own ? own_clump(solid) : build(*maker, request.goal);
    const MassBalance masses = balance_masses(clump.balls, solid.mass_properties);

    CookedClump result;
    result.lines = remarks(request.goal, clump, masses, is_own);
    const std::size_t count = clump.balls.size();
    if (request.wants_convergence && maker)
        result.convergence = convergence(*maker, is_own ? count - 1 : count);
    if (request.wants_convergence && is_own) result.convergence.push_back({count, clump.quality});
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
