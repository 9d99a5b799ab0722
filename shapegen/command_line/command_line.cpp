// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/command_line.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "shapegen/command_line/mesh_options.hpp"
#include "shapegen/command_line/option_text.hpp"
#include "shapegen/command_line/option_values.hpp"
#include "shapegen/import/mesh_file.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace dem::shapegen {

namespace {

using Words = std::vector<std::string>;

int threads(const OptionValues& values) {
    return static_cast<int>(values.count("threads"));
}

/// What a template says it was made by: the command line but for the number of threads, which
/// changes nothing in it.
std::string command_text(std::string text, const Words& words) {
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (words[k] == "--threads")
            ++k;  // its value, too
        else if (!words[k].starts_with("--threads="))
            text += ' ' + words[k];
    }
    return text;
}

CookOptions read_options(const OptionValues& values) {
    const auto count = [&](const char* option) {
        return static_cast<std::uint32_t>(values.count(option));
    };
    CookOptions options;
    options.kind = values.given("sphere") ? CookOptions::Kind::sphere : CookOptions::Kind::sr;
    options.nodes = count("nodes");
    options.resolution = {count("base-cells"), count("interface-cells"), count("corner-cells")};
    check_resolution(options.resolution);
    return options;
}

std::optional<PrintCommand> wanted_words(const OptionValues& values) {
    if (values.given("version")) return PrintCommand{"shapegen " DEM_VERSION "\n"};
    if (values.given("man")) return PrintCommand{man_page()};
    if (values.given("help")) return PrintCommand{help_text()};
    return std::nullopt;
}

/// The way to make a shape fits what the input is.
void check_mode(const OptionValues& values, const std::filesystem::path& input) {
    Words found;
    for (const char* mode :
         {"sr", "sphere", "clump", "clump-spheres", "clump-error", "convex", "wall"})
        if (values.given(mode)) found.emplace_back(mode);
    if (is_convex_file(input) && !found.empty() && found[0] != "convex")
        throw UsageError("--" + found[0], "found it with " + input.string() +
                                              ", expected it with a mesh or a profile");
    if (!is_mesh_file(input) && values.given("wall"))
        throw UsageError("--wall", "found it with " + input.string() +
                                       ", expected it with a mesh (" + mesh_extensions() + ")");
    if (is_mesh_file(input) && (found.empty() || found[0] == "sr" || found[0] == "sphere"))
        throw UsageError(input.string(),
                         "found a mesh without a mode, expected --clump C, --clump-spheres N, "
                         "--clump-error E%, --convex or --wall");
}

/// What a file holds is known by its extension alone.
void check_extension(const std::filesystem::path& input) {
    if (is_mesh_file(input) || is_convex_file(input) || input.extension() == ".profile") return;
    const std::string extension = input.extension().string();
    throw Error(input.string(),
                "found " +
                    (extension.empty() ? "no extension" : "the extension " + in_quotes(extension)) +
                    ", expected a mesh (" + mesh_extensions() +
                    "), a .profile or a .convex file; CAD programs write models as .stl");
}

Command parse_cook(const Words& words) {
    const OptionValues values(cook_command, words);
    if (const auto print = wanted_words(values)) return *print;
    CookCommand command;
    command.input = values.input("a mesh, a .profile or a .convex file");
    check_extension(command.input);
    const auto is_mode = [&](const std::string& option) { return values.given(option); };
    const Words modes = words_of(cook_command.find("sr")->excludes.names);
    const bool has_mode = std::ranges::any_of(modes, is_mode);
    values.check(is_convex_file(command.input) ? "convex" : has_mode ? "" : "sr", command.input);
    check_mode(values, command.input);
    if (const auto clump = read_clump_options(values))
        command.recipe = *clump;
    else if (const auto convex = read_convex_options(values, command.input))
        command.recipe = *convex;
    else if (values.given("wall"))
        command.recipe = WallRequest{values.quantity("crease")};
    else
        command.recipe = read_options(values);
    command.mesh = read_mesh_options(values);
    command.output = values.given("output") ? values.template_output()
                                            : command.input.filename().replace_extension(".tpl");
    command.is_quiet = values.given("quiet");
    command.threads = threads(values);
    command.text = command_text("shapegen", words);
    return command;
}

Command parse_generate(const Words& words) {
    const OptionValues values(generate_command, words);
    if (const auto print = wanted_words(values)) return *print;
    GenerateCommand command = read_generate_options(values, values.input("sand or woodchips"));
    command.threads = threads(values);
    command.text = command_text("shapegen generate", words);
    return command;
}

Command parse_inspect(const Words& words) {
    const OptionValues values(inspect_command, words);
    if (const auto print = wanted_words(values)) return *print;
    static_cast<void>(threads(values));  // of which there is nothing to do here
    return InspectCommand{values.input("a .tpl file"), values.given("json")};
}

Command parse_export(const Words& words) {
    const OptionValues values(export_command, words);
    if (const auto print = wanted_words(values)) return *print;
    static_cast<void>(threads(values));  // of which there is nothing to do here
    ExportCommand command;
    command.input = values.input("a .tpl file");
    values.check("", command.input);
    command.output = values.text("output");
    if (values.given("shape")) command.shape = values.text("shape");
    if (values.given("format")) command.format = values.text("format");
    if (values.given("unit")) {
        // Pictures write lengths in a unit that suits them.
        if (command.output.extension() == ".svg")
            throw UsageError("--unit",
                             "found it with a picture, expected it with .csv, .stl, .obj or .vtu");
        command.unit = values.length_unit("unit");
    }
    command.density = values.quantity("density");
    return command;
}

}  // namespace

Command parse_command_line(std::span<const char* const> arguments) {
    const Words words(arguments.begin() + 1, arguments.end());
    if (words.empty()) return parse_cook(words);
    const Words rest(words.begin() + 1, words.end());
    if (words.front() == "generate") return parse_generate(rest);
    if (words.front() == "inspect") return parse_inspect(rest);
    if (words.front() == "export") return parse_export(rest);
    return parse_cook(words);
}

}  // namespace dem::shapegen
