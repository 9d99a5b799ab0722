// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/atomic_file.hpp"
#include "common/random.hpp"
#include "shapegen/import/mesh_file.hpp"
#include "shapegen/import/obj_reader.hpp"
#include "shapegen/import/off_reader.hpp"
#include "shapegen/import/ply_reader.hpp"
#include "shapegen/import/stl_reader.hpp"
#include "tests/fuzz/targets/mesh.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

namespace dem {
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

/// A change of a few bytes, as disks, editors and programs with faults make them.
std::string changed(std::string bytes, Random& random) {
    const std::string letters = "0123456789.-+e /#\\\n\r\tvf\xff";
    const auto below = [&random](std::size_t n) {
        return static_cast<std::size_t>(random.next() % n);
    };
    for (std::size_t k = 1 + below(5); k-- > 0;) {
        if (bytes.empty()) bytes = "0";
        const std::size_t at = below(bytes.size());
        switch (below(5)) {
            case 0:
                bytes[at] = static_cast<char>(random.next());
                break;
            case 1:
                bytes[at] = letters[below(letters.size())];
                break;
            case 2:
                bytes.insert(at, 1 + below(3), letters[below(letters.size())]);
                break;
            case 3:
                bytes.erase(at, 1 + below(8));
                break;
            default:  // a piece of the file again, elsewhere
                bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        }
    }
    return bytes;
}

TEST(MeshFuzz, TruncatedFilesAreSoupsOrLines) {
    for (const auto& [reader, bytes] : samples())
        for (std::size_t size = 0; size < bytes.size(); ++size)
            expect_soup_or_line(reader, bytes.substr(0, size));
}

TEST(MeshFuzz, ChangedFilesAreSoupsOrLines) {
    // DEM_FUZZ_ROUNDS: more of them, for an hour of searching.
    const char* asked = std::getenv("DEM_FUZZ_ROUNDS");
    const int rounds = asked != nullptr ? std::atoi(asked) : 1000;
    Random random(17, 0);
    for (const auto& [reader, bytes] : samples())
        for (int i = 0; i < rounds; ++i) expect_soup_or_line(reader, changed(bytes, random));
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
    for (int i = 0; i < 60; ++i) reads(changed(good, random));
}

TEST(MeshFuzz, FilesOfOneFormatAreNoneOfAnother) {
    for (const auto& [unused, bytes] : samples())
        for (const fuzz::ReadMesh reader : {read_obj, read_off, read_ply, read_stl})
            expect_soup_or_line(reader, bytes);
}

}  // namespace
}  // namespace dem
