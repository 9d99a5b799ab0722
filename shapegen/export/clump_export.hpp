// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/export/input_frame.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Clumps for other programs. Files are written beside and renamed; throws Error when that fails or
/// the shape is no clump. `density` [kg/m^3] makes masses of shares.
namespace dem::shapegen {

/// `x,y,z,radius,mass` of each sphere, a header row, in the frame of the input; masses per unit
/// density in cubes of the unit of length, which add up to the volume of the input.
void write_clump_csv(const std::filesystem::path& path, const ParticleTemplate& shape,
                     const InputFrame& frame);

/// Codes whose clump files are written: "liggghts", "lammps", "yade", "mercurydpm", "dem-engine".
const std::vector<std::string>& clump_formats();

/// The file of another code, in SI units and the body frame: origin at the center of mass, axes
/// those of inertia. What the code takes from its input script instead stands in comments at the
/// head (docs/clumps.md). "mercurydpm" is a folder. Throws UsageError for an unknown format.
void write_clump_file(const std::filesystem::path& path, const ParticleTemplate& shape,
                      const std::string& format, double density);

}  // namespace dem::shapegen
