// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/narrow_phase/narrow_phase.hpp"

#include "common/threads/thread_team.hpp"
#include "runtime/contact/fields/clump_contact.hpp"
#include "runtime/contact/walls/wall_work.hpp"
#include "runtime/loop_grain.hpp"
#include "runtime/walls/wall_distance.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

// ---- What differs between pairs of particles and pairs with walls.

struct ParticlePartner {
    static constexpr bool is_wall = false;
    const Bodies& bodies;
    std::span<const double> radius;  // equivalent, per kind

    template <class B>
    const B& shape(std::uint32_t j) const {
        return *std::get_if<B>(&bodies.shape(j).shape);
    }
    double travel(std::uint32_t j) const { return bodies.particles.travel[j]; }
    PairState pair(const IdPair& ids) const { return bodies.pair(ids.i, ids.j); }
    const ContactLaw& law(const IdPair& ids) const { return bodies.law(ids.i, ids.j); }
    double smaller_radius(const IdPair& ids) const {
        const auto& kind = bodies.particles.kind;
        return std::min(radius[kind[ids.i]], radius[kind[ids.j]]);
    }
    static double work(const PairState&, const PairContact&, double) { return 0.0; }
    static const LaneRow& lane_row(const LaneBodies& lanes, std::uint32_t j) {
        return lanes.rows[j];
    }
    const LaneKind& lane_kind(const LaneBodies& lanes, std::uint32_t j) const {
        return lanes.kinds[bodies.particles.kind[j]];
    }
};

struct WallPartner {
    static constexpr bool is_wall = true;
    const Bodies& bodies;
    std::span<const double> radius;

    template <class B>
    const B& shape(std::uint32_t j) const {
        return *std::get_if<B>(&bodies.scene.walls[j].shape);
    }
    double travel(std::uint32_t j) const { return bodies.walls.travel[j]; }
    PairState pair(const IdPair& ids) const { return bodies.wall_pair(ids.i, ids.j); }
    const ContactLaw& law(const IdPair& ids) const { return bodies.wall_law(ids.i, ids.j); }
    double smaller_radius(const IdPair& ids) const { return radius[bodies.particles.kind[ids.i]]; }
    static double work(const PairState& pair, const PairContact& contact, double dt) {
        return wall_work(pair, contact, dt);
    }
    static const LaneRow& lane_row(const LaneBodies& lanes, std::uint32_t j) {
        return lanes.wall_rows[j];
    }
    static const LaneKind& lane_kind(const LaneBodies& lanes, std::uint32_t j) {
        return lanes.wall_kinds[j];
    }
};

// Travels and positions are long sums, each term rounded: a little less than the gap is certain.
double certain_travel(double travel, double gap, double radius) {
    return travel * (1.0 - 1e-13) + gap - 1e-9 * radius;
}

/// Keeps the larger overlap; of equal ones, which symmetric scenes have, that of the earlier
/// result.
void keep_larger(NarrowPhaseScratch::Thread& thread, const LargestOverlap& overlap,
                 std::uint32_t result) {
    const bool is_larger = overlap.relative > thread.largest.relative;
    const bool is_earlier =
        overlap.relative == thread.largest.relative && result < thread.largest_result;
    if (!is_larger && !is_earlier) return;
    thread.largest = overlap;
    thread.largest_result = result;
}

// ---- The work of one thread on one list.

template <class List, class Partner>
struct Worker {
    List& list;
    NeighborLists& lists;
    const Partner partner;
    double dt;
    typename List::Changes& changes;
    NarrowPhaseScratch::Thread& scratch;
    bool looks;

    using A = typename List::A;
    using B = typename List::B;

    /// Whether the first of a pair is the second of the list's row.
    bool reverses(const IdPair& ids) const {
        if constexpr (Partner::is_wall || std::is_same_v<A, B>) return false;
        return !std::holds_alternative<A>(partner.bodies.shape(ids.i).shape);
    }

