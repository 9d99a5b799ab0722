// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/load_mesh.hpp"

#include "common/error.hpp"
#include "shapegen/mesh/triangle_mesh.hpp"
#include "tests/formats/temporary_folder.hpp"
#include "tests/shapegen/mesh/sample_meshes.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

class LoadMesh : public TemporaryFolder {
  protected:
    std::filesystem::path written(const std::string& name, const std::string& content) const {
        write(name, content);
        return folder_ / name;
    }
};

std::string refusal(const std::filesystem::path& path, const MeshLoadOptions& options = {}) {
    return message_of<Error>([&] { load_mesh(path, options); });
}

// A box of 1 x 2 x 3, in each format.
const TriangleMesh box = sample::box({0, 0, 0}, {1, 2, 3});

std::string stl_text(const TriangleMesh& mesh) {
    std::ostringstream out;
    out << "solid box\n";
    for (const auto& triangle : mesh.triangles) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t v : triangle)
            out << "vertex " << mesh.vertices[v].transpose() << '\n';
        out << "endloop\nendfacet\n";
    }
    out << "endsolid box\n";
    return out.str();
}

std::string bytes(const auto& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string stl_binary(const TriangleMesh& mesh) {
    std::string out(80, ' ');
    out += bytes(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        out.append(12, '\0');
        for (const std::uint32_t v : triangle)
            for (const double x : mesh.vertices[v]) out += bytes(static_cast<float>(x));
        out.append(2, '\0');
    }
    return out;
}

std::string listed(const TriangleMesh& mesh, const std::string& point, const std::string& face,
                   std::uint32_t first) {
    std::ostringstream out;
    for (const Vec3& v : mesh.vertices) out << point << v.transpose() << '\n';
    for (const auto& [i, j, k] : mesh.triangles)
        out << face << i + first << ' ' << j + first << ' ' << k + first << '\n';
    return out.str();
}

// The box again as glTF: positions and indices in a base64 buffer made from them.
std::string base64(const std::string& data) {
    static constexpr char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < data.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> std::uint32_t {
            return i + k < data.size() ? static_cast<unsigned char>(data[i + k]) : 0U;
        };
        const std::uint32_t word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= data.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string gltf(const TriangleMesh& mesh) {
    std::string positions;
    for (const Vec3& v : mesh.vertices)
        for (const double x : v) positions += bytes(static_cast<float>(x));
    std::string indices;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) indices += bytes(static_cast<std::uint16_t>(v));
    std::ostringstream out;
    out << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": [10, 0, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": )"
        << positions.size() + indices.size() << R"(, "uri": "data:application/octet-stream;base64,)"
        << base64(positions + indices)
        << R"("}], "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": )"
        << positions.size() << R"(}, {"buffer": 0, "byteOffset": )" << positions.size()
        << R"(, "byteLength": )" << indices.size()
        << R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
        "min": [0, 0, 0], "max": [1, 2, 3]},
        {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]})";
    return out.str();
}

TEST_F(LoadMesh, EveryFormatGivesTheSameBody) {
    const std::string points_and_faces = listed(box, "", "3 ", 0);
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
        "property float z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n" +
        points_and_faces;
    for (const auto& path :
         {written("text.stl", stl_text(box)), written("binary.STL", stl_binary(box)),
          written("box.obj", listed(box, "v ", "f ", 1)), written("box.ply", ply),
          written("box.off", "OFF # a comment\n8 12 0\n# another\n" + points_and_faces + "# end\n"),
          written("box.gltf", gltf(box))}) {
        const LoadedMesh loaded = load_mesh(path, {.unit = "mm"});
        EXPECT_NEAR(enclosed_volume(loaded.mesh), 6e-9, 1e-17) << path;
        EXPECT_EQ(loaded.mesh.vertices.size(), 8U) << path;
        EXPECT_EQ(loaded.mesh.triangles.size(), 12U) << path;
        EXPECT_TRUE(loaded.report.findings.empty()) << path;
        const bool is_moved = path.extension() == ".gltf";  // by the node that holds it
        EXPECT_NEAR(bounding_box(loaded.mesh).upper.x(), is_moved ? 0.011 : 0.001, 1e-9) << path;
    }
}

