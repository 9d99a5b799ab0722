// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/broad_phase/hierarchical_grid.hpp"
#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/contact/pairs/pair_table.hpp"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace dem::runtime {

/// Candidate pairs of one row of the table of pairs: particle i and particle or wall j. What a pair
/// keeps between steps is carried from list to list; only touching pairs have a history.
template <class PairRow>
struct PairList {
    using Row = PairRow;
    using A = typename Row::A;
    using B = typename Row::B;
    using History = typename Row::History;
    using Cache = typename Row::Cache;
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr double never_quiet = -1.0;
    static constexpr bool has_walls = AnyWall<B>;

    std::vector<IdPair> ids;  ///< sorted
    /// The pair cannot touch before the travels of its two bodies add up to this [m].
    std::vector<double> quiet_until;
    std::vector<std::uint32_t> history_of;  ///< index into `histories`, or none
    std::vector<History> histories;
    std::vector<std::uint32_t> vacant;  ///< places in `histories` of contacts that ended
    std::vector<Cache> caches;
    std::vector<ForceParts> parts;  ///< of pairs with walls, in the last step
    /// What one thread saw begin and end in this step: places change hands after all threads.
    struct NewContact {
        std::uint32_t pair;
        History history;
    };
    struct EndedContact {
        std::uint32_t pair;
        double lost;  ///< [J]
    };
    struct Changes {
        std::vector<NewContact> begun;
        std::vector<EndedContact> ended;
    };
    std::vector<Changes> changes;    ///< per thread
    std::uint32_t first_result = 0;  ///< where this list's part of the results begins

    std::uint32_t size() const { return static_cast<std::uint32_t>(ids.size()); }

    void reset(std::vector<IdPair> sorted_ids, std::uint32_t first) {
        ids = std::move(sorted_ids);
        quiet_until.assign(ids.size(), never_quiet);
        history_of.assign(ids.size(), none);
        histories.clear();
        vacant.clear();
        caches.assign(ids.size(), Cache{});
        if constexpr (has_walls) parts.assign(ids.size(), ForceParts{});
        first_result = first;
    }

    void add_history(std::uint32_t pair, const History& history) {
        if (!vacant.empty()) {
            history_of[pair] = vacant.back();
            vacant.pop_back();
            histories[history_of[pair]] = history;
            return;
        }
        // The largest array of a run: doubling would leave half of it empty.
        if (histories.size() == histories.capacity())
            histories.reserve(histories.size() + histories.size() / 8 + 16);
        history_of[pair] = static_cast<std::uint32_t>(histories.size());
        histories.push_back(history);
    }
    void drop_history(std::uint32_t pair) {
        vacant.push_back(history_of[pair]);
        history_of[pair] = none;
    }
};

/// Takes over what the pairs of `old` remember by walking both sorted lists at once. Whether a pair
/// has a history the list itself says: the flags of what touches are of the last step, and lists
/// may be made twice between two steps.
template <class List>
void carry_over(const List& old, List& list) {
    std::uint32_t o = 0;
    for (std::uint32_t k = 0; k < list.size(); ++k) {
        while (o < old.size() && old.ids[o] < list.ids[k]) ++o;
        if (o == old.size()) return;
        if (old.ids[o] != list.ids[k]) continue;
        list.quiet_until[k] = old.quiet_until[o];
        list.caches[k] = old.caches[o];
        const std::uint32_t history = old.history_of[o];
        if (history != List::none) list.add_history(k, old.histories[history]);
    }
}

}  // namespace dem::runtime
