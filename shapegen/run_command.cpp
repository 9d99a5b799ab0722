// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/run_command.hpp"

#include "common/error.hpp"
#include "formats/profile_file.hpp"
#include "formats/template_reader.hpp"
#include "formats/template_summary.hpp"
#include "formats/template_writer.hpp"
#include "shapegen/pipeline/export.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <ostream>

namespace dem {

namespace {

/// Surfaces of any shape need the modes for meshes, which this version does not have.
void refuse_mesh(const std::filesystem::path& input) {
    constexpr std::array extensions{".stl",  ".obj", ".ply", ".off",
                                    ".gltf", ".glb", ".3mf", ".vtk"};
    std::string extension = input.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) return;
    throw Error(input.string(), "found a mesh (" + extension +
                                    "), expected a .profile: this version cooks profiles only "
                                    "(--sr, --sphere); clumps, convex bodies and walls from meshes "
                                    "come in a later version");
}

/// The output replaces what was there: never what was read.
void keep_input(const std::filesystem::path& input, const std::filesystem::path& output) {
    std::error_code missing;  // an output that does not exist yet is no input
    if (std::filesystem::equivalent(input, output, missing)) {
        throw UsageError(output.string(), "found the input itself, expected another output");
    }
}

void run(const CookCommand& command, std::ostream& out) {
    const auto start = std::chrono::steady_clock::now();
    refuse_mesh(command.input);
    keep_input(command.input, command.output);
    const ProfileFile file = read_profile(command.input.string());
    TemplateFile result;
    result.command = command.text;
    result.input_hash = file.hash;
    result.shapegen_version = DEM_VERSION;
    result.shapes.push_back(cook(file.profile, file.name, command.options));
    write_template(command.output, result);
    if (command.is_quiet) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::array<char, 80> words{};
    std::snprintf(words.data(), words.size(), ": %.0f KB in %.2f s\n",
                  1e-3 * static_cast<double>(std::filesystem::file_size(command.output)),
                  seconds.count());
    out << template_text(result) << command.output.string() << words.data();
}

void run(const InspectCommand& command, std::ostream& out) {
    const TemplateFile file = read_template(command.input);
    out << (command.as_json ? template_json(file) : template_text(file));
}

void run(const ExportCommand& command, std::ostream&) {
    keep_input(command.input, command.output);
    const TemplateFile file = read_template(command.input);
    export_shape(find_shape(file, command.input.string(), command.shape), command.output);
}

void run(const PrintCommand& command, std::ostream& out) {
    out << command.text;
}

}  // namespace

void run_command(const Command& command, std::ostream& out) {
    std::visit([&out](const auto& chosen) { run(chosen, out); }, command);
}

}  // namespace dem