TEST_F(LoadMesh, PolygonsAreSplit) {
    const auto path =
        written("box.obj",
                "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 0\nv 0 0 3\nv 1 0 3\nv 0 2 3\nv 1 2 3\n"
                "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
    const LoadedMesh loaded = load_mesh(path);
    EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
    EXPECT_NEAR(enclosed_volume(loaded.mesh), 6e-9, 1e-17);
}

TEST_F(LoadMesh, UnitsAreSaidAndScaled) {
    const auto stl = written("box.stl", stl_binary(box));
    EXPECT_NEAR(enclosed_volume(load_mesh(stl, {.unit = "m"}).mesh), 6.0, 1e-14);
    EXPECT_NEAR(enclosed_volume(load_mesh(stl, {.unit = "cm", .scale = 2.0}).mesh), 48e-6, 1e-16);
    const LoadedMesh assumed = load_mesh(stl);
    EXPECT_NEAR(enclosed_volume(assumed.mesh), 6e-9, 1e-17);
    EXPECT_EQ(assumed.lines.front(), "12 triangles, 1 x 2 x 3 mm (assumed; --unit says otherwise)");
    const LoadedMesh meters = load_mesh(written("box.gltf", gltf(box)));
    EXPECT_NEAR(enclosed_volume(meters.mesh), 6.0, 1e-5);
    EXPECT_EQ(meters.lines.front(), "12 triangles, 1 x 2 x 3 m (the format's unit)");
    EXPECT_NE(refusal(stl, {.unit = "inch"}), "");
    EXPECT_NE(refusal(stl, {.unit = "mm", .scale = 0.0}).find("--scale"), std::string::npos);
}

const std::filesystem::path faults = DEM_SOURCE_DIR "/tests/shapegen/import/faults";

bool says(const LoadedMesh& mesh, const std::string& words) {
    return std::any_of(mesh.lines.begin(), mesh.lines.end(), [&words](const std::string& line) {
        return line.find(words) != std::string::npos;
    });
}

TEST_F(LoadMesh, WhatWritersDoIsReadWithTheRightVolume) {
    struct Case {
        std::string file;
        double volume;
        std::string words;  // said about it
        bool unite = false;
    };
    const Case cases[] = {
        {"vertex_w.obj", 1.0, "weights of vertices: 7 passed over"},
        {"concave_ngon_L.obj", 3.0, ""},
        {"double_sided_cube.obj", 1.0, "triangles of a body that is drawn on both sides: 12"},
        {"leading_dot.obj", 1.0, ""},
        {"binary_trailing_bytes.stl", 1.0, "found 721 bytes, expected 84 + 50 x 12 = 684"},
        {"abutting_boxes.obj", 2.0, "triangles that face each other in one place"},
        {"abutting_boxes.obj", 2.0, "parts that cross, touch or hold each other: 2", true},
        {"overlapping_boxes.obj", 1.9, "5 % of their volume was drawn twice", true}};
    for (const Case& c : cases) {
        const LoadedMesh loaded = load_mesh(faults / c.file, {.unit = "m", .unite = c.unite});
        EXPECT_NEAR(enclosed_volume(loaded.mesh), c.volume, 1e-12) << c.file;
        EXPECT_TRUE(says(loaded, c.words)) << c.file;
    }
    const LoadedMesh concave = load_mesh(faults / "concave_ngon_L.obj", {.unit = "m"});
    EXPECT_LT(
        (mass_properties(concave.mesh).center_of_mass - Vec3(5.0 / 6.0, 5.0 / 6.0, 0.5)).norm(),
        1e-12);
    EXPECT_NE(refusal(faults / "overlapping_boxes.obj").find("--union joins them"),
              std::string::npos);
}

TEST_F(LoadMesh, FilesThatHoldLessThanTheyPromiseGiveALineWithItsPlace) {
    const std::pair<std::string, std::string> cases[] = {
        {"missing_face.off", ":11: found the end, expected face 5 of 5"},
        {"index_out_of_range.off", ":9: found '9', expected one of the 4 vertices"},
        {"quad_out_of_range.ply", ":16: found vertex 99999999 as a corner, expected one of the 4"},
        {"one_face_too_few.ply", ":18: found the end, expected 'face' 5 of 5"}};
    for (const auto& [file, words] : cases)
        EXPECT_EQ(refusal(faults / file).rfind((faults / file).string() + words, 0), 0U)
            << refusal(faults / file);
}

TEST_F(LoadMesh, MaterialFilesAreNoBodysBusiness) {
    const auto path =
        written("box.obj", "mtllib nowhere.mtl\nusemtl red\n" + listed(box, "v ", "f ", 1));
    EXPECT_EQ(load_mesh(path).lines.size(), 1U);
}

TEST_F(LoadMesh, NodesNestedThousandsOfTimesGiveAMeshOrALine) {
    const std::string whole = gltf(box);
    const std::string nodes = R"("nodes": [{"mesh": 0, "translation": [10, 0, 0]}])";
    for (const int depth : {100, 3000, 200000}) {
        std::string nested = R"("nodes": [)";
        for (int k = 1; k <= depth; ++k) nested += R"({"children": [)" + std::to_string(k) + "]},";
        nested += R"({"mesh": 0}])";
        std::string text = whole;
        text.replace(text.find(nodes), nodes.size(), nested);
        const auto path = written("nested.gltf", text);
        const std::string line = refusal(path);
        EXPECT_TRUE(line.empty() || line.rfind(path.string() + ": ", 0) == 0) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
}

TEST_F(LoadMesh, SizesThatNoTemplateHoldsAreRefused) {
    for (const char* scale : {"1e300", "1e-300", "1e20"}) {
        const std::string s = scale;
        const auto path = written("box.obj", "v 0 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nv 0 0 " +
                                                 s + "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        EXPECT_NE(refusal(path).find("expected from 1e-12 to 1e6 m"), std::string::npos) << s;
    }
}

TEST_F(LoadMesh, BadFilesGiveOneLineThatNamesThem) {
    std::string not_a_number = stl_binary(box);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(not_a_number.data() + 84 + 12, &nan, sizeof nan);
    std::string truncated = stl_binary(box);
    truncated.resize(truncated.size() - 60);
    const TriangleMesh one{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}};
    const std::vector<std::pair<std::filesystem::path, std::string>> cases{
        {"nowhere.stl", "no such file"},
        {written("empty.stl", ""), "an empty file"},
        {written("box.step", "ISO-10303-21;"), "the extension '.step'"},
        {written("garbage.stl", "one two three\nfour"), "expected STL"},
        {written("garbage.obj", "once upon a time\n"), "expected"},
        {written("garbage.ply", "ply\nno header"), "expected"},
        {written("garbage.off", "OFF\nmany points\n"), "expected"},
        {written("garbage.gltf", "{\"asset\""), "expected"},
        {written("nan.stl", not_a_number), "not a finite number"},
        {written("truncated.stl", truncated), "expected 84 + 50 x 12"},
        {written("one.stl", stl_text(one)), "encloses no volume"},
        {written("no_faces.stl", "solid nothing\nendsolid nothing\n"), "expected"}};
    for (const auto& [path, expected] : cases) {
        const std::string message = refusal(path);
        EXPECT_EQ(message.rfind(path.string() + ":", 0), 0U) << path << message;
        EXPECT_NE(message.find(expected), std::string::npos) << path << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST_F(LoadMesh, ProgressRisesToItsEnd) {
    double last = -1.0;
    MeshLoadOptions options;
    options.progress = [&last](double done, std::string_view next) {
        EXPECT_GE(done, last);
        EXPECT_FALSE(next.empty());
        last = done;
    };
    load_mesh(written("box.stl", stl_binary(box)), options);
    EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace dem::shapegen
