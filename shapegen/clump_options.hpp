// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/pipeline/cook_clump.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <boost/program_options.hpp>

namespace dem {

/// `--clump ...`, `--clump-spheres ...` or `--clump-error ...`, and what goes with them.
struct ClumpCommand {
    ClumpRequest request;
    std::filesystem::path convergence;  ///< "": none asked for
};

/// For `--help` and the parser.
boost::program_options::options_description clump_options();

/// Names of the options that choose the kind of a clump's goal, as they are typed.
std::vector<std::string> clump_modes();

/// Nothing when no clump is asked for. Throws UsageError: two goals, a value out of range, an
/// option of clumps without one.
std::optional<ClumpCommand> read_clump_options(const boost::program_options::variables_map& values);

}  // namespace dem
