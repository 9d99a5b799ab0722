// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/outputs.hpp"

#include "common/atomic_file.hpp"
#include "common/attempts.hpp"
#include "common/error.hpp"
#include "common/stopwatch.hpp"
#include "runtime/files/body_table.hpp"
#include "runtime/files/run_summary.hpp"
#include "runtime/measure/contact_count.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/measure/measures.hpp"
#include "runtime/measure/wall_forces.hpp"
#include "runtime/output/picture.hpp"

#include <algorithm>
#include <cerrno>
#include <numeric>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace dem::runtime {

namespace {

/// What an earlier run ended with would be taken for the end of this one.
void remove_end(const std::filesystem::path& directory) {
    for (const char* name : {"final.csv", "final.png", "summary.json"}) {
        std::error_code ignored;  // what cannot be removed cannot be replaced either, which fails
        std::filesystem::remove(directory / name, ignored);
    }
}

FrameContext frame_context(const Scene& scene, const WallTriangles& walls) {
    FrameContext context{scene.case_path, {}, scene.output.surfaces, scene.output.contacts};
    context.walls = walls.names;
    if (scene.output.wall_contacts) context.wall_contacts = &walls;
    for (const InsertionGroup& group : scene.insertions) context.groups.push_back(group.name);
    return context;
}

std::vector<std::string> history_columns(const Scene& scene) {
    std::vector<std::string> columns = {"time",
                                        "step",
                                        "particles",
                                        "kinetic_translational",
                                        "kinetic_rotational",
                                        "elastic",
                                        "potential",
                                        "dissipated",
                                        "wall_work",
                                        "inserted",
                                        "contacts",
                                        "coordination",
                                        "largest_relative_overlap"};
    const auto outlets = outlet_columns(scene);
    columns.insert(columns.end(), outlets.begin(), outlets.end());
    const auto walls = wall_force_columns(scene);
    columns.insert(columns.end(), walls.begin(), walls.end());
    const auto measures = measure_columns(scene);
    columns.insert(columns.end(), measures.begin(), measures.end());
    return columns;
}

std::vector<BodyRow> body_rows(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    const Scene& scene = simulation.scene();
    std::vector<BodyRow> rows(p.size());
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        rows[i] = {.id = p.id[i],
                   .template_name = scene.shapes[scene.kinds[p.kind[i]].shape].name,
                   .group = scene.insertions[p.group[i]].name,
                   .position = p.position[i],
                   .orientation = p.orientation[i],
                   .velocity = p.velocity[i],
                   .angular_velocity = p.angular_velocity[i]};
    }
    return rows;
}

ContactTable contact_table(const Simulation& simulation) {
    const auto add = [](const StoredVec3& v, auto& values) {
        using Number = typename std::remove_reference_t<decltype(values)>::value_type;
        for (const double x : {v.x, v.y, v.z}) values.push_back(static_cast<Number>(x));
    };
    ContactTable table;
    table.time = simulation.time();
    DEM_ASSERT(simulation.contacts() != nullptr);
    for (const SeenContact& contact : *simulation.contacts()) {
        const bool is_wall = contact.is_wall != 0;
        table.i.push_back(contact.i);
        table.j.push_back(is_wall ? no_partner : contact.j);
        table.wall.push_back(is_wall ? contact.j : no_partner);
        table.slips.push_back(contact.slips);
        add(contact.point, table.point);
        add(contact.normal, table.normal);
        add(contact.force, table.force);
        add(contact.friction, table.friction);
        add(contact.velocity, table.velocity);
        table.normal_force.push_back(contact.normal_force);
        table.friction_limit.push_back(contact.friction_limit);
        table.overlap.push_back(contact.overlap);
        add(contact.center_i, table.lines);
        add(contact.center_j, table.lines);
    }
    return table;
}

