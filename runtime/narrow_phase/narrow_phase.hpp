// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/narrow_phase/lane_work.hpp"
#include "runtime/narrow_phase/neighbor_lists.hpp"
#include "runtime/narrow_phase/seen_contacts.hpp"

#include <vector>

namespace dem::runtime {

/// The pair that overlaps most, measured by the smaller radius (of the sphere of equal volume) of
/// its two bodies.
struct LargestOverlap {
    double relative = 0.0;
    IdPair ids{0, 0};
    bool is_wall = false;  ///< ids.j is a wall
};

/// Room that the narrow phase works in, kept from step to step: nothing is allocated in a step.
struct NarrowPhaseScratch {
    struct Thread {
        LargestOverlap largest;
        std::uint32_t largest_result = 0;  ///< of the pair, as an index of results
        std::uint64_t cores_met = 0;
        ContactScratch points;
        ConvexScratch convex;
        LaneBlock block;
        std::vector<PairContact> several;
        std::vector<SeenContact> seen;
    };
    std::vector<Thread> threads;
    std::vector<double> equivalent_radius;  ///< per kind [m]
    LaneBodies lanes;
    std::uint64_t cores_met = 0;    ///< contacts in which the cores of convex bodies have come to
                                    ///< overlap, in the last call
    std::vector<Parting> partings;  ///< contacts that ended in the last call
    Looks looks = Looks::at_none;   ///< what the next call notes
    /// The contacts that the last call noted: those of particles by rising ids, then those with
    /// walls by rising id of the particle. A particle may touch a wall of triangles several times.
    std::vector<SeenContact> seen;
};

/// What went in lanes in the last call.
struct LaneUse {
    int width = 1;               ///< contacts computed at a time
    std::uint64_t contacts = 0;  ///< that kernels were given
    std::uint64_t rare = 0;      ///< of them left to be computed one by one
};
LaneUse lane_use(const NarrowPhaseScratch& scratch);

/// For so many threads at most.
NarrowPhaseScratch make_scratch(const Scene& scene, std::size_t threads);

/// Computes every contact of the lists at the present state (dt: the step that led here) and fills
/// the results. Each pair is computed by itself, so the number of threads changes nothing.
LargestOverlap compute_contacts(NeighborLists& lists, const Bodies& bodies, double dt,
                                NarrowPhaseScratch& scratch);

}  // namespace dem::runtime
