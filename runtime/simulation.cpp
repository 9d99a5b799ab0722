// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/simulation.hpp"

#include "common/error.hpp"
#include "common/format.hpp"
#include "common/state_hash.hpp"
#include "common/text.hpp"
#include "runtime/broad_phase/margins.hpp"
#include "runtime/domain.hpp"
#include "runtime/integrator/integrator.hpp"
#include "runtime/loop_grain.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/overlap.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace dem::runtime {

namespace {

std::vector<double> surface_reach(const Scene& scene) {
    std::vector<double> reach;
    for (const BodyKind& kind : scene.kinds) {
        const ParticleTemplate& shape = scene.shapes[kind.shape];
        const bool is_sphere = std::holds_alternative<Sphere>(shape.shape);
        reach.push_back(is_sphere ? 0.0 : shape.bounding_radius);
    }
    return reach;
}

/// Whether the motion of a wall begins only when the bodies have settled.
bool waits(const Wall& wall) {
    const Motion* motion = &wall.motion;
    while (motion != nullptr && !motion->from_settled) motion = motion->within.get();
    return motion != nullptr;
}

/// Of the wall where a point is [m/s].
Vec3 velocity_at(const WallState& wall, const Vec3& x) {
    return wall.body.velocity + wall.body.angular_velocity.cross(x - wall.position);
}

}  // namespace

Simulation::Simulation(Scene scene, double dt)
    : scene_(std::move(scene)),
      team_(scene_.run.threads, scene_.run.forced_threads),
      dt_(dt),
      domain_(domain(scene_)),
      aabbs_(scene_.shapes),
      surface_reach_(surface_reach(scene_)),
      integrator_(make_integrator(scene_, surface_reach_)),
      wall_margins_(wall_margins(scene_)),
      motions_wait_(std::ranges::any_of(scene_.walls, waits)),
      settling_(scene_, true),
      tunnels_(scene_),
      wall_loads_(scene_),
      inserter_(scene_),
      outlets_(scene_, domain_),
      walls_(place_walls(scene_.walls)),
      scratch_(make_scratch(scene_, static_cast<std::size_t>(team_.most()))) {
    const StepTeam::Step together(team_);
    insert_due();
    check_bodies();
    // Bodies from the end of another run may touch from the start.
    rebuild_lists();
    scratch_.looks = scene_.output.contacts ? Looks::at_all : Looks::at_none;
    largest_overlap_ = compute_contacts(lists_, bodies(), 0.0, scratch_);
    sum_forces(particles_, lists_, scene_, ledger_);
}

// Algorithm 1 of docs/time-loop.md.
void Simulation::step(bool looks) {
    scratch_.looks = wall_loads_.is_empty() ? Looks::at_none : Looks::at_walls;
    if (looks && scene_.output.contacts) scratch_.looks = Looks::at_all;
    const StepTeam::Step together(team_);                 // threads: docs/threads.md
    advance(particles_, scene_.kinds, integrator_, dt_);  // 1-3 x(t + dt), a guess of v(t + dt)
    ++steps_;
    move_walls(walls_, scene_.walls, domain_, time());  // 4
    check_bodies();                                     // 5
    check_tunnels();                                    // 5
    if (is_stale(lists_, bodies())) rebuild_lists();    // 6  broad phase
    largest_overlap_ = compute_contacts(                // 7  narrow phase, contact laws
        lists_, bodies(), dt_, scratch_);
    core_overlaps_ += scratch_.cores_met;
    if (!wall_loads_.is_empty()) wall_loads_.add(scratch_.seen, bodies(), dt_);
    check_overlap();                                  // 8
    sum_forces(particles_, lists_, scene_, ledger_);  // 9
    book(scratch_.partings, ledger_);
    correct(particles_, scene_.kinds, integrator_, dt_);  // 10 v(t + dt)
    let_out();                                            // 11
    insert_due();                                         // 12
    begin_motions();                                      // 13
}

void Simulation::let_out() {
    if (outlets_.is_empty() || !outlets_.look(scene_, particles_)) return;
    const StepTeam::RarePart rare(team_);
    const std::span<const std::uint8_t> leaving = outlets_.leaving();
    for (std::uint32_t i = 0; i < particles_.size(); ++i) {
        if (leaving[i] != 0) ledger_.removed += mechanical_energy(particles_, scene_, i);
    }
    ledger_.removed += remove_bodies(lists_, leaving);
    particles_.remove(leaving);
    ledger_.remove(leaving);
    forget_missing(particles_.id, scratch_.seen);
    sum_remaining_forces(particles_, lists_, scene_);
    outlets_.settle(scene_, particles_);
}

void Simulation::insert_due() {
    if (inserter_.next_time() > time()) return;
    const StepTeam::RarePart rare(team_);
    const std::uint32_t before = particles_.size();
    inserter_.insert_due(scene_, particles_, time());
    ledger_.resize(particles_.size());
    for (std::uint32_t i = before; i < particles_.size(); ++i) {
        // Nothing touches a new body, so its weight is its force.
        particles_.force[i] = scene_.kinds[particles_.kind[i]].mass * scene_.run.gravity;
        inserted_energy_ += mechanical_energy(particles_, scene_, i);
    }
    outlets_.settle(scene_, particles_);
}

