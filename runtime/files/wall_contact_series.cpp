// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/wall_contact_series.hpp"

#include <array>

namespace dem::runtime {

namespace {

constexpr std::array wall_contact_tables = {"points",         "pressure",     "shear",
                                            "friction_power", "sliding_work", "impact_energy"};

void write_walls(Hdf5File& file, const WallTriangles& walls) {
    file.write("/walls", walls.names);
    file.write("/triangles", walls.triangles, 3);
    file.write("/wall", walls.wall);
    file.write("/area", walls.area);
    file.describe("/area", "units", std::string_view("m^2"));
}

}  // namespace

WallContactWriter::WallContactWriter(const std::filesystem::path& directory,
                                     const WallTriangles& walls, std::uint64_t frames)
    : series_(
          directory,
          {"wall_contacts", wall_contact_tables, [&](Hdf5File& file) { write_walls(file, walls); }},
          frames),
      triangles_{"wall_contacts.h5:/triangles", walls.wall.size(), 3, "UInt", 4},
      wall_{"wall_contacts.h5:/wall", walls.wall.size(), 1, "UInt", 4} {}

void WallContactWriter::append(const WallContactTable& loads, const std::string& frame_name) {
    series_.append(frame_name, [&](FrameTables& tables) {
        XdmfGrid grid;
        grid.time = loads.time;
        grid.cells = triangles_;
        grid.points = tables.add("points", loads.points, 3, "m");
        grid.attributes = {{"wall", "Scalar", "Cell", wall_}};
        const auto add = [&](const char* name, const std::vector<double>& values,
                             const char* units) {
            grid.attributes.push_back({name, "Scalar", "Cell", tables.add(name, values, 1, units)});
        };
        add("pressure", loads.pressure, "Pa");
        add("shear", loads.shear, "Pa");
        add("friction_power", loads.friction_power, "W/m^2");
        add("sliding_work", loads.sliding_work, "J/m^2");
        add("impact_energy", loads.impact_energy, "J/m^2");
        return grid;
    });
}

}  // namespace dem::runtime
