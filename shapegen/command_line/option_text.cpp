// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/option_text.hpp"

#include <array>
#include <sstream>
#include <vector>

namespace dem::shapegen {

namespace {

namespace po = boost::program_options;

constexpr std::string_view purpose =
    "shapegen cooks a particle shape: it computes once what a run needs and writes it, with the "
    "error it makes, into a template for demrun.";

constexpr std::array<std::string_view, 9> synopsis{
    "PROFILE [-o OUT.tpl] [options]",
    "MESH|PROFILE --clump 0.95 [-o OUT.tpl] [options]",
    "SHAPE.convex [-o OUT.tpl] [--rounding R]",
    "MESH --convex [--vertices N] [--keep-volume] [--rounding R] [-o OUT.tpl]",
    "MESH --wall [--crease ANGLE] [-o OUT.tpl]",
    "generate sand|woodchips --count N -o OUT.tpl [options]",
    "inspect FILE.tpl [--json]",
    "export FILE.tpl -o FILE.{svg,stl,obj,vtu,csv} [--shape NAME|INDEX]",
    "export FILE.tpl -o FILE --format liggghts|lammps|yade|mercurydpm|dem-engine"};

constexpr std::string_view inputs =
    "A PROFILE is the generating curve of a surface of revolution; a MESH is a .stl, .obj, .ply, "
    ".off, .gltf or .glb file.";

constexpr std::string_view exit_codes = "0 done, 1 failed (input, disk), 2 wrong command line.";

constexpr std::array<std::string_view, 2> examples{
    "shapegen data/profiles/tablet.profile && shapegen export tablet.tpl -o tablet.svg",
    "shapegen data/meshes/bunny.ply --clump 0.95 && shapegen inspect bunny.tpl"};

const std::array<const CommandOptions*, 4> commands{&cook_command, &generate_command,
                                                    &inspect_command, &export_command};

/// Calls visit(group) for the groups of all commands, those that several have once and last.
template <class Visit>
void visit_groups(const Visit& visit) {
    for (const CommandOptions* command : commands)
        for (const OptionGroup& group : command->groups.first(command->groups.size() - 1))
            visit(group);
    visit(cook_command.groups.back());
}

/// In lines of 100 columns at most.
std::string wrapped(std::string_view text) {
    constexpr std::size_t columns = 100;
    std::istringstream words{std::string(text)};
    std::string lines, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > columns) {
            lines += line + '\n';
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return lines + line + '\n';
}

std::string description(const Option& option) {
    std::string text(option.help);
    const std::string expected = expected_value(option);
    if (!expected.empty()) text += "; " + std::string(option.value) + ": " + expected;
    if (option.required) text += "; required";
    return text;
}

/// As roff wants it: a minus is none of its hyphens, a backslash is said.
std::string roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    // What begins a line with a dot would be a request.
    return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string dashed(std::string_view list) {
    std::vector<std::string> words = words_of(list);
    for (std::string& word : words) word = "--" + word;
    return alternatives(words);
}

void describe(const Option& option, std::ostream& out) {
    out << ".TP\n";
    if (option.letter != '\0') out << "\\fB\\-" << option.letter << "\\fR, ";
    out << "\\fB\\-\\-" << roff(option.name) << "\\fR";
    if (!option.value.empty()) out << " \\fI" << roff(option.value) << "\\fR";
    out << '\n' << roff(description(option)) << ".\n";
    if (!option.standard.empty()) out << "Default: " << roff(option.standard) << ".\n";
    if (!option.needs.names.empty())
        out << "Goes with " << roff(dashed(option.needs.names)) << ".\n";
    if (option.for_meshes) out << "Goes with a mesh.\n";
    std::string others;
    for (const std::string& other : words_of(option.excludes.names))
        if (other != option.name) others += (others.empty() ? "" : "|") + other;
    if (!others.empty()) out << "Not with " << roff(dashed(others)) << ".\n";
}

}  // namespace

po::options_description described(const OptionGroup& group) {
    po::options_description result{std::string(group.title)};
    for (const Option& option : group.options) {
        std::string names(option.name);
        if (option.letter != '\0') names += std::string(",") + option.letter;
        if (option.type == OptionType::flag) {
            result.add_options()(names.c_str(), description(option).c_str());
            continue;
        }
        auto* value = po::value<std::string>()->value_name(std::string(option.value));
        if (!option.standard.empty()) value->default_value(std::string(option.standard));
        result.add_options()(names.c_str(), value, description(option).c_str());
    }
    return result;
}

std::string help_text() {
    std::ostringstream out;
    out << wrapped(purpose) << '\n';
    for (const std::string_view form : synopsis) out << "  shapegen " << form << '\n';
    out << '\n' << wrapped(inputs) << '\n';
    visit_groups([&](const OptionGroup& group) { out << described(group) << '\n'; });
    out << "Exit codes: " << exit_codes << "\n\nExamples:\n";
    for (const std::string_view example : examples) out << "  " << example << '\n';
    return out.str();
}

std::string man_page() {
    std::ostringstream out;
    out << ".TH SHAPEGEN 1 \"\" \"ShapeDEM " DEM_VERSION "\"\n.SH NAME\n"
        << "shapegen \\- cook particle shapes for demrun\n.SH SYNOPSIS\n";
    for (const std::string_view form : synopsis)
        out << "\\fBshapegen\\fR " << roff(form) << "\n.br\n";
    out << ".SH DESCRIPTION\n" << roff(purpose) << "\n.PP\n" << roff(inputs) << "\n.SH OPTIONS\n";
    visit_groups([&](const OptionGroup& group) {
        out << ".SS " << roff(group.title) << '\n';
        for (const Option& option : group.options) describe(option, out);
    });
    out << ".SH EXIT STATUS\n" << roff(exit_codes) << "\n.SH EXAMPLES\n";
    for (const std::string_view example : examples) out << ".PP\n" << roff(example) << '\n';
    return out.str();
}

}  // namespace dem::shapegen