void Simulation::begin_motions() {
    if (!has_waiting_motion()) return;
    settling_.look(bodies(), time(), is_inserted());
    if (!settling_.was_reached()) return;
    walls_.settled = time();
    for (std::size_t w = 0; w < scene_.walls.size(); ++w)
        walls_.state[w] = wall_state(scene_.walls[w], {time(), walls_.settled});
}

void Simulation::rebuild_lists() {
    const StepTeam::RarePart rare(team_);
    rebuild(lists_, bodies(), aabbs_, margins(particles_, scene_, surface_reach_, dt_),
            wall_margins_);
}

void Simulation::check_bodies() const {
    // Who leaves the domain may be let out at the end of the step.
    const Vec3 farthest = Vec3::Constant(farthest_coordinate);
    const Aabb room =
        scene_.run.domain_exit == DomainExit::remove ? Aabb{-farthest, farthest} : domain_;
    const std::uint32_t count = particles_.size();
    std::atomic<bool> all_inside = true;
    share_loop(count, bodies_at_a_time, [&](const LoopPart& part) {
        bool is_inside = true;
        for (std::size_t i = part.begin; i < part.end; ++i) {
            // Both false for NaN, too.
            is_inside = is_inside && room.contains(particles_.position[i]) &&
                        particles_.orientation[i].squaredNorm() < 2.0;
        }
        if (!is_inside) all_inside = false;
    });
    for (std::uint32_t i = 0; i < count && !all_inside; ++i) {
        const Vec3& x = particles_.position[i];
        if (!(particles_.orientation[i].squaredNorm() < 2.0)) {
            throw Error(here(), "the orientation of particle " + std::to_string(particles_.id[i]) +
                                    " is not a number; its spin may be too large");
        }
        if (room.contains(x)) continue;
        const std::string at = format("(%.4g %.4g %.4g) m", x.x(), x.y(), x.z());
        if (!x.allFinite()) {
            throw Error(here(), "particle " + std::to_string(particles_.id[i]) + " is at " + at +
                                    ": not a number; the time step may be too large");
        }
        throw Error(here(), "particle " + std::to_string(particles_.id[i]) +
                                " has left the domain at " + at +
                                ", expected walls that hold it or a larger domain");
    }
}

void Simulation::check_tunnels() const {
    const auto tunnel = tunnels_.find(bodies(), time(), dt_);
    if (!tunnel) return;
    const auto [i, w] = *tunnel;
    const Vec3 across =
        particles_.velocity[i] - velocity_at(walls_.state[w], particles_.position[i]);
    throw Error(here(), "particle " + std::to_string(particles_.id[i]) + " has gone through wall " +
                            in_quotes(scene_.walls[w].name) +
                            format(" in one step, at %.3g m/s, expected a shorter time step or "
                                   "slower bodies and walls",
                                   across.norm()));
}

void Simulation::check_overlap() const {
    const double relative = largest_overlap_.relative;
    if (relative <= scene_.run.overlap_limit) return;
    const auto [i, j] = largest_overlap_.ids;
    const bool is_wall = largest_overlap_.is_wall;
    if (std::isinf(relative)) {
        throw Error(here(), "a small sphere of particle " + std::to_string(particles_.id[i]) +
                                " has gone through wall " + in_quotes(scene_.walls[j].name) +
                                ", expected stiffer materials, slower bodies or larger spheres");
    }
    const std::string partner = is_wall ? "wall " + in_quotes(scene_.walls[j].name)
                                        : "particle " + std::to_string(particles_.id[j]);
    const auto is_new = [&](std::uint32_t body) {
        const InsertionGroup& group = scene_.insertions[particles_.group[body]];
        return group.allow_overlaps && time() - group.start < 1.5 * dt_;
    };
    std::string cause = "they do from the start";
    if (!is_new(i) && (is_wall || !is_new(j))) {
        const Vec3 other =
            is_wall ? velocity_at(walls_.state[j], particles_.position[i]) : particles_.velocity[j];
        const std::uint32_t kind = particles_.kind[i];
        cause = overlap_cause(scene_,
                              is_wall ? encounter_with_wall(scene_, kind, scene_.walls[j].material)
                                      : encounter(scene_, kind, particles_.kind[j]),
                              (particles_.velocity[i] - other).norm(), relative, dt_);
    }
    throw Error(here(), "particle " + std::to_string(particles_.id[i]) + " and " + partner +
                            format(" overlap by %.1f %% of the smaller radius, at most %.3g %% "
                                   "expected; ",
                                   100.0 * relative, 100.0 * scene_.run.overlap_limit) +
                            cause);
}

std::string Simulation::here() const {
    return scene_.case_path +
           format(": step %llu, time %.9g s", static_cast<unsigned long long>(steps_), time());
}

std::uint64_t Simulation::state_hash() const {
    StateHash hash;
    for (std::uint32_t i = 0; i < particles_.size(); ++i) {
        hash.add(std::span<const double>(particles_.position[i].data(), 3));
        hash.add(std::span<const double>(particles_.orientation[i].coeffs().data(), 4));
        hash.add(std::span<const double>(particles_.velocity[i].data(), 3));
        hash.add(std::span<const double>(particles_.angular_momentum[i].data(), 3));
    }
    return hash.value();
}

}  // namespace dem::runtime
