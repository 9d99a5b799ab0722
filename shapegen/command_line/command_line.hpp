// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/clump_options.hpp"
#include "shapegen/command_line/convex_options.hpp"
#include "shapegen/pipeline/cook.hpp"
#include "shapegen/pipeline/cook_wall.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <variant>

namespace dem::shapegen {

/// `shapegen INPUT ...`
struct CookCommand {
    std::filesystem::path input, output;
    /// What is made of the input: a surface of revolution or a sphere, a clump, a convex shape, a
    /// wall.
    std::variant<CookOptions, ClumpCommand, ConvexRequest, WallRequest> recipe;
    MeshLoadOptions mesh;
    bool is_quiet = false;
    int threads = 0;   ///< at most; 0: one per core
    std::string text;  ///< the command line without --threads, kept in the template
};

/// `shapegen inspect FILE.tpl [--json]`
struct InspectCommand {
    std::filesystem::path input;
    bool as_json = false;
};

/// `shapegen export FILE.tpl -o FILE.{svg,stl,obj,vtu,csv}` or `... -o FILE --format CODE`
struct ExportCommand {
    std::filesystem::path input, output;
    std::string shape;           ///< name or index; "" when the file holds one shape
    std::string format;          ///< of another code; "": by the extension of the output
    double density = 1e3;        ///< for the masses of other codes [kg/m^3]
    std::optional<double> unit;  ///< of lengths [m]; none: the input's
};

/// `--help`, `--man` or `--version`: words for stdout.
struct PrintCommand {
    std::string text;
};

using Command =
    std::variant<CookCommand, GenerateCommand, InspectCommand, ExportCommand, PrintCommand>;

/// Throws UsageError with one line that says what was found and what was expected.
Command parse_command_line(std::span<const char* const> arguments);

}  // namespace dem::shapegen
