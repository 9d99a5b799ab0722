// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/cook_wall.hpp"

#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "common/format.hpp"
#include "common/units.hpp"
#include "formats/memory_map.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/repair/face_triangles.hpp"
#include "shapegen/repair/soup_cleaning.hpp"
#include "shapegen/repair/t_junctions.hpp"
#include "shapegen/wall/make_wall.hpp"

#include <algorithm>
#include <utility>

namespace dem::shapegen {

namespace {

/// What single precision leaves of coordinates: open points this near to an open edge lie on it.
double rounding_distance(const TriangleSoup& soup) {
    double magnitude = 0.0;
    for (const Vec3& p : soup.points) magnitude = std::max(magnitude, p.cwiseAbs().maxCoeff());
    return 2.5e-7 * magnitude;
}

/// Lengths that a template can hold.
void check_size(const TriangleSoup& soup, double file_unit) {
    double farthest = 0.0;
    for (const Vec3& p : soup.points) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    constexpr double most = 1e6;  // [m]
    if (farthest * file_unit <= most) return;
    throw Error(
        format("found coordinates of up to %.3g m, expected at most 1e6 m; see --unit "
               "and --scale",
               farthest * file_unit));
}

std::vector<std::string> lines_of(const MadeWall& made, const MeshLoadOptions& options,
                                  const std::string& unit) {
    const double meters = unit_factor(unit, Dimension::length);
    const Vec3 size = (made.mesh.bounds.upper - made.mesh.bounds.lower) / meters;
    const WallReport& r = made.report;
    std::vector<std::string> lines;
    lines.push_back(format("wall of %zu triangles, %.6g x %.6g x %.6g %s%s",
                           made.mesh.triangles.size(), size.x(), size.y(), size.z(), unit.c_str(),
                           !options.unit.empty() ? ""
                           : unit == "m"         ? " (the format's unit)"
                                                 : " (assumed; --unit says otherwise)"));
    if (r.repeated > 0)
        lines.push_back(format("triangles that repeat others: %zu, left out", r.repeated));
    if (r.turned > 0)
        lines.push_back(
            format("triangles that faced the other way than their neighbors: %zu, "
                   "turned round; a wall is touched from both sides",
                   r.turned));
    if (r.seams > 0)
        lines.push_back(
            format("edges across which no front goes on: %zu, taken as creases", r.seams));
    return lines;
}

Certificate certificate_of(const MadeWall& made) {
    const WallReport& r = made.report;
    const auto number = [](std::size_t n) { return static_cast<double>(n); };
    return {{"area", r.area},
            {"pieces", number(r.pieces)},
            {"patches", number(made.mesh.blends.size())},
            {"rim_edges", number(r.rim_edges)},
            {"joint_edges", number(r.joints)},
            {"convex_edges", number(r.convex)},
            {"concave_edges", number(r.concave)},
            {"crease_edges", number(r.creases)}};
}

}  // namespace

CookedWall cook_wall(const std::filesystem::path& path, const WallRequest& request,
                     const MeshLoadOptions& options) {
    MeshFile file = read_mesh_file(path);
    std::string unit = options.unit;
    if (unit.empty()) unit = file.unit.empty() ? "mm" : file.unit;
    const double file_unit = unit_factor(unit, Dimension::length) * options.scale;
    const std::vector<std::string> notes = std::move(file.soup.notes);
    CookedWall cooked;
    cooked.hash = file_hash(MemoryMap(path, "mesh").bytes());
    cooked.wall.name = path.stem().string();
    cooked.wall.input_unit = file_unit;
    try {
        RepairReport report;
        TriangleSoup soup = face_triangles(std::move(file.soup), report);
        check_size(soup, file_unit);
        for (Vec3& point : soup.points) point *= file_unit;
        for (Finding& finding : report.findings) finding.place *= file_unit;
        share_points(soup);
        split_at_t_junctions(soup, rounding_distance(soup), report);
        MadeWall made = make_wall(soup, request.crease_angle);
        cooked.lines = lines_of(made, options, unit);
        for (const Finding& finding : report.findings)
            cooked.lines.push_back(describe(finding, file_unit, 0.0));
        cooked.wall.certificate = certificate_of(made);
        cooked.wall.mesh = std::move(made.mesh);
    } catch (const Error& error) {
        throw Error(path.string(), error.what());
    }
    cooked.lines.insert(cooked.lines.end(), notes.begin(), notes.end());
    return cooked;
}

}  // namespace dem::shapegen
