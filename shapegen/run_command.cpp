// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/run_command.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/format.hpp"
#include "common/progress.hpp"
#include "common/text.hpp"
#include "common/threads/thread_team.hpp"
#include "common/units.hpp"
#include "formats/template_reader.hpp"
#include "formats/template_writer.hpp"
#include "shapegen/certificate/template_summary.hpp"
#include "shapegen/export/clump_export.hpp"
#include "shapegen/picture/contact_sheet.hpp"
#include "shapegen/picture/convergence_plot.hpp"
#include "shapegen/pipeline/export.hpp"
#include "shapegen/pipeline/generate.hpp"
#include "shapegen/profile/profile_file.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <ostream>

namespace dem::shapegen {

namespace {

/// The output replaces what was there: never what was read.
void keep_input(const std::filesystem::path& input, const std::filesystem::path& output) {
    std::error_code missing;  // an output that does not exist yet is no input
    if (std::filesystem::equivalent(input, output, missing)) {
        throw UsageError(output.string(), "found the input itself, expected another output");
    }
}

/// Before minutes of work: whether the output can be made at all. Throws Error.
void check_writable(const std::filesystem::path& output) {
    const AtomicFile probe(output);
}

/// Progress on stderr for work that takes more than a moment.
class LateProgress {
  public:
    LateProgress(std::string task, bool is_quiet, bool has_estimate)
        : task_(std::move(task)),
          style_(Progress::stderr_style(is_quiet)),
          has_estimate_(has_estimate) {}

    void update(double done, std::string_view next) {
        constexpr double moment = 2.0;  // [s]
        if (!progress_ && Progress::steady_seconds() - start_ < moment) return;
        if (!progress_) {
            progress_ = std::make_unique<Progress>(std::cerr, style_, task_, 1.0);
            progress_->begin_at(done);
            if (!has_estimate_) progress_->leave_out_estimate();
        }
        progress_->update(done, next);
    }

