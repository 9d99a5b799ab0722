// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/error.hpp"
#include "shapegen/repair/polygon_soup.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace dem::shapegen {

using ReadMesh = PolygonSoup (*)(std::span<const std::byte>, const std::string&);

inline PolygonSoup read(ReadMesh reader, std::string_view text) {
    return reader(std::as_bytes(std::span(text)), "x");
}

/// The message of the error, "" when there is none.
inline std::string refusal_of(ReadMesh reader, std::string_view text) {
    try {
        read(reader, text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// The corners of the faces, each followed by a bar: "0 1 2 | 0 2 3 |".
inline std::string faces(const PolygonSoup& soup) {
    std::string text;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        for (const std::uint32_t corner : soup.face(f)) text += std::to_string(corner) + " ";
        text += "|";
    }
    return text;
}

/// A soup that keeps what its comment promises.
inline void expect_sound(const PolygonSoup& soup) {
    for (const Vec3& p : soup.points) EXPECT_TRUE(p.allFinite());
    for (const std::uint32_t corner : soup.corners) EXPECT_LT(corner, soup.points.size());
    std::size_t last = 0;
    for (const std::size_t end : soup.face_ends) {
        EXPECT_GE(end, last + 3);
        last = end;
    }
    EXPECT_EQ(last, soup.corners.size());
}

/// The bytes of a number, the lowest first.
inline std::string bytes_of(const auto& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

}  // namespace dem::shapegen
