// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/clump/build_clump.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace dem::shapegen {

/// What a number of spheres reaches.
struct ConvergenceRow {
    std::size_t spheres;
    ClumpQuality quality;
};

/// Clumps of 1, 2, 3, 4, 6, 8, 12, 16, ... and `most` spheres, each made anew.
std::vector<ConvergenceRow> convergence(ClumpMaker& maker, std::size_t most);

/// One row per clump, a header row; the columns are those of the certificate.
std::string convergence_csv(const std::vector<ConvergenceRow>& rows);

}  // namespace dem::shapegen
