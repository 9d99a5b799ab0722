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
        : lists_(lists), leaving_(leaving), index_(leaving.size()) {
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
            lists_.results[results_] = lists_.results[result];
            lists_.touching[results_] = lists_.touching[result];
            ++kept;
            ++results_;
        }
        list.ids.resize(kept);
        list.quiet_until.resize(kept);
        list.history_of.resize(kept);
        list.caches.resize(kept);
        list.first_result = first;
    }

    NeighborLists& lists_;
    std::span<const std::uint8_t> leaving_;
    std::vector<std::uint32_t> index_;  ///< of each body that stays, among those
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
    index_contacts(lists, static_cast<std::uint32_t>(lists.particle_limit.size()));
    return removal.elastic_energy();
}

}  // namespace dem::runtime