void write_picture(const std::filesystem::path& path, const Simulation& simulation) {
    const Particles& p = simulation.particles();
    const Scene& scene = simulation.scene();
    std::vector<PictureBody> bodies;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        bodies.push_back({&scene.shapes[scene.kinds[p.kind[i]].shape].display_mesh, p.position[i],
                          p.orientation[i], p.group[i]});
    }
    AtomicFile file(path);
    file.write(encode_png(
        render_picture(bodies, scene.walls, {simulation.time(), simulation.walls().settled}, {})));
    file.commit();
}

OutputProgress begun(const Scene& scene) {
    OutputProgress progress;
    progress.frames_every = scene.output.frames_every.value_or(scene.run.end_time / 100.0);
    progress.history_every = scene.output.history_every.value_or(scene.run.end_time / 1000.0);
    return progress;
}

OutputProgress resumed(const Scene& scene, OutputProgress progress) {
    progress.frames_every = scene.output.frames_every.value_or(progress.frames_every);
    progress.history_every = scene.output.history_every.value_or(progress.history_every);
    return progress;
}

std::vector<Cadence> measure_cadences(const Scene& scene, const OutputProgress& progress) {
    std::vector<Cadence> cadences;
    for (const MeasureSettings& measure : scene.measures) {
        cadences.emplace_back(measure.every.value_or(progress.history_every));
    }
    return cadences;
}

std::string end_name(RunResult::End end) {
    switch (end) {
        case RunResult::End::end_time:
            return "end_time";
        case RunResult::End::at_rest:
            return "at_rest";
        case RunResult::End::interrupted:
            return "interrupted";
        case RunResult::End::failed:
            return "failed";
    }
    return "";
}

}  // namespace

std::filesystem::path checkpoint_path(const Scene& scene) {
    return std::filesystem::path(scene.output.directory) / "checkpoint.h5";
}

bool holds_end(const Scene& scene, const RunResult& result) {
    const std::filesystem::path folder = scene.output.directory;
    std::error_code ignored;
    const auto has = [&](const char* name) {
        return std::filesystem::exists(folder / name, ignored);
    };
    // A journal has work to do.
    for (const char* film : {"frames.h5.journal", "surfaces.h5.journal", "contacts.h5.journal",
                             "wall_contacts.h5.journal"})
        if (has(film)) return false;
    if (!has("final.csv") || (scene.output.picture && !has("final.png"))) return false;
    RunSummary summary;
    summary.end = end_name(result.end);
    summary.reason = result.reason;
    summary.state_hash = result.state_hash;
    return tells_of(folder / "summary.json", summary);
}

Outputs::Outputs(const Scene& scene)
    : directory_(scene.output.directory),
      writes_contacts_(scene.output.contacts),
      wall_triangles_(wall_triangles(scene)),
      history_(directory_ / "history.csv", history_columns(scene)),
      frames_(directory_, frame_context(scene, wall_triangles_), scene.shapes),
      progress_(begun(scene)),
      frame_cadence_(progress_.frames_every),
      row_cadence_(progress_.history_every),
      measure_cadences_(measure_cadences(scene, progress_)) {
    progress_.rows_hash = history_.hash();
    remove_end(directory_);
    std::error_code ignored;
    std::filesystem::remove(checkpoint_path(scene), ignored);
    // Those of a run that is written over: they would lie beside frames of this one.
    const auto remove_both = [&](const std::string& name) {
        std::filesystem::remove(directory_ / (name + ".h5"), ignored);
        std::filesystem::remove(directory_ / (name + ".xdmf"), ignored);
    };
    if (!scene.output.surfaces) remove_both("surfaces");
    if (!scene.output.contacts) remove_both("contacts");
    if (!scene.output.wall_contacts) remove_both("wall_contacts");
}

