// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/rim_crossings.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

/// Crossings fade where the line leaves the end, over this part of its radius.
constexpr double chord_ramp = 0.1;
/// Enough for one crossing to make the deepest point of its end superfluous (add_blended):
/// where that jumps from a crossing to a place elsewhere, the force does not.
constexpr double weight = 1.5;

}  // namespace

void RimCrossings::add(const EdgeLine& line, FeatureSum& features) const {
    const EdgeLine edge = is_thick_ ? without_ends(line) : line;
    const Vec3 start = edge.start - cap_.center;
    const double along = edge.direction.dot(outward_);
    const double sine2 = 1.0 - along * along;
    if (sine2 < least_sine2) return;
    const Vec3 e = edge.direction - along * outward_;
    const Vec3 p = start - start.dot(outward_) * outward_;
    const double middle = -p.dot(e) / sine2;  // where the line is nearest to the axis
    const Vec3 nearest = p + middle * e;
    const double distance = nearest.norm();
    if (!(distance < cap_.radius)) return;
    const double half = std::sqrt((square(cap_.radius) - square(distance)) / sine2);
    for (const double t : {middle - half, middle + half}) {
        if (t > 0.0 && t < edge.length) add_at(edge, t, nearest, features);
    }
}

void RimCrossings::add_at(const EdgeLine& edge, double t, const Vec3& nearest,
                          FeatureSum& features) const {
    const Vec3& e = edge.direction;
    const Vec3 x = edge.start + t * e;
    const double height = (x - cap_.center).dot(outward_);
    const double overlap = reach_ - height;
    if (!(overlap > 0.0) || height <= 0.0) return;
    const Vec3 across = x - cap_.center - height * outward_;
    const Vec3 m = across / cap_.radius;
    const double pace = m.dot(e);
    const Vec3 direction = outward_ - (e.dot(outward_) / pace) * m;
    const FeaturePoint p{x - (thickness_ - 0.5 * overlap) * direction, sign_ * direction, overlap};
    const double sine2 = 1.0 - square(e.dot(outward_));
    const Ramp at_t = end_ramp(edge, t);
    const Ramp chord((1.0 - nearest.norm() / cap_.radius) / chord_ramp);
    const Ramp lying((sine2 - lying_from_) / lying_range_);
    features.add(p, weight * at_t.value * chord.value * lying.value);
    PairGradient g;
    const double by_t = weight * at_t.slope * chord.value * lying.value;
    if (by_t != 0.0) add_shift(x, -by_t / pace * m, features, g);
    const double by_distance =
        -weight * at_t.value * chord.slope * lying.value / (chord_ramp * cap_.radius);
    if (by_distance != 0.0) {
        // From the axis to the line, square to both.
        const double middle = t - m.dot(e) * cap_.radius / sine2;
        add_shift(edge.start + middle * e, by_distance * nearest.normalized(), features, g);
    }
    if (lying.slope != 0.0) {
        const double by_sine2 = weight * at_t.value * chord.value * lying.slope / lying_range_;
        const Vec3 turn = 2.0 * by_sine2 * e.cross(outward_.cross(e.cross(outward_)));
        (sign_ > 0.0 ? g.turn_i : g.turn_j) += turn;
        (sign_ > 0.0 ? g.turn_j : g.turn_i) -= turn;
    }
    if (by_t != 0.0 || by_distance != 0.0 || lying.slope != 0.0) features.add_weight_gradient(p, g);
}

void RimCrossings::add_shift(const Vec3& x, const Vec3& by, const FeatureSum& features,
                             PairGradient& g) const {
    const Vec3 on_i = sign_ * by;
    g.shift += on_i;
    g.turn_i += x.cross(on_i);
    g.turn_j -= (x - features.pair().displacement).cross(on_i);
}

EdgeLine RimCrossings::without_ends(const EdgeLine& line) const {
    const double part = largest_tilt * thickness_;
    EdgeLine inner = line;
    inner.start += part * line.direction;
    inner.length -= 2.0 * part;
    inner.ramp = std::min(line.ramp, 0.5 * inner.length);
    return inner;
}

}  // namespace dem::runtime
