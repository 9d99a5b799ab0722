// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/obj_reader.hpp"

#include "tests/shapegen/import/reading.hpp"

namespace dem::shapegen {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjReader, CornersAreNamedInEveryWayThatProgramsWrite) {
    for (const char* face :
         {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/4/1",
          "f -4 -3 -2 -1", "f -4//-1 -3//-1 -2//-1 -1//-1", "F 1 2 3 4", "fo 1 2 3 4", "f +1 2 3 4",
          "f 1/ 2/ 3/ 4/", "f 1 2 \\\n 3 4", "f 1 2\\\r\n3 4", "  f\t1  2 3 4  ",
          "f 1 2 3 4 # the only one"})
        EXPECT_EQ(faces(read(read_obj, square + face)), "0 1 2 3 |") << face;
    EXPECT_EQ(faces(read(read_obj, "f 1 2 3\n" + square)), "0 1 2 |");  // before its vertices
}

TEST(ObjReader, RelativeIndicesCountFromWhereTheyStand) {
    EXPECT_EQ(faces(read(read_obj, square + "f -4 -3 -2\n" + square + "f -4 -3 -2\n")),
              "0 1 2 |4 5 6 |");
}

TEST(ObjReader, NumbersAreReadInEveryWayThatProgramsWrite) {
    const PolygonSoup soup =
        read(read_obj, "v .5 1. +1e-1\nV -.5 -0 1E5\nv 0.123456789012345 0 0\nf 1 2 3\n");
    EXPECT_EQ(soup.points[0], Vec3(0.5, 1.0, 0.1));
    EXPECT_EQ(soup.points[1], Vec3(-0.5, 0.0, 1e5));
    EXPECT_EQ(soup.points[2].x(), 0.123456789012345);
}

TEST(ObjReader, AWeightOrAColorDoesNotMoveAVertex) {
    const PolygonSoup soup = read(
        read_obj, "v 1 2 3 0.5\nv 1 2 3 1\nv 1 2 3 255 0 0\nv 1 2 3 0.1 0.2 0.3 1\nf 1 2 3 4\n");
    for (const Vec3& p : soup.points) EXPECT_EQ(p, Vec3(1, 2, 3));
    ASSERT_EQ(soup.notes.size(), 1U);
    EXPECT_NE(soup.notes[0].find("weights of vertices: 1 "), std::string::npos);
}

TEST(ObjReader, LinesEndInAnyWay) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string text = "\xef\xbb\xbf# first\n\n" + square + "f 1 2 3\nf 1 3 4";
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
            text.replace(at, 1, end);
            at += std::string(end).size();
        }
        EXPECT_EQ(faces(read(read_obj, text)), "0 1 2 |0 2 3 |");
        EXPECT_EQ(refusal_of(read_obj, text + end + "f 1 2 9").rfind("x:9: found vertex 9", 0), 0U)
            << refusal_of(read_obj, text + end + "f 1 2 9");
    }
}

TEST(ObjReader, WhatIsNoFaceIsLeftOutAndCounted) {
    const PolygonSoup soup =
        read(read_obj, "mtllib C:\\models\\\no part#1\ng a b\ns off\nusemtl red\n" + square +
                           "vt 0 0\nvn 0 0 1\nvp 0.5\nl 1 2\np 1 2 \\\n3\nf 1 2 3\n"
                           "cstype bspline\ndeg 3\ncurv 0 1 1 \\\n2 3\nparm u 0 1\nend\n");
    EXPECT_EQ(faces(soup), "0 1 2 |");
    EXPECT_EQ(soup.points.size(), 4U);
    EXPECT_EQ(soup.notes, (std::vector<std::string>{"points and lines: 2 left out",
                                                    "free-form curves and surfaces: 1 left out"}));
}

TEST(ObjReader, WhatIsNotOBJIsRefusedWithItsLine) {
    const std::pair<std::string, std::string> cases[] = {
        {"once upon a time", "x:1: found 'once', expected a statement of OBJ files"},
        {"v 0 0", "x:1: found a vertex of 2 numbers"},
        {"v 0 0 0 0 0", "x:1: found a vertex of 5 numbers"},
        {"v 0 0 zero", "x:1: found 'zero', expected the coordinates"},
        {"v 0 0 nan", "x:1: found 'nan'"},
        {"v 0 0 1e999", "x:1: found '1e999'"},
        {"v 0 0 0 0 0 0 0 0", "x:1: found '0', expected the coordinates"},
        {square + "f 1 2", "x:5: found a face of 2 corners, expected three or more"},
        {square + "f 1 2 0", "x:5: found '0', expected a vertex from 1 on"},
        {square + "f 1 2 5\nf 1 2 3", "x:5: found vertex 5 as a corner, expected at most 4"},
        {square + "f 1 2 -5", "x:5: found '-5', expected a vertex from 1 on, or from -1 to -4"},
        {square + "f 1 2 99999999999999999999", "x:5: found '99999999999999999999', expected a"},
        {square + "f 1 2 4294967296", "x:5: found '4294967296'"},
        {square + "f 1 2 3/a", "x:5: found '3/a', expected a corner"},
        {square + "f 1 2 3/1/1/1", "x:5: found '3/1/1/1', expected a corner"},
        {square + "f 1 2 3.5", "x:5: found '3.5', expected a corner"},
        {"call other.obj", "x:1: found 'call', expected one file"},
        {"\xff\xfev\n", "x:1: found '\\xff\\xfev', expected a statement"}};
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(refusal_of(read_obj, text).rfind(expected, 0), 0U)
            << refusal_of(read_obj, text) << " where expected " << expected;
}

}  // namespace
}  // namespace dem::shapegen