    // Distance of a pair that does not touch, at least; <= 0 when nothing is known [m].
    double gap(const A& a, const B& b, std::uint32_t k, double travel) const {
        const IdPair ids = list.ids[k];
        const auto& position = partner.bodies.particles.position;
        if constexpr (std::is_same_v<typename List::Cache, MissCache>) {
            return list.caches[k].gap;
        } else if constexpr (std::is_same_v<typename List::Cache, NearCache>) {
            return list.caches[k].clear_until - travel;
        } else if constexpr (Partner::is_wall) {
            return wall_distance(b, partner.bodies.walls.state[ids.j], position[ids.i]) - a.radius;
        } else {
            return (position[ids.j] - position[ids.i]).norm() - a.radius - b.radius;
        }
    }

    void compute(std::uint32_t k) {
        const IdPair ids = list.ids[k];
        const Bodies& bodies = partner.bodies;
        const double travel = bodies.particles.travel[ids.i] + partner.travel(ids.j);
        if (travel < list.quiet_until[k]) return;

        const bool is_new = list.history_of[k] == List::none;
        typename List::History fresh{};
        auto& history = is_new ? fresh : list.histories[list.history_of[k]];
        const Memory memory{history, list.caches[k]};
        const PairState pair = partner.pair(ids);
        const ContactLaw& law = partner.law(ids);
        scratch.several.clear();
        const Scratch room{&scratch.points, &scratch.convex, looks ? &scratch.several : nullptr};
        const bool is_reversed = reverses(ids);
        const auto& a = *std::get_if<A>(&bodies.shape(is_reversed ? ids.j : ids.i).shape);
        const B& b = partner.template shape<B>(is_reversed ? ids.i : ids.j);
        const PairContact contact =
            is_reversed
                ? reversed(collide(a, b, Call{reversed(pair), law, dt, memory, travel, room}),
                           pair.displacement)
                : collide(a, b, Call{pair, law, dt, memory, travel, room});

        const std::uint32_t r = list.first_result + k;
        lists.touching[r] = contact.touches() ? 1 : 0;
        if (!contact.touches()) {
            if (!is_new) changes.ended.push_back({k, contact.dissipated_energy});
            list.quiet_until[k] =
                certain_travel(travel, gap(a, b, k, travel), partner.smaller_radius(ids));
            return;
        }
        lists.results[r] = {
            contact.force,          contact.torque_i,          contact.torque_j,
            contact.elastic_energy, contact.dissipated_energy, partner.work(pair, contact, dt)};
        if constexpr (List::has_walls)
            list.parts[k] = {contact.normal_force, contact.friction.norm()};
        list.quiet_until[k] = List::never_quiet;
        if (contact.cores_met) ++scratch.cores_met;
        if (looks) {
            if (scratch.several.empty()) scratch.several.push_back(contact);
            note(scratch.several, {ids, Partner::is_wall, is_new}, partner.bodies, scratch.seen);
        }
        if (is_new) changes.begun.push_back({k, fresh});
        look_at_overlap(contact.overlap, ids, r);
    }

    void look_at_overlap(double overlap, const IdPair& ids, std::uint32_t result) {
        const double relative = overlap / partner.smaller_radius(ids);
        if (relative >= scratch.largest.relative)
            keep_larger(scratch, {relative, ids, Partner::is_wall}, result);
    }

    // ---- In lanes.

    /// Whether a pair touched in the step before, in a way and under a law that kernels know.
    bool goes_on(std::uint32_t k) const {
        if (list.history_of[k] == List::none) return false;
        const IdPair ids = list.ids[k];
        if constexpr (std::is_same_v<B, CylinderWall>) {
            // Kernels know the inside.
            if (!partner.template shape<B>(ids.j).inside) return false;
        }
        return is_one_point(list.histories[list.history_of[k]]) && runs_in_lanes(partner.law(ids));
    }

    void add_to_block(std::uint32_t k, const LaneBodies& lanes) {
        const IdPair ids = list.ids[k];
        auto& history = list.histories[list.history_of[k]];
        LaneBlock& block = scratch.block;
        block.pair[block.count] = k;
        block.contacts[block.count++] = {&lanes.rows[ids.i],
                                         &partner.lane_row(lanes, ids.j),
                                         &lanes.kinds[partner.bodies.particles.kind[ids.i]],
                                         &partner.lane_kind(lanes, ids.j),
                                         &partner.law(ids),
                                         &history,
                                         &spring_of(history),
                                         &lists.results[list.first_result + k],
                                         List::has_walls ? &list.parts[k] : nullptr};
    }

