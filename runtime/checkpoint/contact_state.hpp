// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/checkpoint/state_archive.hpp"
#include "runtime/narrow_phase/neighbor_lists.hpp"
#include "runtime/narrow_phase/seen_contacts.hpp"

/// The contacts of neighbor lists in a checkpoint: of every list the pairs that touch, with what
/// they remember and what they did in the last step. A list is known by the name of its row.
/// Candidates that do not touch and caches change no bit and stay behind.
namespace dem::runtime {

template <>
inline constexpr bool is_plain<PairResult> = true;
template <>
inline constexpr bool is_plain<ForceParts> = true;
template <>
inline constexpr bool is_plain<SeenContact> = true;

template <class List>
struct TouchingPairs {
    std::vector<IdPair> ids;
    std::vector<typename List::History> histories;
    std::vector<PairResult> results;
    std::vector<ForceParts> parts;  ///< of pairs with walls

    static std::string name() { return "contacts." + List::Row::name(); }

    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit(name() + ".ids", self.ids);
        visit(name() + ".histories", self.histories);
        visit(name() + ".results", self.results);
        if constexpr (List::has_walls) visit(name() + ".parts", self.parts);
    }
};

template <class List>
void save_contacts(const NeighborLists& lists, const List& list, StateWriter& writer) {
    TouchingPairs<List> pairs;
    for (std::uint32_t k = 0; k < list.size(); ++k) {
        const std::uint32_t r = list.first_result + k;
        if (lists.touching[r] == 0) continue;
        pairs.ids.push_back(list.ids[k]);
        pairs.histories.push_back(list.histories[list.history_of[k]]);
        pairs.results.push_back(lists.results[r]);
        if constexpr (List::has_walls) pairs.parts.push_back(list.parts[k]);
    }
    if (!pairs.ids.empty()) TouchingPairs<List>::visit_state(pairs, writer);
}

/// Makes `list` the next of `lists`, holding the pairs of the checkpoint. `partners`: how many
/// particles or walls j may be.
template <class List>
void load_contacts(NeighborLists& lists, List& list, std::size_t particles, std::size_t partners,
                   StateReader& reader) {
    TouchingPairs<List> pairs;
    if (reader.has(TouchingPairs<List>::name() + ".ids")) pairs.visit_state(pairs, reader);
    bool is_fine = pairs.histories.size() == pairs.ids.size() &&
                   pairs.results.size() == pairs.ids.size() &&
                   pairs.parts.size() == (List::has_walls ? pairs.ids.size() : 0) &&
                   std::is_sorted(pairs.ids.begin(), pairs.ids.end());
    for (const IdPair& ids : pairs.ids) is_fine &= ids.i < particles && ids.j < partners;
    if (!is_fine) reader.fail("holds contacts that do not fit its particles");

    list.reset(std::move(pairs.ids), static_cast<std::uint32_t>(lists.results.size()));
    for (std::uint32_t k = 0; k < list.size(); ++k) list.add_history(k, pairs.histories[k]);
    if constexpr (List::has_walls) list.parts = std::move(pairs.parts);
    lists.results.insert(lists.results.end(), pairs.results.begin(), pairs.results.end());
    lists.touching.resize(lists.results.size(), 1);
}

inline void save_contacts(const NeighborLists& lists, StateWriter& writer) {
    for_each_list(lists, [&](const auto& list) { save_contacts(lists, list, writer); });
}

/// Lists of the touching pairs alone: the next step makes new ones and carries these over.
inline NeighborLists load_contacts(std::uint32_t particles, std::size_t walls,
                                   StateReader& reader) {
    NeighborLists lists;
    for_each_list(lists.pairs,
                  [&](auto& list) { load_contacts(lists, list, particles, particles, reader); });
    for_each_list(lists.walls,
                  [&](auto& list) { load_contacts(lists, list, particles, walls, reader); });
    index_contacts(lists, particles);
    return lists;
}

}  // namespace dem::runtime
