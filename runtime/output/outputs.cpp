// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/outputs.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "formats/body_table.hpp"
#include "formats/run_summary.hpp"
#include "runtime/measure/contact_count.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/measure/measures.hpp"
#include "runtime/output/picture.hpp"

#include <cerrno>
#include <numeric>
#include <system_error>

#include <fcntl.h>
#include <omp.h>
#include <unistd.h>

namespace dem {

namespace {

/// What an earlier run ended with would be taken for the end of this one.
void remove_end(const std::filesystem::path& directory) {
    for (const char* name : {"final.csv", "final.png", "summary.json"}) {
        std::error_code ignored;  // what cannot be removed cannot be replaced either, which fails
        std::filesystem::remove(directory / name, ignored);
    }
}

FrameContext frame_context(const Scene& scene) {
    FrameContext context{scene.case_path, {}, scene.output.surfaces};
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
    const auto measures = measure_columns(scene);
    columns.insert(columns.end(), measures.begin(), measures.end());
    return columns;
}

std::vector<BodyRow> body_rows(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    const Scene& scene = simulation.scene();
    std::vector<BodyRow> rows(p.size());
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        rows[i] = {.id = i,
                   .template_name = scene.shapes[scene.kinds[p.kind[i]].shape].name,
                   .group = scene.insertions[p.group[i]].name,
                   .position = p.position[i],
                   .orientation = p.orientation[i],
                   .velocity = p.velocity[i],
                   .angular_velocity = p.angular_velocity[i]};
    }
    return rows;
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
    file.write(encode_png(render_picture(bodies, scene.walls, simulation.time(), {})));
    file.commit();
}

std::string end_name(RunResult::End end) {
    switch (end) {
        case RunResult::End::end_time:
            return "end_time";
        case RunResult::End::at_rest:
            return "at_rest";
        case RunResult::End::interrupted:
            return "interrupted";
    }
    return "";
}

}  // namespace

std::filesystem::path checkpoint_path(const Scene& scene) {
    return std::filesystem::path(scene.output.directory) / "checkpoint.h5";
}

Outputs::Outputs(const Scene& scene)
    : directory_(scene.output.directory),
      history_(directory_ / "history.csv", history_columns(scene)),
      frames_(directory_, frame_context(scene), scene.shapes),
      frame_cadence_(scene.output.frames_every) {
    remove_end(directory_);
    std::error_code ignored;
    std::filesystem::remove(checkpoint_path(scene), ignored);
    make_cadences(scene);
}

Outputs::Outputs(const Scene& scene, const OutputProgress& progress, double time)
    : directory_(scene.output.directory),
      history_(directory_ / "history.csv", history_columns(scene), progress.rows),
      frames_(directory_, frame_context(scene), scene.shapes, progress.frames),
      frame_cadence_(scene.output.frames_every),
      progress_(progress) {
    remove_end(directory_);
    make_cadences(scene);
    // What was due up to the checkpoint has been written.
    static_cast<void>(frame_cadence_.is_due(time));
    for (Cadence& cadence : history_cadences_) static_cast<void>(cadence.is_due(time));
}

void Outputs::make_cadences(const Scene& scene) {
    history_cadences_.emplace_back(scene.output.history_every);
    for (const MeasureSettings& measure : scene.measures) {
        history_cadences_.emplace_back(measure.every);
    }
}

void Outputs::sync() const {
    for (const char* name : {"frames.h5", "history.csv"}) {
        const std::string path = (directory_ / name).string();
        const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
        const bool is_synced = descriptor >= 0 && fsync(descriptor) == 0;
        const int error = errno;
        if (descriptor >= 0) close(descriptor);
        if (!is_synced) {
            throw Error(path, "cannot write: " + std::generic_category().message(error));
        }
    }
}

void Outputs::sample(const Simulation& simulation) {
    if (frame_cadence_.is_due(simulation.time())) write_frame(simulation);
    bool row_is_due = false;
    for (Cadence& cadence : history_cadences_) row_is_due |= cadence.is_due(simulation.time());
    if (row_is_due) write_history(simulation);
}

void Outputs::write_frame(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    std::vector<std::uint32_t> id(p.size());
    std::iota(id.begin(), id.end(), 0U);
    std::vector<std::uint32_t> shape;
    for (const std::uint32_t kind : p.kind) shape.push_back(simulation.scene().kinds[kind].shape);
    const auto coordination = coordination_numbers(simulation);
    frames_.append({simulation.time(), simulation.steps(), id, p.position, p.orientation,
                    p.velocity, p.angular_velocity, shape, p.group, coordination, p.force});
    progress_.frames = frames_.count();
    progress_.last_frame = simulation.time();
}

void Outputs::write_history(const Simulation& simulation) {
    const Energies e = energies(simulation);
    const auto count = static_cast<double>(simulation.particles().size());
    const auto numbers = coordination_numbers(simulation);
    const double sum =
        static_cast<double>(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0}));
    std::vector<double> row = {simulation.time(),
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
    const auto measures = measure_values(simulation);
    row.insert(row.end(), measures.begin(), measures.end());
    history_.append(row);
    progress_.rows = history_.rows();
    progress_.last_row = simulation.time();
}

void Outputs::finish(const Simulation& simulation, const RunResult& result) {
    if (progress_.last_frame != simulation.time()) write_frame(simulation);
    if (progress_.last_row != simulation.time()) write_history(simulation);
    write_body_table(directory_ / "final.csv", body_rows(simulation));

    const Scene& scene = simulation.scene();
    if (scene.output.picture) write_picture(directory_ / "final.png", simulation);
    RunSummary summary{.case_path = scene.case_path,
                       .end = end_name(result.end),
                       .steps = result.steps,
                       .time = result.time,
                       .time_step = result.time_step,
                       .particles = result.particles,
                       .missing = {},
                       .core_overlaps = result.core_overlaps,
                       .wall_time = result.wall_time,
                       .microseconds_per_particle_step = result.microseconds_per_particle_step,
                       .threads = omp_get_max_threads(),
                       .seed = scene.run.seed,
                       .state_hash = result.state_hash,
                       .measures = {},
                       .inputs = scene.inputs};
    for (const MissingBodies& group : result.missing) {
        summary.missing.emplace_back(group.group, group.count - group.placed);
    }
    const auto columns = measure_columns(scene);
    const auto values = measure_values(simulation);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        summary.measures.emplace_back(columns[k], values[k]);
    }
    write_summary(directory_ / "summary.json", summary);
}

}  // namespace dem
