// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/random.hpp"
#include "shapegen/import/obj_reader.hpp"
#include "shapegen/import/off_reader.hpp"
#include "shapegen/import/ply_reader.hpp"
#include "shapegen/import/stl_reader.hpp"
#include "tests/shapegen/import/reading.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace dem {
namespace {

struct Sample {
    ReadMesh reader;
    std::string bytes;
};

/// The meshes that faults were found with, and a binary file of each kind.
std::vector<Sample> samples() {
    std::vector<Sample> all;
    for (const auto& [name, reader] :
         {std::pair<std::string, ReadMesh>{"overlapping_boxes.obj", read_obj},
          {"vertex_w.obj", read_obj},
          {"missing_face.off", read_off},
          {"one_face_too_few.ply", read_ply},
          {"binary_trailing_bytes.stl", read_stl}}) {
        std::ifstream file(DEM_SOURCE_DIR "/tests/shapegen/import/faults/" + name,
                           std::ios::binary);
        all.push_back({reader, std::string(std::istreambuf_iterator<char>(file), {})});
        EXPECT_FALSE(all.back().bytes.empty()) << name;
    }
    const std::string stl =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1.5 -2e-3\nendloop\nendfacet\nendsolid a\n";
    const std::string off = "STCNOFF 3 1 0\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2 0.5 # red\n";
    all.push_back({read_stl, stl});
    all.push_back({read_off, off});
    for (const char* order : {"little", "big"})
        all.push_back({read_ply, "ply\nformat binary_" + std::string(order) +
                                     "_endian 1.0\nelement vertex 3\nproperty char x\n"
                                     "property ushort y\nproperty float z\nelement face 2\n"
                                     "property list uchar char vertex_indices\nproperty list char "
                                     "double t\nelement tristrips 1\nproperty list char char "
                                     "vertex_index\nend_header\n" +
                                     std::string(21, '\0') +
                                     std::string("\3\0\1\2\0\3\2\1\0\0", 10) +
                                     std::string("\4\0\1\xff\2", 5)});
    return all;
}

/// A sound soup, or an error of one line that begins with the name.
void expect_soup_or_line(ReadMesh reader, const std::string& bytes) {
    try {
        expect_sound(read(reader, bytes));
    } catch (const Error& error) {
        const std::string line = error.what();
        EXPECT_EQ(line.rfind("x:", 0), 0U) << line;
        EXPECT_EQ(line.find_first_of("\n\r\t"), std::string::npos) << line;
        EXPECT_LT(line.size(), 300U) << line;
    }
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
    const std::string letters = "0123456789.-+e /#\\\n\r\tvf\xff";
    Random random(17, 0);
    const auto below = [&random](std::size_t n) {
        return static_cast<std::size_t>(random.next() % n);
    };
    for (const auto& [reader, bytes] : samples())
        for (int i = 0; i < rounds; ++i) {
            std::string changed = bytes;
            for (std::size_t k = 1 + below(5); k-- > 0;) {
                const std::size_t at = below(changed.size());
                switch (below(5)) {
                    case 0:
                        changed[at] = static_cast<char>(random.next());
                        break;
                    case 1:
                        changed[at] = letters[below(letters.size())];
                        break;
                    case 2:
                        changed.insert(at, 1 + below(3), letters[below(letters.size())]);
                        break;
                    case 3:
                        changed.erase(at, 1 + below(8));
                        break;
                    default:  // a piece of the file again, elsewhere
                        changed.insert(at, changed.substr(below(changed.size()), below(40)));
                }
                if (changed.empty()) changed = "0";
            }
            expect_soup_or_line(reader, changed);
        }
}

TEST(MeshFuzz, FilesOfOneFormatAreNoneOfAnother) {
    for (const auto& [unused, bytes] : samples())
        for (const ReadMesh reader : {read_obj, read_off, read_ply, read_stl})
            expect_soup_or_line(reader, bytes);
}

}  // namespace
}  // namespace dem
