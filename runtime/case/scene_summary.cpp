// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/scene_summary.hpp"

#include "common/progress.hpp"
#include "common/threads/available_cores.hpp"
#include "runtime/case/law_text.hpp"
#include "runtime/case/motion_text.hpp"
#include "runtime/case/run_cost.hpp"
#include "runtime/insertion/inserter.hpp"
#include "runtime/overlap.hpp"
#include "runtime/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace dem::runtime {

namespace {

/// How much faster threads make a run, from two threads on two cores.
double speed_up(int threads) {
    return 1.0 + 0.7 * (threads - 1);
}

/// Inserts what is due at the start into an empty world, and every later group alone, which finds
/// regions that can never hold what they should.
void try_insertion(const Scene& scene) {
    Particles particles;
    Inserter(scene).insert_due(scene, particles, 0.0);
    for (const InsertionGroup& group : scene.insertions) {
        if (group.start <= 0.0) continue;
        Scene alone = scene;
        alone.insertions = {group};
        Particles empty;
        Inserter(alone).insert_due(alone, empty, group.start);
    }
}

/// Mass of the first `count` bodies of a group [kg].
double mass(const Scene& scene, const InsertionGroup& group, std::uint64_t count) {
    double total = 0.0;
    if (group.mode == InsertionGroup::Mode::file) {
        for (std::uint64_t k = 0; k < count; ++k)
            total += scene.kinds[group.placements[k].kind].mass;
        return total;
    }
    const std::uint64_t cycle = group.kinds.size();
    for (std::uint64_t k = 0; k < cycle; ++k) {
        const std::uint64_t times = count / cycle + (k < count % cycle ? 1 : 0);
        total += static_cast<double>(times) * scene.kinds[group.kinds[k]].mass;
    }
    return total;
}

void describe(const Scene& scene, const InsertionGroup& group, std::ostringstream& out) {
    out << "  " << group.name << ": " << group.count << " x ";
    const std::size_t kinds = group.kinds.size();
    const ParticleTemplate& first = scene.shapes[scene.kinds[group.kinds.front()].shape];
    if (kinds == 1) {
        out << first.name << " (" << kind_name(first) << ")";
    } else {
        out << kinds << (group.mode == InsertionGroup::Mode::file ? " shapes" : " shapes in turn");
    }
    out << ", " << mass(scene, group, group.count) << " kg, ";
    switch (group.mode) {
        case InsertionGroup::Mode::at_once:
            out << "at random places";
            break;
        case InsertionGroup::Mode::lattice:
            out << "on a lattice";
            break;
        case InsertionGroup::Mode::fill:
            out << "packed from the bottom";
            break;
        case InsertionGroup::Mode::file:
            out << "from " << group.file;
            if (group.allow_overlaps)
                out << " (contacts begin anew: without their friction springs)";
            break;
        case InsertionGroup::Mode::batches:
            out << group.batch << " every " << group.every << " s";
            break;
    }
    out << ", " << (group.mode == InsertionGroup::Mode::batches ? "from " : "at ") << group.start
        << " s";
    const double last = last_insertion(group);
    if (last > group.start) out << ", the last at " << last << " s or later";
    if (last > scene.run.end_time) out << " (AFTER end_time: not all will come in)";
    out << "\n";
}

/// "outlets: gate (counts), drain (takes out)"; nothing without any.
std::string outlet_text(const Scene& scene) {
    std::string text;
    const auto add = [&](const std::string& name, const char* does) {
        text += (text.empty() ? "outlets: " : ", ") + name + does;
    };
    for (const Outlet& outlet : scene.outlets)
        add(outlet.name, outlet.kind == Outlet::Kind::flow ? " (counts)" : " (takes out)");
    if (scene.run.domain_exit == DomainExit::remove) add("domain", " (takes out who leaves it)");
    return text.empty() ? text : text + "\n";
}

std::string origin(const TimeStep& step, const std::vector<Wall>& walls) {
    std::ostringstream speed;
    speed << step.largest_speed << " m/s";
    if (step.critical == step.linear) return "the limit of the linear law";
    if (step.critical == step.rayleigh) return "Rayleigh's";
    if (step.critical == step.hertz) return "Hertz's at " + speed.str();
    const bool has_oscillation = std::any_of(walls.begin(), walls.end(), [](const Wall& wall) {
        return !std::isinf(half_period(wall.motion));
    });
    return "of the motion: one radius at " + speed.str() +
           (has_oscillation ? ", half a period of a wall" : "");
}

void describe(const TimeStep& step, const Scene& scene, std::ostringstream& out) {
    out << "time step: " << step.value << " s, ";
    if (scene.run.time_step) {
        out << "given; ";
    } else {
        out << "1/" << scene.run.time_step_divisor << " of ";
    }
    if (std::isinf(step.critical)) {
        out << "no body can move, and none is too long\n";
        return;
    }
    out << "the critical time " << step.critical << " s (" << origin(step, scene.walls) << ")\n";
    if (step.value > 0.1 * step.critical) {
        out << "warning: the time step is " << step.value / step.critical
            << " of the critical time, expected a tenth of it at most: energies are off by "
               "percents\n";
    }
}

void describe(const RunCost& cost, int threads, std::ostringstream& out) {
    const int cores = available_cores();
    const int used = threads > 0 ? std::min(threads, cores) : cores;
    out << "estimate: about " << format_duration(cost.steps / speed_up(used) + cost.measures)
        << " on " << used << (used == 1 ? " core" : " cores");
    if (cost.measures > 0.1 * cost.steps) {
        out << ", " << format_duration(cost.measures) << " of it for measures";
    }
    out << "\n";
}

}  // namespace

std::string check_scene(const Scene& scene, std::optional<double> resumed_at) {
    const TimeStep step = time_step(scene);
    try_insertion(scene);
    std::ostringstream out;
    out << std::setprecision(4) << scene.case_path << "\n";
    std::uint64_t bodies = 0;
    double total_mass = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        bodies += group.count;
        total_mass += mass(scene, group, group.count);
    }
    out << "particles: " << bodies << ", " << total_mass << " kg\n";
    for (const InsertionGroup& group : scene.insertions) describe(scene, group, out);
    out << "walls: " << scene.walls.size();
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        out << (w == 0 ? " (" : ", ") << scene.walls[w].name;
    }
    out << (scene.walls.empty() ? "\n" : ")\n") << motion_text(scene) << outlet_text(scene)
        << law_text(scene);
    describe(step, scene, out);
    out << foreseen_overlap(scene) << "steps: ";
    const std::uint64_t steps = step_count(scene.run, step.value, scene.case_path);
    if (resumed_at) {
        const auto done = static_cast<std::uint64_t>(std::llround(*resumed_at / step.value));
        out << steps - std::min(steps, done) << " more of " << steps << ", from " << *resumed_at
            << " s";
    } else {
        out << steps;
    }
    out << " to " << scene.run.end_time << " s\n";
    describe(run_cost(scene, resumed_at.value_or(0.0), step.value), scene.run.threads, out);
    return out.str();
}

}  // namespace dem::runtime
