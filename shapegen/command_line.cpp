// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "common/units.hpp"
#include "shapegen/clump_options.hpp"
#include "shapegen/convex_options.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/mesh_options.hpp"
#include "shapegen/option_values.hpp"

#include <sstream>
#include <vector>

#include <boost/program_options.hpp>

namespace dem {

namespace {

namespace po = boost::program_options;
using Words = std::vector<std::string>;

po::options_description common_options() {
    po::options_description options("Everywhere");
    options.add_options()("threads", text("N")->default_value("0"),
                          "at most so many; 0: one per core; never changes a result")(
        "help,h", "print this and stop")("version", "print the version and stop");
    return options;
}

po::options_description cook_options() {
    po::options_description options("Cooking");
    options.add_options()("output,o", po::value<std::string>()->value_name("OUT.tpl"),
                          "the template to write; default: INPUT's name with .tpl, here")(
        "scale", po::value<std::string>()->default_value("1")->value_name("S"),
        "multiply all lengths of INPUT")("quiet,q", "print nothing but errors");
    return options;
}

po::options_description sr_options() {
    po::options_description options("Surfaces of revolution (docs/profile-file.md)");
    options.add_options()("sr", "as a surface of revolution: the default for a profile")(
        "sphere", "as an exact sphere; the profile must be one")(
        "nodes", text("N")->default_value("2000"), "surface nodes")(
        "base-cells", text("N")->default_value("50"),
        "distance-field cells per major axis: everywhere")(
        "interface-cells", text("N")->default_value("200"),
        "... near the surface; a power of two times the base cells")(
        "corner-cells", text("N")->default_value("800"),
        "... at sharp edges; a power of two times the interface cells");
    return options;
}

po::options_description inspect_options() {
    po::options_description options("Inspecting");
    options.add_options()("json", "print JSON");
    return options;
}

po::options_description export_options() {
    po::options_description options("Exporting");
    options.add_options()(
        "output,o", po::value<std::string>()->value_name("FILE"),
        "the file to write, in the frame and the unit of the input. Clump: .csv spheres; .stl "
        "spheres as triangles; .vtu or .obj body and clump; .svg picture of both, colored by "
        "deviation. Other shapes: .stl, .vtu or .obj display mesh; .svg picture. Surface of "
        "revolution: .csv surface nodes. Library: .svg of the first 25 shapes")(
        "unit", po::value<std::string>()->value_name("UNIT"),
        "of lengths in tables and surfaces: m, mm, um, cm, in; default: the input's, a --scale "
        "included; m where there was none (generate)")(
        "format", po::value<std::string>()->value_name("CODE"),
        "a clump for liggghts, lammps, yade, mercurydpm (a folder) or dem-engine")(
        "density", po::value<std::string>()->default_value("1000 kg/m^3")->value_name("D"),
        "for the masses that such files hold")("shape",
                                               po::value<std::string>()->value_name("NAME|INDEX"),
                                               "which shape of a template that holds several");
    return options;
}

std::string help_text() {
    std::ostringstream out;
    out << "shapegen cooks a particle shape: it computes once what a run needs and writes it, with "
           "the error\nit makes, into a template for demrun.\n\n"
           "  shapegen PROFILE [-o OUT.tpl] [options]\n"
           "  shapegen MESH|PROFILE --clump 0.95 [-o OUT.tpl] [options]\n"
           "  shapegen SHAPE.convex [-o OUT.tpl] [--rounding R]\n"
           "  shapegen MESH --convex [--vertices N] [--keep-volume] [--rounding R] [-o OUT.tpl]\n"
           "  shapegen generate sand|woodchips --count N -o OUT.tpl [options]\n"
           "  shapegen inspect FILE.tpl [--json]\n"
           "  shapegen export FILE.tpl -o FILE.{svg,stl,obj,vtu,csv} [--shape NAME|INDEX]\n"
           "  shapegen export FILE.tpl -o FILE --format "
           "liggghts|lammps|yade|mercurydpm|dem-engine\n\n"
           "A PROFILE is the generating curve of a surface of revolution; a MESH is a .stl, .obj, "
           ".ply, .off,\n.gltf or .glb file.\n\n"
        << cook_options() << '\n'
        << sr_options() << '\n'
        << clump_options() << '\n'
        << convex_options() << '\n'
        << mesh_options() << '\n'
        << generate_options() << '\n'
        << inspect_options() << '\n'
        << export_options() << '\n'
        << common_options()
        << "\nExit codes: 0 done, 1 failed (input, disk), 2 wrong command line.\n\n"
           "Example:\n"
           "  shapegen data/profiles/tablet.profile && shapegen export tablet.tpl -o tablet.svg\n"
           "  shapegen data/meshes/bunny.ply --clump 0.95 && shapegen inspect bunny.tpl\n";
    return out.str();
}

/// What Boost says, as one line of ours; a misspelt option gets the nearest known one.
[[noreturn]] void refuse(const po::error& error, const po::options_description& options) {
    if (const auto* unknown = dynamic_cast<const po::unknown_option*>(&error)) {
        Words names;
        for (const auto& option : options.options()) names.push_back(option->long_name());
        std::string word = unknown->get_option_name();
        word.erase(0, word.find_first_not_of('-'));
        const std::string nearest = nearest_word(word, names);
        throw UsageError(
            "command line",
            "unknown option " + in_quotes("--" + word) + ", " +
                (nearest.empty() ? "see --help" : "did you mean '--" + nearest + "'?"));
    }
    throw UsageError("command line", std::string(error.what()) + ", see --help");
}

po::variables_map parse(const Words& words, po::options_description options) {
    options.add(common_options());
    po::options_description all = options;
    all.add_options()("input", po::value<Words>()->value_name("FILE"));
    po::positional_options_description positional;
    positional.add("input", -1);
    po::variables_map values;
    try {
        using namespace po::command_line_style;
        // Abbreviated options would change their meaning when an option is added.
        po::store(po::command_line_parser(words)
                      .options(all)
                      .positional(positional)
                      .style(unix_style & ~allow_guessing)
                      .run(),
                  values);
        po::notify(values);
    } catch (const po::error& error) {
        refuse(error, options);
    }
    return values;
}

std::string one_input(const po::variables_map& values, const std::string& expected) {
    const auto found = values.count("input") != 0 ? values["input"].as<Words>() : Words{};
    if (found.empty()) {
        throw UsageError("command line", "found no input, expected " + expected + ", see --help");
    }
    if (found.size() > 1) {
        throw UsageError("command line", "found a second input " + in_quotes(found[1]) +
                                             ", expected one: " + expected + ", see --help");
    }
    return found.front();
}

std::uint32_t number(const po::variables_map& values, const std::string& option,
                     std::uint32_t least, std::uint32_t most) {
    return static_cast<std::uint32_t>(whole_number(values, option, least, most));
}

int threads(const po::variables_map& values) {
    return static_cast<int>(number(values, "threads", 0, 4096));
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

CookOptions read_options(const po::variables_map& values) {
    CookOptions options;
    options.kind = values.count("sphere") != 0 ? CookOptions::Kind::sphere : CookOptions::Kind::sr;
    options.nodes = number(values, "nodes", fewest_nodes, most_nodes);
    options.resolution = {number(values, "base-cells", fewest_base_cells, most_cells),
                          number(values, "interface-cells", fewest_base_cells, most_cells),
                          number(values, "corner-cells", fewest_base_cells, most_cells)};
    check_resolution(options.resolution);
    return options;
}

bool wants_words(const po::variables_map& values, PrintCommand& print) {
    if (values.count("help") != 0) print.text = help_text();
    if (values.count("version") != 0) print.text = "shapegen " DEM_VERSION "\n";
    return !print.text.empty();
}

/// At most one way to make a shape, and no option of another way.
void check_modes(const po::variables_map& values, const CookCommand& command) {
    Words found;
    for (const char* mode : {"sr", "sphere", "clump", "clump-spheres", "clump-error", "convex"})
        if (values.count(mode) != 0) found.emplace_back(mode);
    if (found.size() > 1)
        throw UsageError("command line",
                         "found --" + found[0] + " and --" + found[1] + ", expected one of them");
    if (is_convex_file(command.input) && !found.empty() && found[0] != "convex")
        throw UsageError("--" + found[0], "found it with " + command.input.string() +
                                              ", expected it with a mesh or a profile");
    if (std::holds_alternative<CookOptions>(command.recipe)) return;
    for (const char* option : {"nodes", "base-cells", "interface-cells", "corner-cells"})
        if (!values[option].defaulted())
            throw UsageError("--" + std::string(option),
                             "found it with a shape of another kind, expected it with --sr only");
}

/// The options of meshes mean nothing for a profile, which says its unit itself.
void check_input_kind(const po::variables_map& values, const CookCommand& command) {
    if (is_mesh_file(command.input)) {
        if (std::holds_alternative<CookOptions>(command.recipe))
            throw UsageError(command.input.string(),
                             "found a mesh without a mode, expected --clump C, --clump-spheres N, "
                             "--clump-error E% or --convex");
        return;
    }
    for (const char* option : {"unit", "repair-limit", "largest", "union"})
        if (values.count(option) != 0 && !values[option].defaulted())
            throw UsageError("--" + std::string(option), "found it with " + command.input.string() +
                                                             ", expected it with a mesh (" +
                                                             mesh_extensions() + ")");
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
    po::options_description options = cook_options();
    options.add(sr_options()).add(clump_options()).add(convex_options()).add(mesh_options());
    const po::variables_map values = parse(words, options);
    PrintCommand print;
    if (wants_words(values, print)) return print;
    CookCommand command;
    command.input = one_input(values, "a mesh, a .profile or a .convex file");
    check_extension(command.input);
    const auto clump = read_clump_options(values);
    const auto convex = read_convex_options(values, command.input);
    if (clump)
        command.recipe = *clump;
    else if (convex)
        command.recipe = *convex;
    else
        command.recipe = read_options(values);
    check_modes(values, command);
    check_input_kind(values, command);
    command.mesh = read_mesh_options(values);
    command.output = values.count("output") != 0
                         ? template_output(values)
                         : command.input.filename().replace_extension(".tpl");
    command.is_quiet = values.count("quiet") != 0;
    command.threads = threads(values);
    command.text = command_text("shapegen", words);
    return command;
}

Command parse_generate(const Words& words) {
    const po::variables_map values = parse(words, generate_options());
    PrintCommand print;
    if (wants_words(values, print)) return print;
    GenerateCommand command = read_generate_options(values, one_input(values, "sand or woodchips"));
    command.threads = threads(values);
    command.text = command_text("shapegen generate", words);
    return command;
}

Command parse_inspect(const Words& words) {
    const po::variables_map values = parse(words, inspect_options());
    PrintCommand print;
    if (wants_words(values, print)) return print;
    return InspectCommand{one_input(values, "a .tpl file"), values.count("json") != 0};
}

/// Pictures write lengths in a unit that suits them, files of other codes are in SI units.
double export_unit(const po::variables_map& values, const ExportCommand& command) {
    if (!command.format.empty())
        throw UsageError("--unit", "found it with --format " + command.format +
                                       ", expected it without: such files are in SI units");
    if (command.output.extension() == ".svg")
        throw UsageError("--unit",
                         "found it with a picture, expected it with .csv, .stl, .obj or "
                         ".vtu");
    return length_unit_option(values, "unit");
}

Command parse_export(const Words& words) {
    const po::variables_map values = parse(words, export_options());
    PrintCommand print;
    if (wants_words(values, print)) return print;
    if (values.count("output") == 0) {
        throw UsageError("command line", "found no -o, expected -o FILE.{svg,stl,obj,vtu,csv}");
    }
    ExportCommand command;
    command.input = one_input(values, "a .tpl file");
    command.output = values["output"].as<std::string>();
    if (values.count("shape") != 0) command.shape = values["shape"].as<std::string>();
    if (values.count("format") != 0) command.format = values["format"].as<std::string>();
    if (!values["density"].defaulted() && command.format.empty())
        throw UsageError("--density", "found it without --format, expected it with one");
    if (values.count("unit") != 0) command.unit = export_unit(values, command);
    const auto density = values["density"].as<std::string>();
    try {
        command.density = parse_quantity(density, Dimension::density);
    } catch (const Error& error) {
        throw UsageError("--density", error.what());
    }
    if (!(command.density > 0.0))
        throw UsageError("--density",
                         "found " + in_quotes(density) + ", expected a density above 0");
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

}  // namespace dem
