// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/error.hpp"
#include "shapegen/import/load_mesh.hpp"
#include "tests/shapegen/repair/closed_surface.hpp"

#include <algorithm>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

// Every file of the collections that data/fetch-meshes gets becomes the surface of a body or gives
// one clear line. The outcome is written to mesh-collections.md in the build folder, which is what
// docs/mesh-collections.md holds.

namespace dem::shapegen {
namespace {

namespace fs = std::filesystem;

const fs::path collections = fs::path(DEM_SOURCE_DIR) / "data/meshes/full";

std::vector<fs::path> mesh_files(const fs::path& folder) {
    static const std::set<std::string> extensions{".stl", ".off", ".ply"};
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (extensions.contains(entry.path().extension().string())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

struct Outcome {
    bool is_loaded = false;
    std::string text;
};

Outcome outcome_of(const fs::path& path) {
    try {
        const LoadedMesh loaded = load_mesh(path);
        EXPECT_TRUE(is_closed_and_oriented(loaded.mesh)) << path;
        EXPECT_GT(loaded.report.volume, 0.0) << path;
        EXPECT_NEAR(enclosed_volume(loaded.mesh) / loaded.report.volume, 1.0, 1e-9) << path;
        EXPECT_LE(loaded.report.changed_fraction(), 0.01) << path;
        std::string text;
        for (std::size_t k = 1; k < loaded.lines.size(); ++k)
            text += (k > 1 ? "; " : "") + loaded.lines[k];
        return {true, text.empty() ? "loaded" : "loaded: " + text};
    } catch (const Error& error) {
        const std::string line = error.what();
        EXPECT_EQ(line.rfind(path.string() + ": ", 0), 0U) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        EXPECT_LT(line.size(), 600U) << line;
        std::string text = line.substr(path.string().size() + 2);
        const std::string folder = path.parent_path().string() + '/';
        if (const auto at = text.find(folder); at != std::string::npos)
            text.erase(at, folder.size());
        return {false, "refused: " + text};
    }
}

TEST(MeshCollections, EveryFileLoadsOrGivesOneClearLine) {
    if (!fs::exists(collections)) GTEST_SKIP() << "data/fetch-meshes gets the files";
    std::ofstream table(fs::path(DEM_BINARY_DIR) / "mesh-collections.md");
    table << "| file | outcome |\n|---|---|\n";
    std::size_t loaded = 0;
    const std::vector<fs::path> files = mesh_files(collections);
    for (const fs::path& path : files) {
        const Outcome outcome = outcome_of(path);
        loaded += outcome.is_loaded ? 1 : 0;
        table << "| `" << fs::relative(path, collections).string() << "` | " << outcome.text
              << " |\n";
    }
    EXPECT_GT(2 * loaded, files.size());
    EXPECT_LT(loaded, files.size());
}

TEST(MeshCollections, BrokenStlFilesAreToldApart) {
    const fs::path folder = collections / "stl-models/broken";
    if (!fs::exists(folder)) GTEST_SKIP() << "data/fetch-meshes gets the files";
    // Normals and names carry nothing; all else that is wrong is refused.
    const std::set<std::string> harmless{"missingEndsolid.ascii.stl", "notANumberNormal.ascii.stl",
                                         "wrongHeader.bin.stl",       "solidNameMismatch.ascii.stl",
                                         "wrongNormal.ascii.stl",     "wrongNormals.ascii.stl"};
    for (const fs::path& path : mesh_files(folder))
        EXPECT_EQ(outcome_of(path).is_loaded, harmless.contains(path.filename().string())) << path;
}

TEST(MeshCollections, BunnyHasFiveHoles) {
    const fs::path bunny = collections / "stl-models/objects/bunny.bin.stl";
    if (!fs::exists(bunny)) GTEST_SKIP() << "data/fetch-meshes gets the file";
    const LoadedMesh full = load_mesh(bunny, {.unit = "m"});
    ASSERT_EQ(full.report.findings.size(), 1U);
    EXPECT_EQ(full.report.findings[0].what, "holes");
    EXPECT_EQ(full.report.findings[0].count, 5U);
    const LoadedMesh decimated = load_mesh(fs::path(DEM_SOURCE_DIR) / "data/meshes/bunny.ply");
    EXPECT_TRUE(decimated.report.findings.empty());
    EXPECT_NEAR(decimated.report.volume / full.report.volume, 1.0, 1e-6);
}

}  // namespace
}  // namespace dem::shapegen
