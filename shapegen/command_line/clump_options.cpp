// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/clump_options.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "common/units.hpp"

#include <algorithm>

namespace dem::shapegen {

namespace {

ClumpGoal read_goal(const OptionValues& values) {
    ClumpGoal goal;
    if (values.given("clump")) goal.coverage = values.fraction("clump");
    if (values.given("clump-spheres"))
        goal.count = static_cast<std::size_t>(values.count("clump-spheres"));
    if (values.given("clump-error")) goal.rms_deviation = values.fraction("clump-error");
    return goal;
}

/// A share of d_eq or a length.
void read_min_radius(const OptionValues& values, ClumpRequest& request) {
    const std::string words = values.text("min-radius");
    if (words.ends_with('%')) {
        const auto percents = finite_number(words.substr(0, words.size() - 1));
        if (!percents || !(*percents > 0.0 && *percents < 50.0))
            throw UsageError("--min-radius",
                             "found " + in_quotes(words) +
                                 ", expected above 0 and below 50 % of the equivalent diameter, or "
                                 "a length");
        request.options.min_radius = *percents / 100.0;
        return;
    }
    if (finite_number(words)) values.refuse("min-radius");
    try {
        request.min_radius = parse_quantity(words, Dimension::length);
    } catch (const Error& error) {
        throw UsageError("--min-radius", error.what());
    }
    if (!(request.min_radius > 0.0))
        throw UsageError("--min-radius",
                         "found " + in_quotes(words) + ", expected a length above 0");
}

/// Voxels per d_eq. Where the user gives none 60, and for a high coverage 100: there 60 take up to
/// 9 % more spheres or do not reach it, and finer ones save 4 % at most (docs/clumps.md).
double read_resolution(const OptionValues& values, const ClumpGoal& goal) {
    constexpr double high_coverage = 0.9;
    if (values.given("resolution")) return static_cast<double>(values.count("resolution"));
    const bool wants_coverage = goal.count == 0 && goal.rms_deviation == 0.0;
    return wants_coverage && goal.coverage >= high_coverage ? 100.0 : 60.0;
}

ClumpRequest read_request(const OptionValues& values) {
    ClumpRequest request;
    request.goal = read_goal(values);
    ClumpOptions& options = request.options;
    options.is_inscribed = values.given("inscribed");
    if (values.given("protrusion")) options.protrusion = values.fraction("protrusion");
    if (values.given("min-radius")) read_min_radius(values, request);
    options.skeleton = values.choice("skeleton") == "curve" ? Skeleton::curve : Skeleton::surface;
    options.per_diameter = read_resolution(values, request.goal);
    // Coverage needs cells finer than the voxels that candidates come from, and much finer ones
    // where nothing but coverage counts.
    const double per_voxel = options.is_inscribed ? 3.2 : 1.6;
    options.cells_per_diameter = std::clamp(per_voxel * options.per_diameter,
                                            std::min(4.0 * options.per_diameter, 160.0), 320.0);
    return request;
}

}  // namespace

std::optional<ClumpCommand> read_clump_options(const OptionValues& values) {
    if (!values.given("clump") && !values.given("clump-spheres") && !values.given("clump-error"))
        return std::nullopt;
    ClumpCommand command;
    command.request = read_request(values);
    if (values.given("convergence")) {
        command.convergence = values.text("convergence");
        const std::string extension = command.convergence.extension().string();
        if (extension != ".csv" && extension != ".svg")
            throw UsageError("--convergence", "found the extension " + in_quotes(extension) +
                                                  ", expected .csv or .svg");
    }
    return command;
}

}  // namespace dem::shapegen