Outputs::Outputs(const Scene& scene, const OutputProgress& progress)
    : directory_(scene.output.directory),
      writes_contacts_(scene.output.contacts),
      wall_triangles_(wall_triangles(scene)),
      history_(directory_ / "history.csv", history_columns(scene), progress.rows,
               progress.rows_hash),
      frames_(directory_, frame_context(scene, wall_triangles_), scene.shapes, progress.frames),
      progress_(resumed(scene, progress)),
      frame_cadence_(progress_.frames_every),
      row_cadence_(progress_.history_every),
      measure_cadences_(measure_cadences(scene, progress_)) {
    remove_end(directory_);
    static_cast<void>(frame_cadence_.is_due(progress.sampled));
    static_cast<void>(row_cadence_.is_due(progress.sampled));
    for (Cadence& cadence : measure_cadences_) static_cast<void>(cadence.is_due(progress.sampled));
}

void Outputs::sync() {
    frames_.secure();
    const std::string path = (directory_ / "history.csv").string();
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_synced = descriptor >= 0 && fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0) close(descriptor);
    if (!is_synced) {
        throw Error(path, "cannot write: " + std::generic_category().message(error));
    }
}

void Outputs::sample(const Simulation& simulation) {
    const double time = simulation.time();
    if (frame_cadence_.is_due(time)) write_frame(simulation);
    bool row_is_due = row_cadence_.is_due(time);
    due_measures_.resize(measure_cadences_.size());
    for (std::size_t k = 0; k < measure_cadences_.size(); ++k) {
        due_measures_[k] = static_cast<std::uint8_t>(measure_cadences_[k].is_due(time));
        row_is_due |= due_measures_[k] != 0;
    }
    if (row_is_due) write_row(simulation);
    progress_.frames = frames_.count();
    progress_.rows = history_.rows();
    progress_.rows_hash = history_.hash();
    progress_.sampled = time;
}

void Outputs::write_frame(const Simulation& simulation) {
    const Stopwatch watch(output_time_);
    const Particles& p = simulation.particles();
    std::vector<std::uint32_t> shape;
    for (const std::uint32_t kind : p.kind) shape.push_back(simulation.scene().kinds[kind].shape);
    const auto coordination = coordination_numbers(simulation);
    Frame frame{simulation.time(),
                simulation.steps(),
                p.id,
                p.position,
                p.orientation,
                p.velocity,
                p.angular_velocity,
                shape,
                p.group,
                coordination,
                p.force};
    ContactTable contacts;
    if (simulation.scene().output.contacts) {
        contacts = contact_table(simulation);
        frame.contacts = &contacts;
    }
    WallContactTable wall_contacts;
    if (simulation.scene().output.wall_contacts) {
        wall_contacts = wall_contact_table(simulation, wall_triangles_, progress_.loads);
        frame.wall_contacts = &wall_contacts;
    }
    frames_.append(frame);
    last_frame_ = simulation.time();
}

void Outputs::measure(const Simulation& simulation) {
    const Stopwatch watch(measure_time_);
    const auto& measures = simulation.scene().measures;
    measured_.clear();
    for (std::size_t k = 0; k < measures.size(); ++k) {
        if (due_measures_[k] == 0) {
            measured_.resize(measured_.size() + measure_columns(measures[k]).size());
            continue;
        }
        for (const double value : measure_values(simulation, measures[k])) {
            measured_.emplace_back(value);
        }
    }
}

void Outputs::write_row(const Simulation& simulation) {
    measure(simulation);
    const Stopwatch watch(output_time_);
    const Energies e = energies(simulation);
    const auto count = static_cast<double>(simulation.particles().size());
    const auto numbers = coordination_numbers(simulation);
    const double sum =
        static_cast<double>(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0}));
    std::vector<std::optional<double>> row = {simulation.time(),
                                              static_cast<double>(simulation.steps()),
                                              count,
                                              e.translational,
                                              e.rotational,
                                              e.elastic,
                                              e.potential,
                                              e.dissipated,
                                              e.wall_work,
                                              e.inserted,
                                              static_cast<double>(contact_count(simulation)),
                                              count > 0.0 ? sum / count : 0.0,
                                              simulation.largest_overlap().relative};
    if (!simulation.outlets().is_empty()) {
        row.emplace_back(e.removed);
        add_outflow(simulation, row);
    }
    for (const double value : wall_force_values(simulation)) row.emplace_back(value);
    row.insert(row.end(), measured_.begin(), measured_.end());
    history_.append(row);
    last_row_ = simulation.time();
}

