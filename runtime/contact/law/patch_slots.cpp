// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/law/patch_slots.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

struct Chosen {
    std::uint32_t point;
    std::uint32_t slot;  ///< old place, or none
};
constexpr std::uint32_t none = PatchHistory::slot_count;

/// The `room` deepest of the points that are not among the first `kept` of `chosen` (rising).
std::size_t add_deepest(std::span<const ContactPoint> points, std::size_t kept, std::size_t room,
                        std::array<Chosen, PatchHistory::slot_count>& chosen) {
    std::size_t count = kept;
    std::size_t next_kept = 0;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        if (next_kept < kept && chosen[next_kept].point == k) {
            ++next_kept;
            continue;
        }
        if (points[k].overlap < 0.0) continue;
        // Sorted by depth; an equal one that came first has the lower feature and stays in front.
        std::size_t place = count;
        while (place > kept && points[chosen[place - 1].point].overlap < points[k].overlap) --place;
        if (place == kept + room) continue;
        count = std::min(count + 1, kept + room);
        for (std::size_t m = count - 1; m > place; --m) chosen[m] = chosen[m - 1];
        chosen[place] = {k, none};
    }
    return count;
}

}  // namespace

namespace {

/// Nothing came or went: the case on most steps.
bool is_unchanged(std::span<const ContactPoint> points, const PatchHistory& history) {
    if (points.size() != history.used) return false;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k].feature != history.slots[k].feature) return false;
    return true;
}

}  // namespace

PatchSlots choose_slots(std::span<const ContactPoint> points, PatchHistory& history) {
    PatchSlots result;
    if (is_unchanged(points, history)) {
        result.count = points.size();
        for (std::uint32_t k = 0; k < result.count; ++k) {
            result.point[k] = k;
            result.known[k] = true;
        }
        return result;
    }
    std::array<Chosen, PatchHistory::slot_count> chosen;  // NOLINT: filled up to `count`
    std::size_t count = 0;
    std::uint32_t slot = 0;
    for (std::uint32_t k = 0; k < points.size() && slot < history.used; ++k) {
        while (slot < history.used && history.slots[slot].feature < points[k].feature) ++slot;
        if (slot < history.used && history.slots[slot].feature == points[k].feature)
            chosen[count++] = {k, slot++};
    }
    if (count < PatchHistory::slot_count && count < points.size())
        count = add_deepest(points, count, PatchHistory::slot_count - count, chosen);
    const auto end = chosen.begin() + static_cast<std::ptrdiff_t>(count);
    std::sort(chosen.begin(), end,
              [](const Chosen& a, const Chosen& b) { return a.point < b.point; });

    result.count = count;
    const auto old = history.slots;
    for (std::size_t k = 0; k < count; ++k) {
        result.point[k] = chosen[k].point;
        result.known[k] = chosen[k].slot != none;
        if (result.known[k]) history.slots[k] = old[chosen[k].slot];
    }
    for (std::size_t k = count; k < history.used; ++k) history.slots[k] = {};
    return result;
}

}  // namespace dem::runtime