    /// Computes what the block holds, the rare ones among it one by one.
    void compute_block(LaneKernel kernel) {
        LaneBlock& block = scratch.block;
        kernel({block.contacts.data(), block.count}, dt, block.outcome);
        for (std::size_t n = 0; n < block.count; ++n) {
            const std::uint32_t k = block.pair[n];
            if ((block.outcome.done >> n & 1) != 0) {
                lists.touching[list.first_result + k] = 1;
                share_normal(list.histories[list.history_of[k]]);
                look_at_overlap(block.outcome.overlap[n], list.ids[k], list.first_result + k);
            } else {
                compute(k);
                ++block.rare;
            }
        }
        block.computed += block.count;
        block.count = 0;
    }

    void compute_in_lanes(std::uint32_t begin, std::uint32_t end, LaneKernel kernel,
                          const LaneBodies& lanes) {
        for (std::uint32_t k = begin; k < end; ++k) {
            if (!goes_on(k)) {
                compute(k);
                continue;
            }
            add_to_block(k, lanes);
            if (scratch.block.count == lane_block) compute_block(kernel);
        }
        compute_block(kernel);
    }
};

/// What one thread does of a list: its pairs whose results are in the part.
template <class Partner, class List>
void compute_part(List& list, NeighborLists& lists, const Partner& partner, double dt,
                  const LoopPart& part, NarrowPhaseScratch& scratch) {
    const std::size_t begin = std::max<std::size_t>(part.begin, list.first_result);
    const std::size_t end = std::min<std::size_t>(part.end, list.first_result + list.size());
    if (begin >= end) return;
    const bool looks =
        scratch.looks == Looks::at_all || (Partner::is_wall && scratch.looks == Looks::at_walls);
    Worker<List, Partner> worker{
        list, lists, partner, dt, list.changes[part.worker], scratch.threads[part.worker], looks};
    const auto first = static_cast<std::uint32_t>(begin) - list.first_result;
    const auto last = static_cast<std::uint32_t>(end) - list.first_result;
    constexpr LaneKernel LaneKernels::*kernel_of = kernel_of_row<typename List::Row>();
    if constexpr (kernel_of != nullptr) {
        const LaneKernel kernel = scratch.lanes.kernels->*kernel_of;
        // Kernels tell no more than a step needs.
        if (kernel != nullptr && !looks) {
            worker.compute_in_lanes(first, last, kernel, scratch.lanes);
            return;
        }
    }
    for (std::uint32_t k = first; k < last; ++k) worker.compute(k);
}

/// Gives places to the contacts that began, in the order of the list whichever thread saw them, and
/// takes those of the ones that ended.
template <class List, class Mark>
void settle_changes(List& list, std::vector<Parting>& partings, const Mark& mark) {
    auto& [begun, ended] = list.changes.front();
    for (std::size_t k = 1; k < list.changes.size(); ++k) {
        auto& other = list.changes[k];
        begun.insert(begun.end(), other.begun.begin(), other.begun.end());
        ended.insert(ended.end(), other.ended.begin(), other.ended.end());
        other.begun.clear();
        other.ended.clear();
    }
    // Mostly they are sorted: one thread goes through its share from front to back.
    const auto in_order = [](const auto& a, const auto& b) { return a.pair < b.pair; };
    if (!std::is_sorted(begun.begin(), begun.end(), in_order))
        std::sort(begun.begin(), begun.end(), in_order);
    if (!std::is_sorted(ended.begin(), ended.end(), in_order))
        std::sort(ended.begin(), ended.end(), in_order);
    for (const auto& contact : ended) {
        const IdPair ids = list.ids[contact.pair];
        list.drop_history(contact.pair);
        partings.push_back({ids.i, contact.lost});
        mark(ids);
    }
    for (const auto& contact : begun) {
        list.add_history(contact.pair, contact.history);
        mark(list.ids[contact.pair]);
    }
    begun.clear();
    ended.clear();
}

