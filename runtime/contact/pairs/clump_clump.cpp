// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_clump.hpp"

#include "runtime/contact/fields/clump_contact.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

/// Distance between the bounding balls of two sets of spheres [m].
double bounding_gap(const PlacedSpheres& i, const PlacedSpheres& j) {
    const Clump::Ball a = i.bound();
    const Clump::Ball b = j.bound();
    return (i.place(a.center()) - j.place(b.center())).norm() - a.radius - b.radius;
}

ContactPoint point_of(std::uint32_t a, std::uint32_t b, const SpherePairs::Sample& s) {
    const double overlap = -s.distance;
    // Coincident centers have no normal: any will do, the overlap check stops such a run.
    const Vec3 n = s.centers > 0.0 ? Vec3(s.from_j / s.centers) : Vec3::UnitZ();
    return {s.center_i - (s.radius_i - 0.5 * overlap) * n, n, overlap, std::uint64_t{a} << 32 | b};
}

PairContact between(const PlacedSpheres& i, const PlacedSpheres& j, const PatchCall& call) {
    const double smaller = std::min(i.bound().radius, j.bound().radius);
    const double larger = std::max(i.bound().radius, j.bound().radius);
    const double margin = list_margin(smaller);
    const double rounding = clump_rounding(larger);
    if (call.travel >= call.memory.cache.listed_until) {
        const double gap = bounding_gap(i, j) - rounding;
        if (gap > margin) return apart(call, gap);
    }
    const SpherePairs pairs{i, j, rounding};
    const auto touching =
        touching_spheres(pairs, margin, call, [&](std::uint32_t k, const auto& sample) {
            return point_of(k / j.count(), k % j.count(), sample);
        });
    const SpherePairs::Sample& deepest = touching.deepest;
    const double radius = touching.points.empty() ? 0.0
                                                  : deepest.radius_i * deepest.radius_j /
                                                        (deepest.radius_i + deepest.radius_j);
    return contact_force(touching.points, radius, call);
}

}  // namespace

PairContact collide(const Clump& a, const Clump& b, const PatchCall& call) {
    const PairState& pair = call.pair;
    return between({a, pair.i.orientation, Vec3::Zero()},
                   {b, pair.j.orientation, pair.displacement}, call);
}

PairContact collide(const Sphere& a, const Clump& b, const PatchCall& call) {
    const PairState& pair = call.pair;
    const ClumpSphere sphere{0.0, 0.0, 0.0, a.radius, 0.0};
    return between({{&sphere, 1}, {}, Quat::Identity(), Vec3::Zero()},
                   {b, pair.j.orientation, pair.displacement}, call);
}

}  // namespace dem::runtime
