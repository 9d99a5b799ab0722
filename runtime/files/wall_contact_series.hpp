// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/frame_series.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dem::runtime {

/// The triangles of all walls that are made of triangles, one wall after the other.
struct WallTriangles {
    std::vector<std::string> names;        ///< of all walls of the case
    std::vector<std::uint32_t> triangles;  ///< 3 each: vertices
    std::vector<std::uint32_t> wall;       ///< per triangle: index into `names`
    std::vector<double> area;              ///< per triangle [m^2]
};

/// What contacts have done to them, one entry per triangle. The first three are means over the time
/// since the frame before, the last two sums since time 0 (walls/wall_loads.hpp).
struct WallContactTable {
    double time = 0.0;                   ///< [s]
    std::vector<float> points;           ///< 3 per vertex, where the walls are now [m]
    std::vector<double> pressure;        ///< normal force over area [Pa]
    std::vector<double> shear;           ///< friction over area [Pa]
    std::vector<double> friction_power;  ///< over area [W/m^2]
    std::vector<double> sliding_work;    ///< over area [J/m^2]
    std::vector<double> impact_energy;   ///< over area [J/m^2]
};

/// The loads of walls at every frame: wall_contacts.h5 and wall_contacts.xdmf.
class WallContactWriter {
  public:
    /// `frames`: as of a FrameSeries. Throws Error.
    WallContactWriter(const std::filesystem::path& directory, const WallTriangles& walls,
                      std::uint64_t frames);

    /// Throws Error.
    void append(const WallContactTable& loads, const std::string& frame_name);

    /// Lets the disk take all of it.
    void secure() { series_.secure(); }

  private:
    FrameSeries series_;
    XdmfTable triangles_, wall_;
};

}  // namespace dem::runtime