void Outputs::add_outflow(const Simulation& simulation, std::vector<std::optional<double>>& row) {
    const Outlets& outlets = simulation.outlets();
    const double interval = simulation.time() - progress_.row_time;
    const auto rate = [&](double change) {
        return interval > 0.0 ? std::optional<double>(change / interval) : std::nullopt;
    };
    progress_.row_outflow.resize(outlets.names().size());
    for (std::size_t o = 0; o < outlets.names().size(); ++o) {
        Outflow& before = progress_.row_outflow[o];
        const Outflow now = outlets.total(o);
        row.emplace_back(static_cast<double>(now.bodies));
        row.emplace_back(now.mass);
        row.push_back(rate(static_cast<double>(now.bodies - before.bodies)));
        row.push_back(rate(now.mass - before.mass));
        before = now;
        if (outlets.outflow(o).size() < 2) continue;
        for (const Outflow& group : outlets.outflow(o)) {
            row.emplace_back(static_cast<double>(group.bodies));
            row.emplace_back(group.mass);
        }
    }
    progress_.row_time = simulation.time();
}

void Outputs::write_last_row(const Simulation& simulation) {
    due_measures_.assign(simulation.scene().measures.size(), 1);
    if (last_row_ < simulation.time()) {
        write_row(simulation);
    } else {
        measure(simulation);
    }
}

void Outputs::finish(const Simulation& simulation, const RunResult& result) {
    Attempts attempts;
    attempts.make([&] {
        if (last_frame_ < simulation.time()) write_frame(simulation);
    });
    attempts.make([&] { write_last_row(simulation); });
    attempts.make([&] { write_body_table(directory_ / "final.csv", body_rows(simulation)); });
    attempts.make([&] {
        if (simulation.scene().output.picture) write_picture(directory_ / "final.png", simulation);
    });
    attempts.make([&] { write_end(simulation, result); });
    attempts.check();
}

void Outputs::write_end(const Simulation& simulation, const RunResult& result) const {
    const Scene& scene = simulation.scene();
    RunSummary summary{.case_path = scene.case_path,
                       .end = end_name(result.end),
                       .reason = result.reason,
                       .steps = result.steps,
                       .time = result.time,
                       .time_step = result.time_step,
                       .particles = result.particles,
                       .missing = {},
                       .outlets = {},
                       .core_overlaps = result.core_overlaps,
                       .wall_time = result.wall_time,
                       .measure_time = result.measure_time,
                       .output_time = result.output_time,
                       .microseconds_per_particle_step = result.microseconds_per_particle_step,
                       .threads = simulation.team().most(),
                       .threads_used = simulation.team().mean_size(),
                       .lanes = simulation.lanes().width,
                       .seed = scene.run.seed,
                       .state_hash = result.state_hash,
                       .measures = {},
                       .inputs = scene.inputs};
    const Outlets& outlets = simulation.outlets();
    for (std::size_t o = 0; o < outlets.names().size(); ++o) {
        const Outflow total = outlets.total(o);
        const bool counts = o < scene.outlets.size() && scene.outlets[o].kind == Outlet::Kind::flow;
        summary.outlets.push_back(
            {outlets.names()[o], counts ? "flow" : "remove", total.bodies, total.mass});
    }
    for (const MissingBodies& group : result.missing) {
        summary.missing.emplace_back(group.group, group.count - group.placed);
    }
    const auto columns = measure_columns(scene);
    for (std::size_t k = 0; k < std::min(columns.size(), measured_.size()); ++k) {
        if (measured_[k]) summary.measures.emplace_back(columns[k], *measured_[k]);
    }
    write_summary(directory_ / "summary.json", summary);
}

}  // namespace dem::runtime
