// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/convex_options.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"

namespace dem::shapegen {

namespace {

std::optional<Rounding> read_rounding(const OptionValues& values) {
    if (!values.given("rounding")) return std::nullopt;
    try {
        return parse_rounding(values.text("rounding"), 0.0);
    } catch (const Error& problem) {
        throw UsageError("--rounding", problem.what());
    }
}

}  // namespace

std::optional<ConvexRequest> read_convex_options(const OptionValues& values,
                                                 const std::filesystem::path& input) {
    if (!values.given("convex") && !is_convex_file(input)) return std::nullopt;
    ConvexRequest request;
    request.rounding = read_rounding(values);
    if (values.given("vertices"))
        request.vertices = static_cast<std::size_t>(values.count("vertices"));
    request.keeps_volume = values.given("keep-volume");
    return request;
}

GenerateCommand read_generate_options(const OptionValues& values, const std::string& kind) {
    GenerateCommand command;
    GranularOptions& grains = command.grains;
    const bool is_sand = kind == "sand";
    if (!is_sand && kind != "woodchips")
        throw UsageError("generate", "found " + in_quotes(kind) + ", expected sand or woodchips");
    values.check("", kind);
    grains.kind = is_sand ? GranularOptions::Kind::sand : GranularOptions::Kind::woodchips;
    grains.size = is_sand ? 5e-3 : 6e-3;
    command.count = static_cast<std::uint64_t>(values.count("count"));
    grains.seed = static_cast<std::uint64_t>(values.count("seed"));
    if (values.given("template")) {
        if (!is_sand)
            throw UsageError("--template", "found it with woodchips, expected it with sand");
        if (values.choice("template") == "ellipsoid")
            grains.base = GranularOptions::Base::ellipsoid;
    }
    if (values.given("size")) {
        if (finite_number(values.text("size")))
            throw UsageError("--size", "found " + in_quotes(values.text("size")) +
                                           ", expected a length with its unit (5 mm)");
        grains.size = values.quantity("size");
    }
    grains.rounding = read_rounding(values);
    command.output = values.template_output();
    command.is_quiet = values.given("quiet");
    return command;
}

}  // namespace dem::shapegen
