// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/load_mesh.hpp"

#include "common/error.hpp"
#include "common/units.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/profile/shape_parameters.hpp"
#include "shapegen/repair/face_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace dem::shapegen {
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

/// Lengths that a template can hold.
void check_size(const TriangleSoup& soup) {
    Aabb box;
    for (const auto& triangle : soup.triangles)
        for (const std::uint32_t corner : triangle) box.extend(soup.points[corner]);
    const double size = (box.upper - box.lower).maxCoeff();
    const double farthest =
        std::max(box.upper.cwiseAbs().maxCoeff(), box.lower.cwiseAbs().maxCoeff());
    if (size >= least_length && farthest <= most_length) return;
    std::ostringstream words;
    words << "found a mesh of " << size << " m up to " << farthest
          << " m from the origin, expected from 1e-12 to 1e6 m; see --unit and --scale";
    throw Error(words.str());
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
    const std::vector<std::string> notes = std::move(file.soup.notes);

    constexpr double reading = 0.05;  // of the time
    const RepairOptions repair_options{.limit = options.repair_limit,
                                       .keep_largest = options.keep_largest,
                                       .unite = options.unite,
                                       .file_unit = file_unit,
                                       .progress = [&](double done, std::string_view next) {
                                           stage(reading + (1.0 - reading) * done, next);
                                       }};
    LoadedMesh result;
    try {
        RepairReport report;
        TriangleSoup soup = face_triangles(std::move(file.soup), report);
        for (Vec3& point : soup.points) point *= file_unit;
        for (Finding& finding : report.findings) finding.place *= file_unit;
        check_size(soup);
        RepairedMesh repaired = repair(std::move(soup), repair_options, std::move(report));
        result.mesh = std::move(repaired.mesh);
        result.report = std::move(repaired.report);
        result.unit = file_unit;
    } catch (const Error& error) {
        throw Error(path.string(), error.what());
    }
    result.lines.push_back(size_line(result.mesh, options, unit));
    for (std::string& line : describe(result.report, file_unit))
        result.lines.push_back(std::move(line));
    result.lines.insert(result.lines.end(), notes.begin(), notes.end());
    return result;
}

}  // namespace dem::shapegen
