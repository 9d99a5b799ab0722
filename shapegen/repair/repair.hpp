// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/progress.hpp"
#include "shapegen/mesh/triangle_mesh.hpp"
#include "shapegen/repair/repair_report.hpp"
#include "shapegen/repair/triangle_soup.hpp"

#include <functional>
#include <string_view>

namespace dem::shapegen {

struct RepairOptions {
    double limit = 0.01;        ///< largest fraction of the volume that repairs may put at stake
    bool keep_largest = false;  ///< of several bodies
    bool unite = false;         ///< parts that cross, touch or hold each other
    double file_unit = 1.0;     ///< meters per coordinate of the file, for places in messages
    StageProgress progress = nullptr;  ///< may be empty
};

struct RepairedMesh {
    TriangleMesh mesh;
    RepairReport report;
};

/// The surface of one solid from the triangles of a file (docs/mesh-import.md): closed, manifold,
/// outward, not crossing itself. Everything that was changed is in the report. Throws Error with
/// one line that lists all that could not be repaired, or not within the limit. `report`: what was
/// found before.
RepairedMesh repair(TriangleSoup soup, const RepairOptions& options = {}, RepairReport report = {});

}  // namespace dem::shapegen
