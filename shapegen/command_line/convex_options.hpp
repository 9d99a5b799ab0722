// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/option_values.hpp"
#include "shapegen/convex/granular.hpp"
#include "shapegen/pipeline/cook_convex.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace dem::shapegen {

/// `shapegen generate sand|woodchips ...`
struct GenerateCommand {
    GranularOptions grains;
    std::uint64_t count = 0;
    std::filesystem::path output;
    bool is_quiet = false;
    int threads = 0;   ///< at most; 0: one per core
    std::string text;  ///< the command line without --threads, kept in the template
};

/// Nothing when no convex shape is asked for: neither --convex nor a `.convex` file. Throws
/// UsageError for a value out of range.
std::optional<ConvexRequest> read_convex_options(const OptionValues& values,
                                                 const std::filesystem::path& input);

/// `kind`: what was typed after `generate`. The text is left empty. Throws UsageError.
GenerateCommand read_generate_options(const OptionValues& values, const std::string& kind);

}  // namespace dem::shapegen
