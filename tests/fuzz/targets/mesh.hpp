// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/repair/polygon_soup.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>

namespace dem::fuzz {

using namespace shapegen;

using ReadMesh = PolygonSoup (*)(Bytes, const std::string&);

/// Reads a whole mesh file and looks at all that it holds. Whether the bytes were accepted.
inline bool reads_mesh(ReadMesh read, Bytes bytes) {
    static const std::array<std::string, 1> places = {"x:"};
    return accepts(places, [&] {
        const PolygonSoup soup = read(bytes, "x");
        for (const Vec3& p : soup.points) promise_finite(p, "a point");
        for (const std::uint32_t corner : soup.corners)
            promise(corner < soup.points.size(), "a corner is a point");
        std::size_t last = 0;
        for (const std::size_t end : soup.face_ends) {
            promise(end >= last + 3, "a face has three corners or more");
            last = end;
        }
        promise(last == soup.corners.size(), "every corner belongs to a face");
        for (const std::string& note : soup.notes) check_line(note);
    });
}

}  // namespace dem::fuzz
