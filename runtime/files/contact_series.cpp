// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/contact_series.hpp"

#include <array>
#include <numeric>

namespace dem::runtime {

namespace {

constexpr std::array contact_tables = {
    "particle_i", "particle_j", "wall",         "slips",          "point",   "normal", "force",
    "friction",   "velocity",   "normal_force", "friction_limit", "overlap", "ends",   "lines"};

XdmfGrid write_contacts(FrameTables& tables, const ContactTable& contacts) {
    XdmfGrid grid;
    grid.time = contacts.time;
    const auto flag = [&](const char* name, const std::vector<std::uint32_t>& values) {
        grid.attributes.push_back({name, "Scalar", "Cell", tables.add(name, values)});
    };
    const auto vector = [&](const char* name, const std::vector<double>& values,
                            const char* units) {
        grid.attributes.push_back({name, "Vector", "Cell", tables.add(name, values, 3, units)});
    };
    const auto scalar = [&](const char* name, const std::vector<double>& values,
                            const char* units) {
        grid.attributes.push_back({name, "Scalar", "Cell", tables.add(name, values, 1, units)});
    };
    flag("particle_i", contacts.i);
    flag("particle_j", contacts.j);
    flag("wall", contacts.wall);
    flag("slips", contacts.slips);
    vector("point", contacts.point, "m");
    vector("normal", contacts.normal, "1");
    vector("force", contacts.force, "N");
    vector("friction", contacts.friction, "N");
    vector("velocity", contacts.velocity, "m/s");
    scalar("normal_force", contacts.normal_force, "N");
    scalar("friction_limit", contacts.friction_limit, "N");
    scalar("overlap", contacts.overlap, "m");
    std::vector<std::uint32_t> ends(2 * contacts.size());
    std::iota(ends.begin(), ends.end(), 0U);
    grid.cells = tables.add("ends", ends, 2);
    grid.points = tables.add("lines", contacts.lines, 3, "m");
    return grid;
}

}  // namespace

ContactWriter::ContactWriter(const std::filesystem::path& directory,
                             std::span<const std::string> walls, std::uint64_t frames)
    : series_(directory,
              {"contacts", contact_tables, [&](Hdf5File& file) { file.write("/walls", walls); }},
              frames) {}

void ContactWriter::append(const ContactTable& contacts, const std::string& frame_name) {
    series_.append(frame_name,
                   [&](FrameTables& tables) { return write_contacts(tables, contacts); });
}

}  // namespace dem::runtime
