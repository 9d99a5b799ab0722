// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/cook_clump.hpp"

#include "common/error.hpp"
#include "common/format.hpp"
#include "shapegen/certificate/clump_certificate.hpp"
#include "shapegen/clump/components.hpp"
#include "shapegen/clump/mass_balance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace dem::shapegen {

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

/// A clump with what follows from its balls.
struct MadeClump {
    BuiltClump built;
    MassBalance masses;
    Clump shape;
    std::size_t components;
    bool is_own;  ///< of a body that is a union of balls

    MadeClump(BuiltClump clump, const MassProperties& body, bool is_bodys_own)
        : built(std::move(clump)),
          masses(balance_masses(built.balls, body)),
          shape(shape_of(built.balls, masses.shares)),
          components(component_count(shape)),
          is_own(is_bodys_own) {}

  private:
    static Clump shape_of(const std::vector<Ball>& balls, const std::vector<double>& shares) {
        std::vector<ClumpSphere> spheres;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const Vec3& c = balls[i].center;
            spheres.push_back({c.x(), c.y(), c.z(), balls[i].radius, shares[i]});
        }
        return make_clump(std::move(spheres));
    }
};

/// What a user might not expect of the number of spheres.
std::string count_remark(const ClumpGoal& goal, const MadeClump& made) {
    const std::size_t count = made.built.balls.size();
    if (made.is_own && count == 1)
        return "the body is a sphere, which is its clump: nothing to fit";
    if (made.is_own)
        return format("the body is the union of %zu spheres, which are its clump: nothing to fit",
                      count);
    if (count < goal.count)
        return format(
            "room for %zu of %zu spheres: more voxels (--resolution) or smaller spheres "
            "(--min-radius) may give more",
            count, goal.count);
    return "";
}

/// Where a fit could not give the union the volume of the body.
std::string volume_remark(const BuiltClump& clump, const ClumpOptions& options) {
    constexpr double noted = 0.02;  // of the volume
    const double ratio = clump.quality.volume_ratio;
    if (options.is_inscribed || std::abs(ratio - 1.0) <= noted) return "";
    const std::string found =
        format("the spheres have %.4g %% of the volume of the body: ", 100.0 * ratio);
    if (ratio > 1.0) return found + "more spheres come nearer";
    return found + format(
                       "none may stand out by more than %.3g %% of d_eq (--protrusion); a larger "
                       "one, or more spheres, come nearer",
                       100.0 * options.protrusion);
}

/// What a user might miss in the certificate.
std::vector<std::string> remarks(const ClumpRequest& request, const MadeClump& made) {
    std::vector<std::string> lines{count_remark(request.goal, made),
                                   volume_remark(made.built, request.options)};
    constexpr double poor = 0.7;
    const double coverage = made.built.quality.coverage;
    if (coverage < poor && lines.back().empty())  // which says enough
        lines.push_back(
            format("the spheres cover no more than %.3g %% of the body: it takes more of "
                   "them, or more voxels (--resolution)",
                   100.0 * coverage));
    if (made.components > 1)
        lines.push_back(
            format("the spheres form %zu pieces that do not touch each other, one rigid body all "
                   "the same: more spheres or voxels (--resolution) may join them",
                   made.components));
    const std::vector<double>& shares = made.masses.shares;
    double sum = 0.0;
    for (const double share : shares) sum += share;
    const auto empty = std::count_if(shares.begin(), shares.end(),
                                     [sum](double share) { return share <= 1e-9 * sum; });
    if (empty > 0)
        lines.push_back(format("%td of %zu spheres have no mass in exports", empty, shares.size()));
    std::erase(lines, "");
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
    const MadeClump made(is_own ? own_clump(solid) : build(*maker, request.goal),
                         solid.mass_properties, is_own);

    CookedClump result;
    result.lines = remarks(request, made);
    const std::size_t count = made.built.balls.size();
    if (request.wants_convergence && maker)
        result.convergence = convergence(*maker, is_own ? count - 1 : count);
    if (request.wants_convergence && is_own)
        result.convergence.push_back({count, made.built.quality});
    ParticleTemplate& shape = result.shape;
    shape.name = solid.name;
    shape.mass_properties = solid.mass_properties;
    shape.mean_squared_surface_distance = solid.mean_squared_surface_distance;
    shape.bounding_radius = bounding_radius(solid, made.built.balls);
    shape.is_convex = solid.is_convex;
    if (request.options.progress) request.options.progress(0.95, "surface for pictures");
    shape.display_mesh = solid.display_mesh.get();
    shape.input_unit = solid.unit;
    shape.certificate = clump_certificate(made.built, made.masses, made.components,
                                          shape.display_mesh.max_deviation / d_eq);
    shape.shape = made.shape;
    return result;
}

}  // namespace dem::shapegen
