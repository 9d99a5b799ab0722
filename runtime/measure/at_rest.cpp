// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {

namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();
/// Kinetic energy of a resting body, in m g d.
constexpr double resting_energy = 1e-6;
/// Looks within the time that a body must stay slow.
constexpr double looks = 50.0;
}  // namespace

AtRest::AtRest(const Scene& scene) : gravity_(scene.run.gravity.norm()), slow_since_(infinite) {
    for (const BodyKind& kind : scene.kinds) {
        const double volume = scene.shapes[kind.shape].mass_properties.volume;
        largest_diameter_ = std::max(largest_diameter_, equivalent_diameter(volume));
    }
}

bool AtRest::is_slow(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    const Scene& scene = simulation.scene();
    // Twice the kinetic energy per mass, in units of g d.
    std::vector<double> speed2(p.size());
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        const double mass = scene.kinds[p.kind[i]].mass;
        if (scene.kinds[p.kind[i]].inverse_inertia.mass == 0.0) continue;
        speed2[i] =
            p.velocity[i].squaredNorm() + p.angular_momentum[i].dot(p.angular_velocity[i]) / mass;
        largest_speed2_ = std::max(largest_speed2_, speed2[i]);
    }
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        const double volume = scene.shapes[scene.kinds[p.kind[i]].shape].mass_properties.volume;
        const double scale =
            gravity_ > 0.0 ? gravity_ * equivalent_diameter(volume) : largest_speed2_;
        if (speed2[i] > 2.0 * resting_energy * scale) return false;
    }
    return true;
}

void AtRest::look(const Simulation& simulation) {
    if (simulation.time() < next_look_) return;
    const double hold = gravity_ > 0.0          ? std::sqrt(largest_diameter_ / gravity_)
                        : largest_speed2_ > 0.0 ? largest_diameter_ / std::sqrt(largest_speed2_)
                                                : 0.0;
    next_look_ = simulation.time() + hold / looks;
    const bool is_complete = std::isinf(simulation.inserter().next_time());
    if (!is_complete || !is_slow(simulation)) {
        slow_since_ = infinite;
        return;
    }
    slow_since_ = std::min(slow_since_, simulation.time());
    was_reached_ = simulation.time() >= slow_since_ + hold;
}

}  // namespace dem
