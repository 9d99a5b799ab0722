// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/progress.hpp"
#include "shapegen/convex/granular.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace dem::shapegen {

/// A library of grains, each of its own shape.
struct LibraryRequest {
    GranularOptions grains;
    std::uint64_t count = 1;
    std::string command;  ///< kept in the template
    StageProgress progress;
};

struct LibrarySummary {
    double smallest = 0.0, largest = 0.0, mean = 0.0;  ///< volume [m^3]
    double mean_vertices = 0.0;
    double surface_deviation = 0.0;  ///< largest, of the rounded from the drawn body [d_eq]
    std::uint64_t redrawn = 0;       ///< slivers that were drawn again
};

/// Makes the grains in all threads, some thousands at a time, and writes them: the same bytes for
/// any number of threads. Throws Error before most of the work where the 2 GB of a template would
/// not hold them, and says how many it would.
LibrarySummary generate_library(const LibraryRequest& request, const std::filesystem::path& path);

}  // namespace dem::shapegen
