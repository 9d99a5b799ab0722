// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compact.hpp"
#include "runtime/narrow_phase/neighbor_lists.hpp"

#include <numeric>

namespace dem::runtime {

namespace {

/// Moves results up, list by list from the first on, as pairs leave.
class Removal {
  public:
    Removal(NeighborLists& lists, std::span<const std::uint8_t> leaving)
        : lists_(lists),
          leaving_(leaving),
          index_(leaving.size()),
          new_result_(lists.results.size(), none) {
        std::uint32_t kept = 0;
        for (std::size_t i = 0; i < leaving.size(); ++i) {
            index_[i] = kept;
            if (leaving[i] == 0) ++kept;
        }
    }

    void of_particles(auto& list) {
        from(
            list, [this](const IdPair& ids) { return index_[ids.j]; },
            [this](const IdPair& ids) { return leaving_[ids.j] != 0; });
    }
    void of_walls(auto& list) {
        from(
            list, [](const IdPair& ids) { return ids.j; },
            [](const IdPair& /*ids*/) { return false; });
    }

    /// Entries keep their order: partners by rising id, then walls.
    void of_adjacency() {
        Adjacency& adjacency = lists_.adjacency;
        std::uint32_t kept = 0;
        std::uint32_t kept_bodies = 0;
        for (std::uint32_t i = 0; i < leaving_.size(); ++i) {
            if (leaving_[i] != 0) continue;
            const std::uint32_t first = kept;
            for (std::uint32_t k = adjacency.begin[i]; k < adjacency.begin[i + 1]; ++k) {
                const Adjacency::Entry entry = adjacency.entries[k];
                if (new_result_[entry.result] == none) continue;
                adjacency.entries[kept++] = {new_result_[entry.result] & 0x7fffffffU, entry.is_j};
            }
            adjacency.begin[kept_bodies++] = first;
        }
        adjacency.begin[kept_bodies] = kept;
        adjacency.begin.resize(kept_bodies + 1);
        adjacency.entries.resize(kept);
        lists_.touching_entries.reset(adjacency);
    }

    std::uint32_t results() const { return results_; }
    double elastic_energy() const { return elastic_energy_; }

  private:
    template <class List, class NewPartner, class PartnerLeaves>
    void from(List& list, const NewPartner& new_partner, const PartnerLeaves& partner_leaves) {
        const std::uint32_t first = results_;
        std::uint32_t kept = 0;
        for (std::uint32_t k = 0; k < list.size(); ++k) {
            const IdPair ids = list.ids[k];
            const std::uint32_t result = list.first_result + k;
            if (leaving_[ids.i] != 0 || partner_leaves(ids)) {
                if (list.history_of[k] != List::none) list.drop_history(k);
                if (lists_.touching[result] != 0)
                    elastic_energy_ += lists_.results[result].elastic_energy;
                continue;
            }
            list.ids[kept] = {index_[ids.i], new_partner(ids)};
            list.quiet_until[kept] = list.quiet_until[k];
            list.history_of[kept] = list.history_of[k];
            list.caches[kept] = list.caches[k];
            if constexpr (List::has_walls) list.parts[kept] = list.parts[k];
            new_result_[result] = results_;
            lists_.results[results_] = lists_.results[result];
            lists_.touching[results_] = lists_.touching[result];
            ++kept;
            ++results_;
        }
        list.ids.resize(kept);
        list.quiet_until.resize(kept);
        list.history_of.resize(kept);
        list.caches.resize(kept);
        if constexpr (List::has_walls) list.parts.resize(kept);
        list.first_result = first;
    }

    NeighborLists& lists_;
    std::span<const std::uint8_t> leaving_;
    static constexpr std::uint32_t none = 0xffffffffU;
    std::vector<std::uint32_t> index_;       ///< of each body that stays, among those
    std::vector<std::uint32_t> new_result_;  ///< of each result that stays, or none
    std::uint32_t results_ = 0;
    double elastic_energy_ = 0.0;
};

}  // namespace

double remove_bodies(NeighborLists& lists, std::span<const std::uint8_t> leaving) {
    Removal removal(lists, leaving);
    for_each_list(lists.pairs, [&](auto& list) { removal.of_particles(list); });
    for_each_list(lists.walls, [&](auto& list) { removal.of_walls(list); });
    lists.results.resize(removal.results());
    lists.touching.resize(removal.results());
    compact(lists.particle_limit, leaving);
    removal.of_adjacency();
    return removal.elastic_energy();
}

}  // namespace dem::runtime
