// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/option_values.hpp"
#include "shapegen/pipeline/cook_clump.hpp"

#include <filesystem>
#include <optional>

namespace dem::shapegen {

/// `--clump ...`, `--clump-spheres ...` or `--clump-error ...`, and what goes with them.
struct ClumpCommand {
    ClumpRequest request;
    std::filesystem::path convergence;  ///< "": none asked for
};

/// Nothing when no clump is asked for. Throws UsageError for a value out of range.
std::optional<ClumpCommand> read_clump_options(const OptionValues& values);

}  // namespace dem::shapegen
