// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation: everything that a bit of its future depends on, and what the outputs
// say about the present step. The forces of the step before, the positions of walls and the
// neighbor lists follow from the rest.
#include "runtime/checkpoint/contact_state.hpp"
#include "runtime/simulation.hpp"

namespace dem::runtime {

namespace {

template <class Self, class Visit>
void visit_particles(Self& p, Visit& visit) {
    visit("particles.id", p.id);
    visit("particles.next_id", p.next_id);
    visit("particles.position", p.position);
    visit("particles.orientation", p.orientation);
    visit("particles.velocity", p.velocity);
    visit("particles.angular_momentum", p.angular_momentum);
    visit("particles.angular_velocity", p.angular_velocity);
    visit("particles.force", p.force);
    visit("particles.torque", p.torque);
    visit("particles.kind", p.kind);
    visit("particles.group", p.group);
    visit("particles.travel", p.travel);
}

/// Whether every array has an entry per particle and every index means something.
bool is_consistent(const Particles& p, const EnergyLedger& ledger, const Scene& scene) {
    const std::size_t n = p.size();
    bool fine = true;
    for (const auto* array :
         {&p.velocity, &p.angular_momentum, &p.angular_velocity, &p.force, &p.torque}) {
        fine &= array->size() == n;
    }
    for (const auto* array : {&p.travel, &ledger.dissipated, &ledger.wall_work}) {
        fine &= array->size() == n;
    }
    fine &= p.orientation.size() == n && p.kind.size() == n && p.group.size() == n;
    fine &= p.id.size() == n;
    for (std::size_t i = 0; fine && i < n; ++i)
        fine &= p.id[i] < (i + 1 < n ? p.id[i + 1] : p.next_id);
    for (const std::uint32_t kind : p.kind) fine &= kind < scene.kinds.size();
    for (const std::uint32_t group : p.group) fine &= group < scene.insertions.size();
    return fine;
}

}  // namespace

template <class Self, class Visit>
void Simulation::visit_state(Self& self, Visit& visit) {
    visit("steps", self.steps_);
    visit_particles(self.particles_, visit);
    visit("walls.travel", self.walls_.travel);
    if (self.motions_wait_) {
        visit("walls.settled", self.walls_.settled);
        AtRest::visit_state(self.settling_, visit, "settling");
    }
    visit("ledger.dissipated", self.ledger_.dissipated);
    visit("ledger.wall_work", self.ledger_.wall_work);
    visit("ledger.dissipated_before", self.ledger_.dissipated_before);
    visit("ledger.wall_work_before", self.ledger_.wall_work_before);
    visit("ledger.removed", self.ledger_.removed);
    visit("ledger.inserted", self.inserted_energy_);
    // One by one: bytes between members would be whatever was in memory.
    visit("largest_overlap.relative", self.largest_overlap_.relative);
    visit("largest_overlap.ids", self.largest_overlap_.ids);
    visit("largest_overlap.is_wall", self.largest_overlap_.is_wall);
    visit("core_overlaps", self.core_overlaps_);
    visit("contacts_seen.looks", self.scratch_.looks);
    visit("contacts_seen", self.scratch_.seen);
    Inserter::visit_state(self.inserter_, visit);
    Outlets::visit_state(self.outlets_, visit);
    WallLoads::visit_state(self.wall_loads_, visit);
}

void Simulation::save(StateWriter& writer) const {
    visit_state(*this, writer);
    save_contacts(lists_, writer);
}

void Simulation::load(StateReader& reader) {
    visit_state(*this, reader);
    if (!is_consistent(particles_, ledger_, scene_) ||
        walls_.travel.size() != scene_.walls.size() || !inserter_.fits(scene_) ||
        !outlets_.fits()) {
        reader.fail("holds arrays of other lengths than this case has");
    }
    if (!wall_loads_.fits())
        reader.fail("was made with another setting of wall_contacts, which must stay");
    particles_.old_force.assign(particles_.size(), Vec3::Zero());
    particles_.old_torque.assign(particles_.size(), Vec3::Zero());
    outlets_.settle(scene_, particles_);
    for (std::size_t w = 0; w < scene_.walls.size(); ++w) {
        walls_.state[w] = wall_state(scene_.walls[w], {time(), walls_.settled});
    }
    lists_ = load_contacts(particles_.size(), scene_.walls.size(), reader);
}

}  // namespace dem::runtime
