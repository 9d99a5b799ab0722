// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/off_reader.hpp"

#include "tests/shapegen/import/reading.hpp"

namespace dem::shapegen {
namespace {

const std::string body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n";

TEST(OffReader, HeadersAreReadHoweverProgramsWriteThem) {
    for (const char* header : {"OFF\n4 2 0\n", "OFF 4 2 0\n", "off\n4 2\n", "OFF4 2 0\n",
                               "# made by\nOFF # here\n\n4 2 0\n", "\xef\xbb\xbfOFF\r\n4 2 5\r\n",
                               "COFF\n4 2 0\n", "NOFF\n4 2 0\n", "STCNOFF 4 2 0\n"})
        EXPECT_EQ(faces(read(read_off, header + body)), "0 1 2 |0 1 2 3 |") << header;
}

TEST(OffReader, ColorsNormalsAndTexturesArePassedOver) {
    const PolygonSoup soup =
        read(read_off,
             "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 0.5 0.5\n1 0 0 0 0 1 9 9 9 9 0 0\n"
             "0 1 0 0 0 1 1 1 1 1 1 1\n3 0 1 2 0.5 0.5 0.5 1\n");
    EXPECT_EQ(faces(soup), "0 1 2 |");
    EXPECT_EQ(soup.points[1], Vec3(1, 0, 0));
}

TEST(OffReader, WhatItDoesNotHoldIsRefusedWithItsLine) {
    const std::pair<std::string, std::string> cases[] = {
        {"", "x:1: found the end, expected OFF, COFF"},
        {"PLY\n", "x:1: found 'PLY', expected OFF, COFF"},
        {"4OFF\n4 2 0\n", "x:1: found '4OFF', expected OFF"},
        {"nOFF\n3\n4 2 0\n", "x:1: found 'nOFF', expected OFF"},
        {"OFF BINARY\n", "x:1: found 'BINARY', expected text"},
        {"OFF\nmany points\n", "x:2: found 'many', expected the numbers of vertices"},
        {"OFF\n4\n", "x:2: found the end of the line, expected the numbers of vertices"},
        {"OFF\n4 -2 0\n", "x:2: found '-2', expected a number of faces"},
        {"OFF\n400000000 2 0\n" + body, "x:2: found 400000000 vertices promised, expected no more"},
        {"OFF\n4 200000000 0\n" + body, "x:2: found 200000000 faces promised, expected no more"},
        {"OFF\n4 3 0\n" + body, "x:9: found the end, expected face 3 of 3"},
        {"OFF\n4 1 0\n" + body, "x:8: found '4', expected the end of the file after 1 faces"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "x:6: found '3', expected one of the 3"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "x:6: found '-1', expected one of the 3"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1    \n", "x:6: found '2', expected three or more"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", "x:6: found the end of the line, expected"},
        {"OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "x:3: found the end of the line, expected"}};
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(refusal_of(read_off, text).rfind(expected, 0), 0U) << refusal_of(read_off, text);
}

}  // namespace
}  // namespace dem::shapegen