  private:
    std::string task_;
    Progress::Style style_;
    bool has_estimate_;
    double start_ = Progress::steady_seconds();
    std::unique_ptr<Progress> progress_;
};

/// Shows a part of all work, from `begin` to `end`.
StageProgress part(LateProgress& progress, double begin, double end) {
    return [&progress, begin, end](double done, std::string_view next) {
        progress.update(begin + (end - begin) * done, next);
    };
}

/// A template of one shape or a wall; `lines` are for the user.
struct Cooked {
    std::variant<ParticleTemplate, WallTemplate> shape;
    std::uint64_t input_hash = 0;
    std::vector<std::string> lines;
};

Cooked cook_as(const CookOptions& options, const CookCommand& command) {
    const ProfileFile file = read_profile(command.input.string(), command.mesh.scale);
    ParticleTemplate shape = cook(file.profile, file.name, options);
    shape.input_unit = file.unit;
    return {std::move(shape), file.hash, {}};
}

void write_convergence(const std::filesystem::path& path, const std::string& name,
                       const std::vector<ConvergenceRow>& rows) {
    write_file(path,
               path.extension() == ".svg" ? convergence_plot(name, rows) : convergence_csv(rows));
}

Cooked cook_as(const ClumpCommand& wanted, const CookCommand& command) {
    LateProgress progress("shapegen " + command.input.filename().string(), command.is_quiet, false);
    constexpr double loading = 0.1;  // of the time
    MeshLoadOptions mesh = command.mesh;
    mesh.progress = part(progress, 0.0, loading);
    const Solid solid = load_solid(command.input, mesh);
    ClumpRequest request = wanted.request;
    request.options.progress = part(progress, loading, 1.0);
    request.wants_convergence = !wanted.convergence.empty();
    CookedClump clump = cook_clump(solid, request);
    if (request.wants_convergence)
        write_convergence(wanted.convergence, solid.name, clump.convergence);
    std::vector<std::string> lines = solid.lines;
    lines.insert(lines.end(), clump.lines.begin(), clump.lines.end());
    return {std::move(clump.shape), solid.hash, std::move(lines)};
}

Cooked cook_as(const ConvexRequest& request, const CookCommand& command) {
    CookedConvex cooked = cook_convex(command.input, request, command.mesh);
    return {std::move(cooked.shape), cooked.hash, std::move(cooked.lines)};
}

Cooked cook_as(const WallRequest& request, const CookCommand& command) {
    CookedWall cooked = cook_wall(command.input, request, command.mesh);
    return {std::move(cooked.wall), cooked.hash, std::move(cooked.lines)};
}

/// What is wrong with the input is said at its place, also by those who do not know its name.
Cooked cook_input(const CookCommand& command) {
    try {
        return std::visit([&](const auto& recipe) { return cook_as(recipe, command); },
                          command.recipe);
    } catch (const UsageError&) {
        throw;
    } catch (const Error& error) {
        const std::string words = error.what();
        const auto begins_with = [&](const std::filesystem::path& place) {
            return !place.empty() && words.starts_with(readable(place.string()));
        };
        const auto* clump = std::get_if<ClumpCommand>(&command.recipe);
        const bool has_place = begins_with(command.input) || words.starts_with("--") ||
                               (clump != nullptr && begins_with(clump->convergence));
        if (has_place) throw;
        throw Error(command.input.string(), words);
    }
}

/// Writes what was cooked, and returns what there is to say about it.
std::string write_cooked(const std::filesystem::path& path, TemplateFile& file, Cooked& cooked) {
    if (const auto* wall = std::get_if<WallTemplate>(&cooked.shape)) {
        write_template(path, file, *wall);
        return template_text(file, *wall);
    }
    file.shapes.push_back(std::move(std::get<ParticleTemplate>(cooked.shape)));
    write_template(path, file);
    return template_text(file);
}

void run(const CookCommand& command, std::ostream& out) {
    ThreadTeam team(command.threads);
    const ThreadTeam::InForce together(&team);
    const auto start = std::chrono::steady_clock::now();
    keep_input(command.input, command.output);
    check_writable(command.output);
    const auto* clump = std::get_if<ClumpCommand>(&command.recipe);
    if (clump != nullptr && !clump->convergence.empty()) {
        keep_input(command.input, clump->convergence);
        check_writable(clump->convergence);
    }
    Cooked cooked = cook_input(command);
    TemplateFile result;
    result.command = command.text;
    result.input_hash = cooked.input_hash;
    result.shapegen_version = DEM_VERSION;
    const std::string about = write_cooked(command.output, result, cooked);
    if (command.is_quiet) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::array<char, 80> words{};
    std::snprintf(words.data(), words.size(), ": %.0f KB in %.2f s\n",
                  1e-3 * static_cast<double>(std::filesystem::file_size(command.output)),
                  seconds.count());
    for (const std::string& line : cooked.lines)
        out << command.input.filename().string() << ": " << line << '\n';
    out << about << command.output.string() << words.data();
}

void run(const GenerateCommand& command, std::ostream& out) {
    ThreadTeam team(command.threads);
    const ThreadTeam::InForce together(&team);
    const auto start = std::chrono::steady_clock::now();
    LateProgress progress("shapegen generate", command.is_quiet, true);
    const LibraryRequest request{command.grains, command.count, command.text,
                                 part(progress, 0.0, 1.0)};
    const LibrarySummary made = generate_library(request, command.output);
    if (command.is_quiet) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const LengthUnit unit = length_unit(equivalent_diameter(made.mean));
    const double cubed = cube(unit.meters);
    out << format(
        "%s: %llu shapes of %.1f vertices on average, volumes %.4g to %.4g %s^3, mean "
        "%.4g\n  %llu slivers that the rounding does not fit drawn again\n"
        "  rounded bodies within %.2g d_eq of their polyhedra, of equal volume\n"
        "  %.0f KB in %.2f s\n",
        command.output.string().c_str(), static_cast<unsigned long long>(command.count),
        made.mean_vertices, made.smallest / cubed, made.largest / cubed, unit.name.c_str(),
        made.mean / cubed, static_cast<unsigned long long>(made.redrawn), made.surface_deviation,
        1e-3 * static_cast<double>(std::filesystem::file_size(command.output)), seconds.count());
}

void run(const InspectCommand& command, std::ostream& out) {
    const TemplateLibrary library(command.input);
    if (library.is_wall(0)) {
        const WallTemplate wall = library.wall(0);
        const TemplateFile head = library.head();
        out << (command.as_json ? template_json(head, wall) : template_text(head, wall));
        return;
    }
    const TemplateFile file = read_template(command.input);
    out << (command.as_json ? template_json(file) : template_text(file));
}

void run(const ExportCommand& command, std::ostream&) {
    keep_input(command.input, command.output);
    const TemplateFile file = read_template(command.input);
    if (command.shape.empty() && command.format.empty() && file.shapes.size() > 1 &&
        command.output.extension() == ".svg")
        return write_file(command.output, contact_sheet(file.shapes));
    const ParticleTemplate& shape = find_shape(file, command.input.string(), command.shape);
    if (command.format.empty())
        export_shape(shape, command.output, command.unit.value_or(shape.input_unit));
    else
        write_clump_file(command.output, shape, command.format, command.density);
}

void run(const PrintCommand& command, std::ostream& out) {
    out << command.text;
}

}  // namespace

void run_command(const Command& command, std::ostream& out) {
    std::visit([&out](const auto& chosen) { run(chosen, out); }, command);
}

}  // namespace dem::shapegen
