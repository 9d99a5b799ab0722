// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/scene_summary.hpp"

#include "common/progress.hpp"
#include "common/threads/available_cores.hpp"
#include "runtime/insertion/inserter.hpp"
#include "runtime/time_step.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace dem {

namespace {

/// What a settled particle costs on one core of 2.6 to 3 GHz (docs/benchmarks.md) [s]; good enough
/// to tell minutes from days.
double seconds_per_step(const ParticleTemplate& shape) {
    if (std::holds_alternative<Sphere>(shape.shape)) return 0.5e-6;
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) return sr->is_convex ? 1.4e-6 : 3e-6;
    return 2e-6;
}

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

/// Time of the last batch if none finds its region occupied [s]; the start for other groups.
double last_insertion(const InsertionGroup& group) {
    if (group.mode != InsertionGroup::Mode::batches) return group.start;
    const std::uint64_t batches = (group.count + group.batch - 1) / group.batch;
    return group.start + static_cast<double>(batches - 1) * group.every;
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

std::string origin(const TimeStep& step) {
    std::ostringstream speed;
    speed << step.largest_speed << " m/s";
    if (step.critical == step.linear) return "the limit of the linear law";
    if (step.critical == step.rayleigh) return "Rayleigh's";
    if (step.critical == step.hertz) return "Hertz's at " + speed.str();
    return "of the motion: one radius at " + speed.str() + ", half a period of a wall";
}

void describe(const TimeStep& step, const RunSettings& run, std::ostringstream& out) {
    out << "time step: " << step.value << " s, ";
    if (run.time_step) {
        out << "given; ";
    } else {
        out << "1/" << run.time_step_fraction << " of ";
    }
    out << "the critical time " << step.critical << " s (" << origin(step) << ")\n";
}

}  // namespace

std::string check_scene(const Scene& scene) {
    const TimeStep step = time_step(scene);
    try_insertion(scene);
    std::ostringstream out;
    out << std::setprecision(4) << scene.case_path << "\n";
    std::uint64_t bodies = 0;
    double work = 0.0;  // of all bodies for as long as each is there, on one core [s]
    double total_mass = 0.0;
    for (const InsertionGroup& group : scene.insertions) {
        bodies += group.count;
        total_mass += mass(scene, group, group.count);
        const double average_start = 0.5 * (group.start + last_insertion(group));
        const double steps = std::max(0.0, scene.run.end_time - average_start) / step.value;
        const ParticleTemplate& shape = scene.shapes[scene.kinds[group.kinds.front()].shape];
        work += static_cast<double>(group.count) * steps * seconds_per_step(shape);
    }
    out << "particles: " << bodies << ", " << total_mass << " kg\n";
    for (const InsertionGroup& group : scene.insertions) describe(scene, group, out);
    out << "walls: " << scene.walls.size();
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        out << (w == 0 ? " (" : ", ") << scene.walls[w].name;
    }
    out << (scene.walls.empty() ? "\n" : ")\n");
    describe(step, scene.run, out);
    const int cores = available_cores();
    const int used = scene.run.threads > 0 ? std::min(scene.run.threads, cores) : cores;
    out << "steps: " << step_count(scene.run, step.value, scene.case_path) << " to "
        << scene.run.end_time << " s\n"
        << "estimate: about " << format_duration(work / speed_up(used)) << " on " << used
        << (used == 1 ? " core\n" : " cores\n");
    return out.str();
}

}  // namespace dem
