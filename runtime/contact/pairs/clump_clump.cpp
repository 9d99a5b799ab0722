// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/pairs/clump_clump.hpp"

#include "runtime/contact/fields/clump_contact.hpp"

#include <algorithm>

namespace dem {

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

PairContact between(const PlacedSpheres& i, const PlacedSpheres& j, const NodeCall& call) {
    const NodeMemory& memory = call.memory;
    const double smaller = std::min(i.bound().radius, j.bound().radius);
    const double larger = std::max(i.bound().radius, j.bound().radius);
    const double margin = list_margin(smaller);
    const double rounding = clump_rounding(larger);
    if (memory.travel >= memory.cache.listed_until) {
        const double gap = bounding_gap(i, j) - rounding;
        if (gap > margin) return keep_apart(gap, memory);
    }
    const SpherePairs pairs{i, j, rounding};
    const auto touching =
        touching_spheres(pairs, margin, memory, [&](std::uint32_t k, const auto& sample) {
            return point_of(k / j.count(), k % j.count(), sample);
        });
    const SpherePairs::Sample& deepest = touching.deepest;
    const double radius = touching.points.empty() ? 0.0
                                                  : deepest.radius_i * deepest.radius_j /
                                                        (deepest.radius_i + deepest.radius_j);
    return contact_force(touching.points, radius, call);
}

ClumpSphere as_clump(const Sphere& sphere) {
    return {0.0, 0.0, 0.0, sphere.radius, 0.0};
}

}  // namespace

PairContact collide(const Clump& a, const Clump& b, const PairState& pair, const ContactLaw& law,
                    double dt, const NodeMemory& memory) {
    return between({a, pair.i.orientation, Vec3::Zero()},
                   {b, pair.j.orientation, pair.displacement}, {pair, law, dt, memory});
}

PairContact collide(const Sphere& a, const Clump& b, const PairState& pair, const ContactLaw& law,
                    double dt, const NodeMemory& memory) {
    const ClumpSphere sphere = as_clump(a);
    return between({{&sphere, 1}, {}, Quat::Identity(), Vec3::Zero()},
                   {b, pair.j.orientation, pair.displacement}, {pair, law, dt, memory});
}

PairContact collide(const Clump& a, const Sphere& b, const PairState& pair, const ContactLaw& law,
                    double dt, const NodeMemory& memory) {
    const ClumpSphere sphere = as_clump(b);
    return between({a, pair.i.orientation, Vec3::Zero()},
                   {{&sphere, 1}, {}, Quat::Identity(), pair.displacement},
                   {pair, law, dt, memory});
}

}  // namespace dem
