// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/load_mesh.hpp"

#include "common/error.hpp"
#include "common/units.hpp"
#include "shapegen/import/mesh_file.hpp"

#include <cmath>
#include <sstream>
#include <utility>

namespace dem {
namespace {

std::string size_line(const TriangleMesh& mesh, const MeshLoadOptions& options,
                      const std::string& unit) {
    const Aabb box = bounding_box(mesh);
    const Vec3 size = (box.upper - box.lower) / unit_factor(unit, Dimension::length);
    std::ostringstream out;
    out << mesh.triangles.size() << " triangles, " << size.x() << " x " << size.y() << " x "
        << size.z() << ' ' << unit;
    if (options.unit.empty())
        out << (unit == "m" ? " (the format's unit)" : " (assumed; --unit says otherwise)");
    // Single-precision coordinates have seven digits.
    constexpr double far = 1e3;
    const double times = (0.5 * (box.lower + box.upper)).norm() / (box.upper - box.lower).norm();
    if (times > far)
        out << "; " << times
            << " times its size away from the origin, where files of single precision have lost "
               "the digits of the shape";
    return out.str();
}

}  // namespace

LoadedMesh load_mesh(const std::filesystem::path& path, const MeshLoadOptions& options) {
    if (!(options.scale > 0.0) || !std::isfinite(options.scale))
        throw Error("--scale",
                    "found " + std::to_string(options.scale) + ", expected a number above 0");
    const auto stage = [&options](double done, std::string_view next) {
        if (options.progress) options.progress(done, next);
    };
    stage(0.0, "reading");
    MeshFile file = read_mesh_file(path);
    std::string unit = options.unit;
    if (unit.empty()) unit = file.unit.empty() ? "mm" : file.unit;
    const double file_unit = unit_factor(unit, Dimension::length) * options.scale;
    for (Vec3& point : file.soup.points) point *= file_unit;

    constexpr double reading = 0.05;  // of the time
    const RepairOptions repair_options{.limit = options.repair_limit,
                                       .keep_largest = options.keep_largest,
                                       .file_unit = file_unit,
                                       .progress = [&](double done, std::string_view next) {
                                           stage(reading + (1.0 - reading) * done, next);
                                       }};
    LoadedMesh result;
    try {
        RepairedMesh repaired = repair(std::move(file.soup), repair_options);
        result.mesh = std::move(repaired.mesh);
        result.report = std::move(repaired.report);
        result.unit = file_unit;
    } catch (const Error& error) {
        throw Error(path.string(), error.what());
    }
    result.lines.push_back(size_line(result.mesh, options, unit));
    for (std::string& line : describe(result.report, file_unit))
        result.lines.push_back(std::move(line));
    for (std::string& note : file.notes) result.lines.push_back(std::move(note));
    return result;
}

}  // namespace dem
