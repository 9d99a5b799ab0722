// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/atomic_file.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/import/obj_reader.hpp"
#include "shapegen/import/off_reader.hpp"
#include "shapegen/import/ply_reader.hpp"
#include "shapegen/import/stl_reader.hpp"
#include "tests/fuzz/mutant.hpp"
#include "tests/fuzz/targets/mesh.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

struct Sample {
    fuzz::ReadMesh reader;
    std::string bytes;
};

/// What the fuzzers start with.
std::vector<Sample> samples() {
    std::vector<Sample> all;
    for (const auto& [name, reader] : {std::pair<std::string, fuzz::ReadMesh>{"obj", read_obj},
                                       {"off", read_off},
                                       {"ply", read_ply},
                                       {"stl", read_stl}}) {
        std::vector<std::filesystem::path> paths;
        for (const auto& entry :
             std::filesystem::directory_iterator(DEM_SOURCE_DIR "/tests/fuzz/corpus/" + name))
            paths.push_back(entry.path());
        EXPECT_FALSE(paths.empty()) << name;
        std::sort(paths.begin(), paths.end());
        for (const auto& path : paths) {
            std::ifstream file(path, std::ios::binary);
            all.push_back({reader, std::string(std::istreambuf_iterator<char>(file), {})});
        }
    }
    return all;
}

/// Ends the program where a promise is broken.
void expect_soup_or_line(fuzz::ReadMesh reader, const std::string& bytes) {
    fuzz::reads_mesh(reader, std::as_bytes(std::span(bytes)));
}

TEST(MeshFuzz, TruncatedFilesAreSoupsOrLines) {
    for (const auto& [reader, bytes] : samples())
        for (std::size_t size = 0; size < bytes.size(); ++size)
            expect_soup_or_line(reader, bytes.substr(0, size));
}

TEST(MeshFuzz, ChangedFilesAreSoupsOrLines) {
    Random random(17, 0);
    for (const auto& [reader, bytes] : samples())
        for (int i = 0; i < 1000; ++i) expect_soup_or_line(reader, fuzz::mutant(bytes, random));
}

// A process for each, so few of them.
TEST(MeshFuzz, ChangedGltfFilesAreSoupsOrLines) {
    const std::string good =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)"
        R"("scale":[1,2,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
        R"("data:application/octet-stream;base64,)"
        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
    const std::string path = fuzz::scratch_folder() + "/x.gltf";
    const std::array<std::string, 1> places = {path + ": "};
    const auto reads = [&](const std::string& bytes) {
        write_file(path, bytes);
        return fuzz::accepts(places, [&] {
            const PolygonSoup soup = read_mesh_file(path).soup;
            for (const Vec3& p : soup.points) fuzz::promise_finite(p, "a point");
            for (const std::string& note : soup.notes) fuzz::check_line(note);
        });
    };
    EXPECT_TRUE(reads(good));
    Random random(18, 0);
    for (int i = 0; i < 60; ++i) reads(fuzz::mutant(good, random));
}

TEST(MeshFuzz, FilesOfOneFormatAreNoneOfAnother) {
    for (const auto& [unused, bytes] : samples())
        for (const fuzz::ReadMesh reader : {read_obj, read_off, read_ply, read_stl})
            expect_soup_or_line(reader, bytes);
}

}  // namespace
}  // namespace dem::shapegen
