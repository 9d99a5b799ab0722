// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/stl_reader.hpp"

#include "tests/shapegen/import/reading.hpp"

#include <cstring>
#include <limits>

namespace dem::shapegen {
namespace {

const std::string triangle =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

/// Two triangles, the second moved by 1 along z.
std::string binary(const std::string& header, std::uint32_t count = 2) {
    std::string bytes = header + std::string(80 - header.size(), '\0') + bytes_of(count);
    for (const float z : {0.0F, 1.0F}) {
        bytes.append(12, '\0');
        for (const float x : {0.0F, 0.0F, z, 1.0F, 0.0F, z, 0.0F, 0.5F, z}) bytes += bytes_of(x);
        bytes += "ab";
    }
    return bytes;
}

TEST(StlReader, TextIsReadHoweverProgramsWriteIt) {
    const std::string upper =
        "SOLID A b\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX +1.0e+00 0 0\n"
        "VERTEX 0 1. 0\nENDLOOP\nENDFACET\nENDSOLID A b\n";
    for (const std::string& text : std::vector<std::string>{
             "solid\n" + triangle + "endsolid\n",
             "solid a name\n" + triangle + "endsolid another\n", upper,
             "\n  solid\r" + triangle + "endsolid",
             "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
             "0\nendloop\nendfacet\n"
             "endsolid\n",
             "solid\nfacet normal -nan(ind) 1.#QNAN x outer loop vertex 0 0 0 vertex 1 0 0 "
             "vertex 0 1 0 endloop endfacet endsolid\n"}) {
        const PolygonSoup soup = read(read_stl, text);
        EXPECT_EQ(faces(soup), "0 1 2 |") << text;
        EXPECT_EQ(soup.points[1], Vec3(1, 0, 0)) << text;
        EXPECT_TRUE(soup.notes.empty());
    }
}

TEST(StlReader, AllSolidsOfATextAreRead) {
    EXPECT_EQ(faces(read(read_stl, "solid a\n" + triangle + "endsolid a\nsolid b\n" + triangle +
                                       triangle + "endsolid b\n")),
              "0 1 2 |3 4 5 |6 7 8 |");
}

TEST(StlReader, AMissingEndOfTheLastSolidIsSaid) {
    const PolygonSoup soup = read(read_stl, "solid a\n" + triangle);
    EXPECT_EQ(faces(soup), "0 1 2 |");
    EXPECT_EQ(soup.notes, std::vector<std::string>{"the last solid has no endsolid"});
}

TEST(StlReader, BrokenTextIsRefusedWithItsLine) {
    const std::pair<std::string, std::string> cases[] = {
        {"solid\n" + triangle +
             "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n",
         "x:13: found 'endloop', expected vertex"},
        {"solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n",
         "x:7: found a fourth vertex in a facet, expected endloop"},
        {"solid\nfacet\nouter loop\nvertex 0 0\n", "x:4: found the end of the line, expected the"},
        {"solid\nfacet\nouter loop\nvertex 0 0 inf\n", "x:4: found 'inf', expected the three"},
        {"solid\n" + triangle + "more\n", "x:9: found 'more', expected facet or endsolid"},
        {"solid\nendsolid\nfacet", "x:3: found 'facet', expected solid"},
        {"solid\nfacet", "x:2: found the end, expected outer"}};
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(refusal_of(read_stl, text).rfind(expected, 0), 0U) << refusal_of(read_stl, text);
}

TEST(StlReader, BinaryMayBeginWithTheWordSolid) {
    for (const char* header : {"", "solid from some program", "COLOR=abcd"}) {
        const PolygonSoup soup = read(read_stl, binary(header));
        EXPECT_EQ(faces(soup), "0 1 2 |3 4 5 |");
        EXPECT_EQ(soup.points[5], Vec3(0.0, 0.5, 1.0));
        EXPECT_TRUE(soup.notes.empty());
    }
    const std::string blanks = "solid" + std::string(75, ' ');
    EXPECT_EQ(read(read_stl, binary(blanks)).face_count(), 2U);
}

TEST(StlReader, BytesBehindTheLastTriangleAreSaidWithBothSizes) {
    for (const char* header : {"", "solid"}) {
        const PolygonSoup soup = read(read_stl, binary(header) + std::string(37, 'x'));
        EXPECT_EQ(soup.face_count(), 2U);
        ASSERT_EQ(soup.notes.size(), 1U);
        EXPECT_EQ(soup.notes[0],
                  "37 bytes after the last triangle passed over: found 221 bytes, expected "
                  "84 + 50 x 2 = 184 for the 2 triangles that bytes 80 to 83 count");
    }
}

TEST(StlReader, BinarySolidsOneAfterTheOtherAreAllRead) {
    EXPECT_EQ(read(read_stl, binary("") + binary("solid b")).face_count(), 4U);
}

TEST(StlReader, AWrongNumberOfTrianglesIsRefusedWithBothSizes) {
    EXPECT_EQ(refusal_of(read_stl, binary("", 3)),
              "x: found 184 bytes, expected 84 + 50 x 3 = 234 for the 3 triangles that bytes 80 "
              "to 83 count");
    for (const std::uint32_t count : {0U, 1U, 4000000000U})
        EXPECT_NE(refusal_of(read_stl, binary("", count)).find("found 184 bytes, expected 84"),
                  std::string::npos);
    EXPECT_EQ(refusal_of(read_stl, "one two three").rfind("x: found 13 bytes that do not", 0), 0U);
}

TEST(StlReader, ACornerThatIsNoNumberIsRefusedWithItsByte) {
    std::string bytes = binary("");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(bytes.data() + 84 + 50 + 24, &nan, sizeof nan);
    EXPECT_EQ(refusal_of(read_stl, bytes).rfind("x: byte 158: found a corner of triangle 2", 0), 0U)
        << refusal_of(read_stl, bytes);
}

}  // namespace
}  // namespace dem::shapegen
