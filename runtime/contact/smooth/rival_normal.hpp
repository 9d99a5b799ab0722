// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/smooth/common_normal.hpp"

#include <optional>

/// Other minima of f (common_normal.hpp) beside a known one. The overlap of two bodies is the least
/// of them. Bodies with edges that overlap have several where edges lie along each other: the edge
/// may be left over either of the faces that meet in it. As the bodies move another one becomes
/// the least, and the one that was it may vanish while f there is far from the least: whoever
/// followed one minimum would lose energy (docs/contact.md, "Several minima").
namespace dem::runtime {

/// Radius of a ball that fits into a body and touches its surface at a support point, and at those
/// half of the room away: a lower bound [m].
inline double ball_within(const SupportBounds& bounds, const SupportSample& s) {
    const double room = 0.5 * std::min(s.room, 1.0);
    return std::max(bounds.shortest_radius, bounds.ball_slope * s.along() * room);
}

/// Whether the cross-sections of both bodies at their support points prove that no other minimum is
/// as low as the one at p.
bool is_least_by_crossing(const NormalProbe& p, const SrSupport& i, const SrSupport& j,
                          const Vec3& d);

/// Whether no other minimum of f is as low as the one at p, or at a place so near that none of the
/// pieces ends half way to it. False where that is not certain.
inline bool is_least(const NormalProbe& p, const SrSupport& i, const SrSupport& j, const Vec3& d) {
    return ball_within(i.map.bounds, p.i) + ball_within(j.map.bounds, p.j) >= p.f ||
           is_least_by_crossing(p, i, j, d);
}

/// The lowest other minimum, if there is one no higher than `highest` [m].
std::optional<NormalProbe> rival_normal(const NormalProbe& p, const SrSupport& i,
                                        const SrSupport& j, const Vec3& d, double highest);

}  // namespace dem::runtime
