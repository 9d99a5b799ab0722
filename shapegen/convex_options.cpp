// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/convex_options.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "common/units.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/option_values.hpp"
#include "shapegen/profile/shape_parameters.hpp"

namespace dem {

namespace {

namespace po = boost::program_options;

constexpr std::int64_t most_vertices = 100'000;
constexpr std::int64_t most_grains = 1'000'000'000;

std::optional<Rounding> read_rounding(const po::variables_map& values) {
    if (values.count("rounding") == 0) return std::nullopt;
    try {
        return parse_rounding(values["rounding"].as<std::string>(), 0.0);
    } catch (const Error& problem) {
        throw UsageError("--rounding", problem.what());
    }
}

double read_size(const std::string& words) {
    double size = 0.0;
    if (words.find_first_not_of("+-.0123456789eE") == std::string::npos)
        throw UsageError("--size",
                         "found " + in_quotes(words) + ", expected a length with its unit (5 mm)");
    try {
        size = parse_quantity(words, Dimension::length);
    } catch (const Error& problem) {
        throw UsageError("--size", problem.what());
    }
    if (!(size > 0.0))
        throw UsageError("--size", "found " + in_quotes(words) + ", expected above 0");
    if (size < least_length || size > most_length)
        throw UsageError("--size", "found " + in_quotes(words) + ", expected from 1e-12 to 1e6 m");
    return size;
}

}  // namespace

po::options_description convex_options() {
    po::options_description options("Convex shapes (docs/convex-file.md)");
    options.add_options()("convex",
                          "the hull of a mesh, or a profile that is a sphere, spheroid, cylinder, "
                          "cone or spherocylinder; not needed for a .convex file")(
        "vertices", text("N"), "of a mesh's hull keep N vertices, those that matter most")(
        "keep-volume",
        "scale what the hull, --vertices and the rounding leave to the volume of the "
        "mesh")("rounding", text("R"),
                "radius of edges and corners: '0.1 mm', or '1%' of d_eq, which is the default");
    return options;
}

po::options_description generate_options() {
    po::options_description options("Generating");
    options.add_options()("count", text("N"), "how many shapes, no two alike")(
        "seed", text("S")->default_value("1"),
        "another seed, other shapes; a longer library begins with the shapes of a shorter one")(
        "template", text("BASE"), "sand: corners on a sphere (default) or an ellipsoid")(
        "size", text("D"),
        "sand: diameter of the sphere, or of the sphere of the ellipsoid's volume (5 mm); "
        "woodchips: mean length (6 mm)")("rounding", text("R"),
                                         "of edges and corners: '0.1 mm', or '1%' of d_eq")(
        "output,o", text("OUT.tpl"), "the library to write")("quiet,q", "print nothing but errors");
    return options;
}

std::optional<ConvexRequest> read_convex_options(const po::variables_map& values,
                                                 const std::filesystem::path& input) {
    const bool is_mesh = is_mesh_file(input);
    if (values.count("convex") == 0 && !is_convex_file(input)) {
        for (const char* option : {"vertices", "keep-volume", "rounding"})
            if (values.count(option) != 0)
                throw UsageError("--" + std::string(option),
                                 "found it without --convex, expected both");
        return std::nullopt;
    }
    ConvexRequest request;
    request.rounding = read_rounding(values);
    for (const char* option : {"vertices", "keep-volume"})
        if (values.count(option) != 0 && !is_mesh)
            throw UsageError("--" + std::string(option),
                             "found it with " + input.string() + ", expected it with a mesh");
    if (values.count("vertices") != 0)
        request.vertices =
            static_cast<std::size_t>(whole_number(values, "vertices", 4, most_vertices));
    request.keeps_volume = values.count("keep-volume") != 0;
    return request;
}

GenerateCommand read_generate_options(const po::variables_map& values, const std::string& kind) {
    GenerateCommand command;
    GranularOptions& grains = command.grains;
    const bool is_sand = kind == "sand";
    if (!is_sand && kind != "woodchips")
        throw UsageError("generate", "found " + in_quotes(kind) + ", expected sand or woodchips");
    grains.kind = is_sand ? GranularOptions::Kind::sand : GranularOptions::Kind::woodchips;
    grains.size = is_sand ? 5e-3 : 6e-3;
    for (const char* option : {"count", "output"})
        if (values.count(option) == 0)
            throw UsageError("generate", "found no --" + std::string(option) + ", expected " +
                                             "--count N and -o OUT.tpl");
    command.count = static_cast<std::uint64_t>(whole_number(values, "count", 1, most_grains));
    grains.seed = static_cast<std::uint64_t>(whole_number(values, "seed", 0, INT64_MAX));
    if (values.count("template") != 0) {
        const auto base = values["template"].as<std::string>();
        if (!is_sand)
            throw UsageError("--template", "found it with woodchips, expected it with sand");
        if (base != "sphere" && base != "ellipsoid")
            throw UsageError("--template",
                             "found " + in_quotes(base) + ", expected sphere or ellipsoid");
        if (base == "ellipsoid") grains.base = GranularOptions::Base::ellipsoid;
    }
    if (values.count("size") != 0) grains.size = read_size(values["size"].as<std::string>());
    grains.rounding = read_rounding(values);
    command.output = template_output(values);
    command.is_quiet = values.count("quiet") != 0;
    return command;
}

}  // namespace dem
