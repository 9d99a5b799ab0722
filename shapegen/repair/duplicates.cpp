// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/duplicates.hpp"

#include "shapegen/repair/soup_cleaning.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace dem::shapegen {
namespace {

/// A triangle by the place that it takes.
struct Placed {
    std::array<std::uint32_t, 3> corners;  ///< in rising order
    bool is_even;                          ///< turns like them
    std::size_t index;

    bool operator<(const Placed& other) const {
        return std::tie(corners, is_even, index) <
               std::tie(other.corners, other.is_even, other.index);
    }
};

std::vector<Placed> by_place(const TriangleSoup& soup) {
    std::vector<Placed> sorted;
    sorted.reserve(soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& corners = soup.triangles[t];
        auto key = corners;
        std::sort(key.begin(), key.end());
        const auto start = std::find(corners.begin(), corners.end(), key[0]) - corners.begin();
        sorted.push_back({key, corners[static_cast<std::size_t>(start + 1) % 3] == key[1], t});
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

}  // namespace

void remove_duplicates(TriangleSoup& soup, RepairReport& report) {
    const std::vector<Placed> sorted = by_place(soup);
    std::vector<bool> is_kept(soup.triangles.size(), false);
    std::vector<std::size_t> first_of_pairs;  // places with as many triangles one way as the other
    Finding alike{.what = "duplicate triangles", .treatment = "removed"};
    Finding opposite{.what =
                         "triangles that face each other in one place, as of flaps and of "
                         "faces between parts",
                     .treatment = "removed"};
    const auto note = [&soup](Finding& finding, std::size_t triangle, std::size_t count) {
        if (finding.count == 0) finding.place = soup.points[soup.triangles[triangle][0]];
        finding.count += count;
    };
    bool is_any_kept = false;
    for (std::size_t first = 0; first < sorted.size();) {
        std::size_t end = first;
        std::size_t odd = 0;
        while (end < sorted.size() && sorted[end].corners == sorted[first].corners)
            odd += sorted[end++].is_even ? 0 : 1;
        const std::size_t even = end - first - odd;  // sorted after the odd ones
        if (odd == even) {
            first_of_pairs.push_back(std::min(sorted[first].index, sorted[first + odd].index));
            note(opposite, first_of_pairs.back(), end - first);
        } else {
            const std::size_t kept = sorted[odd > even ? first : first + odd].index;
            is_kept[kept] = is_any_kept = true;
            note(alike, kept, end - first - 1);
        }
        first = end;
    }
    if (!is_any_kept) {
        for (const std::size_t t : first_of_pairs) is_kept[t] = true;
        opposite.what = "triangles of a body that is drawn on both sides";
        opposite.count -= first_of_pairs.size();
    }
    keep_triangles(soup, is_kept);
    report.add(alike);
    report.add(opposite);
}

}  // namespace dem::shapegen
