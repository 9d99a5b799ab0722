// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/repair.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace dem::shapegen {

struct MeshLoadOptions {
    /// Unit of the file's coordinates: m, mm, um, cm, in. "": meters for glTF, which says so, and
    /// millimeters for the others, which say nothing.
    std::string unit;
    double scale = 1.0;  ///< all lengths are multiplied by it
    double repair_limit = 0.01;
    bool keep_largest = false;
    bool unite = false;                ///< parts that cross, touch or hold each other
    StageProgress progress = nullptr;  ///< may be empty
};

struct LoadedMesh {
    TriangleMesh mesh;
    RepairReport report;
    double unit = 1.0;  ///< of the file's coordinates, times the scale [m]
    /// For the user: size and unit (a wrong unit shows there and nowhere else), what was repaired,
    /// what was ignored.
    std::vector<std::string> lines;
};

/// Reads and repairs a mesh. Throws Error that begins with the path.
LoadedMesh load_mesh(const std::filesystem::path& path, const MeshLoadOptions& options = {});

}  // namespace dem::shapegen
