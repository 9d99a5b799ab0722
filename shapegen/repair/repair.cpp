// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/repair.hpp"

#include "common/error.hpp"
#include "shapegen/repair/duplicates.hpp"
#include "shapegen/repair/holes.hpp"
#include "shapegen/repair/oriented_surface.hpp"
#include "shapegen/repair/self_intersections.hpp"
#include "shapegen/repair/shells.hpp"
#include "shapegen/repair/soup_cleaning.hpp"
#include "shapegen/repair/t_junctions.hpp"
#include "shapegen/repair/touching_parts.hpp"
#include "shapegen/repair/unite_parts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace dem::shapegen {
namespace {

/// What rounding to single precision or to six digits moves a point by, at most.
double rounding_distance(const TriangleSoup& soup) {
    Aabb box;
    for (const Vec3& p : soup.points) box.extend(p);
    const double magnitude =
        std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    return std::max(1e-6 * (box.upper - box.lower).norm(), 2.5e-7 * magnitude);
}

void clean(TriangleSoup& soup, RepairReport& report) {
    share_points(soup);
    remove_collapsed(soup, report);
    remove_duplicates(soup, report);
    const double distance = rounding_distance(soup);
    close_cracks(soup, distance, report);
    split_at_t_junctions(soup, distance, report);
    remove_collapsed(soup, report);
    remove_duplicates(soup, report);
    part_touching_bodies(soup, report);
    if (soup.triangles.empty())
        throw Error("found no triangles with an area, expected a closed surface");
}

[[noreturn]] void refuse(const std::vector<Finding>& refused, const RepairOptions& options,
                         double volume) {
    std::string message = "found ";
    for (const Finding& finding : refused)
        message +=
            (&finding == refused.data() ? "" : "; ") + describe(finding, options.file_unit, volume);
    if (!(volume > 0.0)) message += "; the surface encloses no volume";
    throw Error(message);
}

void check_limit(const RepairReport& report, const RepairOptions& options) {
    if (report.changed_fraction() <= options.limit) return;
    std::string message = "found ";
    std::string_view separator;
    for (const Finding& finding : report.findings) {
        if (finding.volume == 0.0) continue;
        message += separator;
        message += describe(finding, options.file_unit, report.volume);
        separator = "; ";
    }
    throw Error(message + "; expected at most " + percentage(options.limit) + " (--repair-limit)");
}

}  // namespace

RepairedMesh repair(TriangleSoup soup, const RepairOptions& options, RepairReport before) {
    const auto stage = [&options](double done, std::string_view next) {
        if (options.progress) options.progress(done, next);
    };
    // The parts of the time that the stages take for two million triangles.
    RepairedMesh result{{}, std::move(before)};
    RepairReport& report = result.report;
    stage(0.0, "joining triangles");
    // Parts that the file tells apart are not to be joined where they touch.
    if (!options.unite || !has_closed_parts(soup)) clean(soup, report);
    stage(0.32, "orienting triangles");
    SurfaceMesh surface = oriented_surface(soup, report);
    soup = {};
    stage(0.6, "closing holes");
    std::vector<Finding> refused = close_holes(surface, options.limit, report);
    std::ranges::move(remove_flat_triangles(surface, report), std::back_inserter(refused));
    stage(0.62, "looking for crossing triangles");
    if (refused.empty() && options.unite) {
        refused = unite_parts(surface, report);
        std::ranges::move(remove_flat_triangles(surface, report), std::back_inserter(refused));
    }
    std::ranges::move(refused.empty() ? remove_self_intersections(surface, report)
                                      : self_intersections(surface).findings(),
                      std::back_inserter(refused));
    stage(0.98, "sorting shells");
    if (refused.empty()) {
        result.mesh = triangle_mesh(surface);
        refused = keep_one_body(result.mesh, {options.limit, options.keep_largest}, report);
    }
    if (!refused.empty()) refuse(refused, options, report.volume);
    check_limit(report, options);
    stage(1.0, "repaired");
    return result;
}

}  // namespace dem::shapegen
