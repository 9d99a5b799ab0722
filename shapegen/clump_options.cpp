// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump_options.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "common/units.hpp"
#include "shapegen/option_values.hpp"

#include <algorithm>

namespace dem {

namespace {

namespace po = boost::program_options;

constexpr std::int64_t fewest_voxels = 10;
constexpr std::int64_t most_voxels = 500;

ClumpGoal read_goal(const po::variables_map& values) {
    ClumpGoal goal;
    if (is_given(values, "clump"))
        goal.coverage = fraction_option(values, "clump", 0.0, 1.0,
                                        "a coverage above 0 and below 1 (0.95 or 95%)");
    if (is_given(values, "clump-spheres"))
        goal.count = static_cast<std::size_t>(whole_number(
            values, "clump-spheres", 1, static_cast<std::int64_t>(Clump::most_spheres)));
    if (is_given(values, "clump-error")) {
        const std::string expected =
            "an RMS deviation above 0% and below 100% of the equivalent diameter (0.5%)";
        const auto words = values["clump-error"].as<std::string>();
        if (!words.ends_with('%'))
            throw UsageError("--clump-error",
                             "found " + in_quotes(words) + ", expected " + expected);
        goal.rms_deviation = fraction_option(values, "clump-error", 0.0, 1.0, expected);
    }
    return goal;
}

/// A share of d_eq or a length.
void read_min_radius(const po::variables_map& values, ClumpRequest& request) {
    const auto words = values["min-radius"].as<std::string>();
    if (words.ends_with('%')) {
        request.options.min_radius =
            fraction_option(values, "min-radius", 0.0, 0.5,
                            "above 0 and below 50 % of the equivalent diameter, or a length");
        return;
    }
    if (finite_number(words))
        throw UsageError("--min-radius", "found " + in_quotes(words) +
                                             ", expected a length with its unit (0.2 mm) or a "
                                             "percentage of the equivalent diameter (2%)");
    try {
        request.min_radius = parse_quantity(words, Dimension::length);
    } catch (const Error& error) {
        throw UsageError("--min-radius", error.what());
    }
    if (!(request.min_radius > 0.0))
        throw UsageError("--min-radius",
                         "found " + in_quotes(words) + ", expected a length above 0");
}

Skeleton read_skeleton(const po::variables_map& values) {
    const auto words = values["skeleton"].as<std::string>();
    if (words == "surface") return Skeleton::surface;
    if (words == "curve") return Skeleton::curve;
    throw UsageError("--skeleton", "found " + in_quotes(words) + ", expected surface or curve");
}

/// Voxels per d_eq. Where the user gives none 60, and for a high coverage 100: there 60 take up to
/// 9 % more spheres or do not reach it, and finer ones save 4 % at most (docs/clumps.md).
double read_resolution(const po::variables_map& values, const ClumpGoal& goal) {
    constexpr double high_coverage = 0.9;
    if (is_given(values, "resolution"))
        return static_cast<double>(whole_number(values, "resolution", fewest_voxels, most_voxels));
    const bool wants_coverage = goal.count == 0 && goal.rms_deviation == 0.0;
    return wants_coverage && goal.coverage >= high_coverage ? 100.0 : 60.0;
}

ClumpRequest read_request(const po::variables_map& values) {
    ClumpRequest request;
    request.goal = read_goal(values);
    ClumpOptions& options = request.options;
    options.is_inscribed = values.count("inscribed") != 0;
    if (is_given(values, "protrusion")) {
        if (options.is_inscribed)
            throw UsageError("command line",
                             "found --inscribed and --protrusion, expected one of them");
        options.protrusion =
            fraction_option(values, "protrusion", -1e-300, 0.5,
                            "0 or more and below 50 % of the equivalent diameter (1%)");
    }
    if (is_given(values, "min-radius")) read_min_radius(values, request);
    options.skeleton = read_skeleton(values);
    options.per_diameter = read_resolution(values, request.goal);
    // Coverage needs cells finer than the voxels that candidates come from, and much finer ones
    // where nothing but coverage counts.
    const double per_voxel = options.is_inscribed ? 3.2 : 1.6;
    options.cells_per_diameter = std::clamp(per_voxel * options.per_diameter,
                                            std::min(4.0 * options.per_diameter, 160.0), 320.0);
    return request;
}

}  // namespace

po::options_description clump_options() {
    po::options_description options("Clumps of spheres (docs/clumps.md)");
    options.add_options()("clump", text("C"), "spheres that cover this much of the volume: 0.95")(
        "clump-spheres", text("N"), "this many spheres")(
        "clump-error", text("E%"),
        "as few spheres as keep the RMS deviation of the surface below E % of the equivalent "
        "diameter d_eq")("inscribed", "no sphere leaves the body: leaves out the fit")(
        "protrusion", text("P%")->default_value("1%"),
        "how far a fitted sphere may stand out, of d_eq")(
        "min-radius", text("R"), "no smaller spheres: '0.2 mm', or '2%' of d_eq")(
        "skeleton", text("KIND")->default_value("surface"),
        "surface, or curve for long thin bodies: where spheres are sought first")(
        "resolution", text("N"),
        "voxels per d_eq for the skeleton; default: 60, for a --clump of 0.9 or more 100, which is "
        "good for more than a few hundred spheres in the other modes, too")(
        "convergence", text("FILE"),
        "also write what 1, 2, 3, 4, 6, ... spheres reach: .csv table or .svg plot");
    return options;
}

std::vector<std::string> clump_modes() {
    return {"clump", "clump-spheres", "clump-error"};
}

std::optional<ClumpCommand> read_clump_options(const po::variables_map& values) {
    std::string chosen;
    for (const std::string& mode : clump_modes()) {
        if (!is_given(values, mode)) continue;
        if (!chosen.empty()) {
            std::string found = "found --";
            found.append(chosen).append(" and --").append(mode).append(", expected one of them");
            throw UsageError("command line", found);
        }
        chosen = mode;
    }
    if (chosen.empty()) {
        for (const char* option :
             {"inscribed", "protrusion", "min-radius", "skeleton", "resolution", "convergence"})
            if (is_given(values, option))
                throw UsageError("--" + std::string(option),
                                 "found it without --clump, --clump-spheres or --clump-error, "
                                 "expected one of them");
        return std::nullopt;
    }
    ClumpCommand command;
    command.request = read_request(values);
    if (is_given(values, "convergence")) {
        command.convergence = values["convergence"].as<std::string>();
        const std::string extension = command.convergence.extension().string();
        if (extension != ".csv" && extension != ".svg")
            throw UsageError("--convergence", "found the extension " + in_quotes(extension) +
                                                  ", expected .csv or .svg");
    }
    return command;
}

}  // namespace dem
