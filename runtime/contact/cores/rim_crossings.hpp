// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/features.hpp"
#include "runtime/contact/cores/placed_core.hpp"
#include "runtime/contact/cores/round_features.hpp"

namespace dem::runtime {

/// Radius about the lines of a core [m]: edges are as thick as the rounding, the axis of a cylinder
/// as its side.
inline double line_thickness(const PlacedCore& core) {
    return core.has_vertices() ? core.rounding : core.rounding + core.shape.size.x;
}

/// Where the lines of edges of the other body, or the side of a cylinder, pass over the rim of an
/// end: the corners of the patch in which an end and a face, or a side, meet. The point p of the
/// edge straight above the rim is as far from the end as it is high, and moves along the edge with
/// the bodies:
///     d height / dt = w . (a - m (e.a) / (e.m))
/// w velocity of the edge relative to the end at p, a outward normal of the end, e direction of the
/// edge, m outward normal of the rim at p in the plane of the end.
class RimCrossings {
  public:
    /// `other`: the core with the lines, `sign`: 1 where that is of i, -1 of j.
    RimCrossings(const PlacedCap& cap, const PlacedCore& other, double sign)
        : cap_(cap),
          outward_(cap.axis),
          sign_(sign),
          thickness_(line_thickness(other)),
          reach_(cap.rounding + thickness_),
          is_thick_(!other.has_vertices()) {
        if (is_thick_) {
            lying_from_ = 1.0 - square(largest_tilt);
            lying_range_ = 0.75 * square(largest_tilt);
        }
    }

    void add(const EdgeLine& line, FeatureSum& features) const;

  private:
    void add_at(const EdgeLine& edge, double t, const Vec3& nearest, FeatureSum& features) const;
    /// A number that grows by `by` . (velocity of the edge relative to the end at x).
    void add_shift(const Vec3& x, const Vec3& by, const FeatureSum& features,
                   PairGradient& g) const;
    /// The part of a line in which the side of its cylinder touches an end that is no more tilted.
    EdgeLine without_ends(const EdgeLine& line) const;

    /// Up to this tilt the side of a cylinder counts as lying on an end [rad].
    static constexpr double largest_tilt = 0.05;

    const PlacedCap& cap_;
    Vec3 outward_;
    double sign_;       ///< of the body with the edges
    double thickness_;  ///< of those [m]
    double reach_;
    bool is_thick_;  ///< the side of a cylinder: counts where it lies nearly flat on the end
    double lying_from_ = 0.0, lying_range_ = 0.5;  ///< squared sines over which they fade in
};

}  // namespace dem::runtime
