// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/ply_reader.hpp"

#include "tests/shapegen/import/reading.hpp"

#include <algorithm>

namespace dem::shapegen {
namespace {

std::string header(const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\ncomment made by hand\nobj_info none\n" + elements +
           "end_header\n";
}

const std::string vertices =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string two_faces = "element face 2\nproperty list uchar int vertex_indices\n";
const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(PlyReader, TextIsRead) {
    const PolygonSoup soup =
        read(read_ply, header("ascii", vertices + two_faces) + points + "3 0 1 2\n4 0 1 2 3\n");
    EXPECT_EQ(faces(soup), "0 1 2 |0 1 2 3 |");
    EXPECT_EQ(soup.points[2], Vec3(1, 1, 0));
    EXPECT_TRUE(soup.notes.empty());
}

TEST(PlyReader, OtherPropertiesAndElementsArePassedOver) {
    const PolygonSoup soup = read(
        read_ply,
        header(
            "ascii",
            "element camera 1\nproperty double focus\n"
            "element vertex 3\nproperty double nx\nproperty int z\nproperty list uchar int near\n"
            "property uchar x\nproperty float64 y\nproperty float quality\n"
            "element face 1\nproperty list int short texture\n"
            "property list uint16 uint vertex_index\nproperty uchar red\n"
            "element edge 1\nproperty int a\nproperty int b\n") +
            "50\nnan 3 2 7 7 1 2 nan\nnan 3 0 4 5 0\n\nnan 3 0 6 7 0\n2 1 1 3 0 1 2 255\n0 1\n");
    EXPECT_EQ(faces(soup), "0 1 2 |");
    EXPECT_EQ(soup.points[0], Vec3(1, 2, 3));
    EXPECT_EQ(soup.notes, (std::vector<std::string>{"elements 'camera': 1 left out",
                                                    "elements 'edge': 1 left out"}));
}

template <class... Values>
std::string binary(bool is_big, Values... values) {
    std::string all;
    [[maybe_unused]] const auto add = [&](const auto& value) {
        std::string bytes = bytes_of(value);
        if (is_big) std::reverse(bytes.begin(), bytes.end());
        all += bytes;
    };
    (add(values), ...);
    return all;
}

TEST(PlyReader, BinaryIsReadInBothByteOrdersAndWithIndicesOfEveryType) {
    const auto file = [](bool is_big, const std::string& type, auto index) {
        using Index = decltype(index);
        const auto i = [](int k) { return static_cast<Index>(k); };
        const std::string elements =
            "element vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
            "element face 1\nproperty list " +
            type + " " + type + " vertex_indices\nproperty uchar flag\n";
        std::string data;
        for (const int k : {0, 1, 2})
            data +=
                binary(is_big, 0.1 * k, static_cast<float>(k), static_cast<std::int16_t>(-300 * k));
        data += binary(is_big, i(3), i(0), i(1), i(2), std::uint8_t{10});
        return header(is_big ? "binary_big_endian" : "binary_little_endian", elements) + data;
    };
    for (const bool is_big : {false, true})
        for (const std::string& bytes :
             {file(is_big, "char", std::int8_t{}), file(is_big, "uint8", std::uint8_t{}),
              file(is_big, "short", std::int16_t{}), file(is_big, "ushort", std::uint16_t{}),
              file(is_big, "int", std::int32_t{}), file(is_big, "uint32", std::uint32_t{})}) {
            const PolygonSoup soup = read(read_ply, bytes);
            EXPECT_EQ(faces(soup), "0 1 2 |");
            EXPECT_EQ(soup.points[2], Vec3(0.2, 2, -600));
            EXPECT_TRUE(soup.notes.empty());
            for (std::size_t size = 0; size < bytes.size(); ++size)
                EXPECT_EQ(refusal_of(read_ply, bytes.substr(0, size)).rfind("x:", 0), 0U) << size;
            EXPECT_NE(refusal_of(read_ply, bytes + "data").find("found more data"),
                      std::string::npos);
        }
}

TEST(PlyReader, TheDataBeginBehindALineEndOfTheHeadersOwnKind) {
    const std::string elements =
        "element vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
        "element face 1\nproperty list uchar uchar vertex_indices\n";
    // The first coordinate is a line feed.
    const std::string data("\x0a\0\0\1\0\0\0\1\0\3\0\1\2", 13);
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string text = header("binary_little_endian", elements);
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
            text.replace(at, 1, end);
            at += std::string(end).size();
        }
        const PolygonSoup soup = read(read_ply, text + data);
        EXPECT_EQ(soup.points[0], Vec3(10, 0, 0));
        EXPECT_EQ(faces(soup), "0 1 2 |");
    }
}

TEST(PlyReader, StripsOfTrianglesAreRead) {
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    EXPECT_EQ(
        faces(read(read_ply, header("ascii", vertices + strips) + points + "8 0 1 3 2 -1 2 1 0\n")),
        "0 1 3 |3 1 2 |2 1 0 |");
}

TEST(PlyReader, WhatItDoesNotHoldIsRefusedWithItsPlace) {
    const std::string start = header("ascii", vertices + two_faces);
    const std::pair<std::string, std::string> cases[] = {
        {"plain text", "x:1: found 'plain', expected ply"},
        {"ply\nno header", "x:2: found 'no', expected format"},
        {"ply\nformat ascii 1.0\n", "x:3: found the end, expected end_header"},
        {"ply\nelement vertex 1\nend_header\n", "x:3: found 'end_header', expected a line that"},
        {"ply\nformat binary 1.0\n", "x:2: found 'binary', expected ascii, binary_little_endian"},
        {"ply\nformat ascii 1.0\nproperty int x\n", "x:3: found 'property', expected an element"},
        {"ply\nformat ascii 1.0\nelement vertex -1\n", "x:3: found '-1', expected a count"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty string x\n",
         "x:4: found 'string', expected a type"},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\n",
         "x:4: found 'list', expected a list with a count of an integer type"},
        {header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "0 0\n",
         "x:5: found no property 'z' of 'vertex' that is a number, expected one"},
        {header("ascii", vertices + "element face 1\nproperty list uchar float vertex_indices\n") +
             points + "3 0 1 2\n",
         "x:9: found no property 'vertex_indices' of 'face' that is a list of whole numbers"},
        {header("ascii",
                vertices + "element face 100000000\nproperty list uchar int vertex_index\n") +
             points,
         "x:9: found 100000000 'face' promised, expected no more than fit the file ("},
        {start + points + "3 0 1 2\n", "x:17: found the end, expected 'face' 2 of 2"},
        {start + points + "3 0 1 2\n0\n", "x:17: found a face of 0 corners, expected three"},
        {start + points + "3 0 1 2\n3 0 1 4\n", "x:17: found vertex 4 as a corner, expected one"},
        {start + points + "3 0 1 2\n3 0 1 -2\n", "x:17: found vertex -2 as a corner, expected"},
        {start + points + "3 0 1 2\n3 0 1\n", "x:17: found the end of the line, expected a whole"},
        {start + points + "3 0 1 2\n3 0 1 2 3\n", "x:17: found '3', expected the end of the line"},
        {start + points + "3 0 1 2\n99 0 1 2\n", "x:17: found a list of 99 numbers, expected at"},
        {start + points + "3 0 1 2\n3 0 1 2\n3 0 1 2\n", "x:18: found more data, expected the end"},
        {start + "0 0 1e999\n" + points, "x:12: found '1e999', expected a coordinate"}};
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(refusal_of(read_ply, text).rfind(expected, 0), 0U) << refusal_of(read_ply, text);
}

}  // namespace
}  // namespace dem::shapegen
