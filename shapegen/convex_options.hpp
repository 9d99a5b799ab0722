// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/convex/granular.hpp"
#include "shapegen/pipeline/cook_convex.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <boost/program_options.hpp>

namespace dem {

/// `shapegen generate sand|woodchips ...`
struct GenerateCommand {
    GranularOptions grains;
    std::uint64_t count = 0;
    std::filesystem::path output;
    bool is_quiet = false;
    int threads = 0;   ///< at most; 0: one per core
    std::string text;  ///< the command line without --threads, kept in the template
};

/// For `--help` and the parser.
boost::program_options::options_description convex_options();
boost::program_options::options_description generate_options();

/// Nothing when no convex shape is asked for: neither --convex nor a `.convex` file. Throws
/// UsageError: a value out of range, an option of convex shapes without one.
std::optional<ConvexRequest> read_convex_options(
    const boost::program_options::variables_map& values, const std::filesystem::path& input);

/// `kind`: what was typed after `generate`. The text is left empty. Throws UsageError.
GenerateCommand read_generate_options(const boost::program_options::variables_map& values,
                                      const std::string& kind);

}  // namespace dem
