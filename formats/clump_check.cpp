// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_check.hpp"
#include "formats/value_check.hpp"

#include <cmath>

namespace dem {

namespace {

/// What rounding may add to a distance.
constexpr double rounding = 1.0 + 1e-9;

bool holds(const Clump::Ball& ball, const ClumpSphere& s) {
    return (s.center() - ball.center()).norm() + s.radius <= ball.radius * rounding;
}

void check_balls(const Clump& clump, const ValueCheck& check) {
    const ClumpLevels levels(clump.spheres.size(), clump.balls.span());
    check.require(levels.ball_count() == clump.balls.size(),
                  "the bounding balls do not match the spheres of the clump in number");
    const auto count = static_cast<std::uint32_t>(clump.spheres.size());
    for (std::uint32_t level = 1; level <= levels.top(); ++level) {
        for (std::uint32_t k = 0; k < count; ++k) {
            check.require(holds(levels.ball(level, k), clump.spheres[k]),
                          "a sphere of the clump lies outside its bounding ball");
        }
    }
}

}  // namespace

void check_clump(const Clump& clump, double bounding_radius, double volume,
                 const std::string& where) {
    const ValueCheck check{where};
    check.require(!clump.spheres.empty(), "a clump has no spheres");
    check.require(clump.spheres.size() <= Clump::most_spheres,
                  "a clump has more than 65535 spheres");
    double shares = 0.0;
    for (const ClumpSphere& s : clump.spheres) {
        check.positive(s.radius, "radius of a sphere");
        check.not_negative(s.volume_share, "volume share of a sphere");
        // Contacts are sought no farther out than this.
        check.require(s.center().norm() + s.radius <= bounding_radius * rounding,
                      "a sphere of the clump lies outside the bounding radius");
        shares += s.volume_share;
    }
    check.require(std::abs(shares - volume) <= 0.01 * volume,
                  "the volume shares of the spheres do not add up to the volume");
    check_balls(clump, check);
}

}  // namespace dem