/// Whether contacts go on that a kernel may be for.
bool any_for_lanes(const NeighborLists& lists) {
    bool any = false;
    for_each_list(lists, [&]<class List>(const List& list) {
        if (kernel_of_row<typename List::Row>() == nullptr) return;
        any = any || list.histories.size() > list.vacant.size();
    });
    return any;
}

}  // namespace

NarrowPhaseScratch make_scratch(const Scene& scene, std::size_t threads) {
    NarrowPhaseScratch scratch;
    std::size_t most_points = 0;
    for (const ParticleTemplate& shape : scene.shapes) {
        const auto* sr = std::get_if<SrShape>(&shape.shape);
        if (sr != nullptr) most_points = std::max<std::size_t>(most_points, sr->nodes.count);
        const auto* clump = std::get_if<Clump>(&shape.shape);
        if (clump != nullptr) most_points = std::max(most_points, contact_room(*clump));
    }
    scratch.threads.resize(threads);
    for (auto& thread : scratch.threads) thread.points.resize(most_points);
    scratch.lanes = make_lane_bodies(scene);
    for (const BodyKind& kind : scene.kinds) {
        const double volume = scene.shapes[kind.shape].mass_properties.volume;
        scratch.equivalent_radius.push_back(0.5 * equivalent_diameter(volume));
    }
    return scratch;
}

LaneUse lane_use(const NarrowPhaseScratch& scratch) {
    LaneUse use{scratch.lanes.kernels->width};
    for (const auto& thread : scratch.threads) {
        use.contacts += thread.block.computed;
        use.rare += thread.block.rare;
    }
    return use;
}

namespace {

void gather_seen(NarrowPhaseScratch& scratch) {
    scratch.seen.clear();
    for (auto& thread : scratch.threads) {
        scratch.seen.insert(scratch.seen.end(), thread.seen.begin(), thread.seen.end());
        thread.seen.clear();
    }
    put_in_order(scratch.seen);
}

}  // namespace

LargestOverlap compute_contacts(NeighborLists& lists, const Bodies& bodies, double dt,
                                NarrowPhaseScratch& scratch) {
    for (auto& thread : scratch.threads) {
        thread.largest = {};
        thread.cores_met = 0;
        thread.block.computed = 0;
        thread.block.rare = 0;
    }
    if (scratch.lanes.in_use() && any_for_lanes(lists))
        update(scratch.lanes, bodies.particles, bodies.walls);
    const ParticlePartner particle{bodies, scratch.equivalent_radius};
    const WallPartner wall{bodies, scratch.equivalent_radius};
    const auto with_partners = [&](const auto& visit) {
        for_each_list(lists.pairs, [&](auto& list) { visit(list, particle); });
        for_each_list(lists.walls, [&](auto& list) { visit(list, wall); });
    };
    for_each_list(lists, [&](auto& list) { list.changes.resize(scratch.threads.size()); });
    // The results of all lists lie one after the other: one loop over them.
    share_loop(lists.results.size(), pairs_at_a_time, [&](const LoopPart& part) {
        with_partners([&](auto& list, const auto& partner) {
            compute_part(list, lists, partner, dt, part, scratch);
        });
    });
    scratch.partings.clear();
    with_partners([&]<class Partner>(auto& list, const Partner&) {
        settle_changes(list, scratch.partings, [&](const IdPair& ids) {
            lists.touching_entries.changed[ids.i] = 1;
            if constexpr (!Partner::is_wall) lists.touching_entries.changed[ids.j] = 1;
        });
    });

    NarrowPhaseScratch::Thread& first = scratch.threads.front();
    scratch.cores_met = first.cores_met;
    for (std::size_t k = 1; k < scratch.threads.size(); ++k) {
        const auto& thread = scratch.threads[k];
        keep_larger(first, thread.largest, thread.largest_result);
        scratch.cores_met += thread.cores_met;
    }
    gather_seen(scratch);
    return first.largest;
}

}  // namespace dem::runtime
