// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {
/// Kinetic energy of a resting body, in m g d.
constexpr double resting_energy = 1e-6;
/// Largest energy of a body that rocks in place, in m g d, the way that its center may go, in d,
/// and for how long it does, in sqrt(d/g).
constexpr double rocking_energy = 0.1;
constexpr double rocking_distance = 0.5;
constexpr double rocking_time = 100.0;
/// Looks within the time that a body must stay slow.
constexpr double looks = 50.0;

double diameter(const Scene& scene, std::uint32_t kind) {
    return equivalent_diameter(scene.shapes[scene.kinds[kind].shape].mass_properties.volume);
}

}  // namespace

AtRest::AtRest(const Scene& scene, bool of_settling)
    : gravity_(scene.run.gravity.norm()), slow_since_(infinite), in_place_since_(infinite) {
    for (std::uint32_t k = 0; k < scene.kinds.size(); ++k) {
        largest_diameter_ = std::max(largest_diameter_, diameter(scene, k));
    }
    for (const Wall& wall : scene.walls) {
        const Motion* motion = wall.motion.moves() ? &wall.motion : nullptr;
        for (; motion != nullptr; motion = motion->within.get()) {
            const double begin = time_to_begin(*motion);
            if (!motion->from_settled) {
                motions_begin_ = std::max(motions_begin_, motion->start + begin);
            } else if (!of_settling) {
                begin_settled_ = std::max(begin_settled_.value_or(0.0), begin);
            }
        }
    }
}

void AtRest::look_at_energies(const Bodies& bodies) {
    const Particles& p = bodies.particles;
    const Scene& scene = bodies.scene;
    speed2_.assign(p.size(), 0.0);
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        const double mass = scene.kinds[p.kind[i]].mass;
        if (scene.kinds[p.kind[i]].inverse_inertia.mass == 0.0) continue;
        speed2_[i] =
            p.velocity[i].squaredNorm() + p.angular_momentum[i].dot(p.angular_velocity[i]) / mass;
        largest_speed2_ = std::max(largest_speed2_, speed2_[i]);
    }
}

bool AtRest::are_below(double energy, const Bodies& bodies) const {
    const Particles& p = bodies.particles;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        const double scale =
            gravity_ > 0.0 ? gravity_ * diameter(bodies.scene, p.kind[i]) : largest_speed2_;
        if (speed2_[i] > 2.0 * energy * scale) return false;
    }
    return true;
}

bool AtRest::are_in_place(const Bodies& bodies) const {
    const Particles& p = bodies.particles;
    if (places_.size() != p.size() || !are_below(rocking_energy, bodies)) return false;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        const double way = (p.position[i] - places_[i]).norm();
        if (way > rocking_distance * diameter(bodies.scene, p.kind[i])) return false;
    }
    return true;
}

void AtRest::look(const Bodies& bodies, double time, bool is_inserted) {
    if (time < next_look_) return;
    const double hold = gravity_ > 0.0          ? std::sqrt(largest_diameter_ / gravity_)
                        : largest_speed2_ > 0.0 ? largest_diameter_ / std::sqrt(largest_speed2_)
                                                : 0.0;
    next_look_ = time + hold / looks;
    look_at_energies(bodies);
    const double waiting = begin_settled_ ? bodies.walls.settled + *begin_settled_ : 0.0;
    const bool is_complete = is_inserted && time >= std::max(motions_begin_, waiting);
    const bool is_slow = is_complete && are_below(resting_energy, bodies);
    slow_since_ = is_slow ? std::min(slow_since_, time) : infinite;
    if (!is_complete || gravity_ == 0.0) {
        in_place_since_ = infinite;
    } else if (std::isinf(in_place_since_) || !are_in_place(bodies)) {
        places_ = bodies.particles.position;
        in_place_since_ = time;
    }
    has_rocking_ = time < slow_since_ + hold;
    was_reached_ = !has_rocking_ || time >= in_place_since_ + rocking_time * hold;
}

}  // namespace dem::runtime
