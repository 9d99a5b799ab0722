// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/broad_phase/body_aabb.hpp"
#include "runtime/contact/lanes/lane_kernels.hpp"
#include "runtime/narrow_phase/bodies.hpp"
#include "runtime/narrow_phase/pair_list.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::runtime {

/// A contact that ended, booked on the first particle of its pair.
struct Parting {
    std::uint32_t particle;
    double lost;  ///< what its springs still held [J]
};

/// The contacts of every particle as indices of results, in the order in which they are summed:
/// partners by rising id, then walls in the order of the case file.
struct Adjacency {
    struct Entry {
        std::uint32_t result : 31;
        std::uint32_t is_j : 1;  ///< the particle is the second of its pair
    };
    std::vector<std::uint32_t> begin;  ///< particles + 1
    std::vector<Entry> entries;

    /// None for a particle added since the lists were made.
    std::span<const Entry> of(std::uint32_t particle) const {
        if (particle + 1 >= begin.size()) return {};
        return {entries.data() + begin[particle], entries.data() + begin[particle + 1]};
    }
};

/// The entries of an adjacency whose pairs touch, in the same order, kept from step to step: few
/// contacts begin or end in one. Particles whose contacts did are `changed`.
struct TouchingEntries {
    std::vector<Adjacency::Entry> entries;  ///< room as in the adjacency, filled from each begin
    std::vector<std::uint32_t> count;       ///< per particle
    std::vector<std::uint8_t> changed;      ///< flag per particle

    void reset(const Adjacency& adjacency) {
        entries.resize(adjacency.entries.size());
        count.assign(adjacency.begin.size() - 1, 0);
        changed.assign(count.size(), 1);
    }

    /// Brought up to date first where need be; different particles may be asked for at once.
    std::span<const Adjacency::Entry> of(std::uint32_t particle, const Adjacency& adjacency,
                                         std::span<const std::uint8_t> touching) {
        if (particle >= count.size()) return {};
        Adjacency::Entry* const first = entries.data() + adjacency.begin[particle];
        if (changed[particle] != 0) {
            std::uint32_t n = 0;
            for (const Adjacency::Entry entry : adjacency.of(particle)) {
                first[n] = entry;
                n += touching[entry.result];
            }
            count[particle] = n;
            changed[particle] = 0;
        }
        return {first, count[particle]};
    }
};

/// Neighbor lists: every pair that may touch until some body has used up its margin, sorted into
/// one list per pair of shape kinds. Results do not depend on when lists are made.
struct NeighborLists {
    ParticlePairs::Lists<PairList> pairs;
    WallPairs::Lists<PairList> walls;
    Adjacency adjacency;
    TouchingEntries touching_entries;
    std::vector<PairResult> results;     ///< of all lists, one after the other
    std::vector<std::uint8_t> touching;  ///< flag per result
    std::vector<double> particle_limit;  ///< travel up to which the lists hold [m]
    std::vector<double> wall_limit;
    std::uint64_t rebuilds = 0;
};

/// Calls f(list) for every list: pairs of particles first, then those with walls, in the order of
/// their rows.
template <class Lists, class Each>
void for_each_list(Lists& lists, const Each& f) {
    std::apply([&](auto&... list) { (f(list), ...); }, lists);
}
template <class ListsOrConst, class Each>
requires std::is_same_v<std::remove_const_t<ListsOrConst>, NeighborLists>
void for_each_list(ListsOrConst& lists, const Each& f) {
    for_each_list(lists.pairs, f);
    for_each_list(lists.walls, f);
}

/// True when a body has been added or has moved farther than its margin.
bool is_stale(const NeighborLists& lists, const Bodies& bodies);

/// Makes new lists for the bodies where they are now. `margins`: how far each particle may move
/// before the next rebuild [m]; `wall_margins`: the same for the walls.
void rebuild(NeighborLists& lists, const Bodies& bodies, const BodyAabbs& aabbs,
             std::span<const double> margins, std::span<const double> wall_margins);

/// Takes the marked bodies out with all their pairs; what the others remember, their results and
/// limits stay. Bodies after them move up, as in Particles::remove. Returns what the springs of the
/// contacts held that end by that [J].
double remove_bodies(NeighborLists& lists, std::span<const std::uint8_t> leaving);

/// Makes the adjacency of lists that were filled by hand, one after the other from the first on.
void index_contacts(NeighborLists& lists, std::uint32_t particles);

}  // namespace dem::runtime
