// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/centroid.hpp"
#include "runtime/contact/cores/core_radius.hpp"
#include "runtime/contact/cores/epa.hpp"
#include "runtime/contact/cores/features.hpp"
#include "runtime/contact/cores/lone_features.hpp"
#include "runtime/contact/cores/nearest_points.hpp"
#include "runtime/contact/cores/round_features.hpp"

#include <cmath>

/// From two cores to a contact: what all kernels of convex shapes share.
namespace dem::runtime {

/// The search of a pair that has not touched starts from the line of centers, whatever came before.
inline SearchStart canonical_start(const Vec3& displacement) {
    const double distance = displacement.norm();
    SearchStart start;
    start.direction = distance > 0.0 ? Vec3(displacement / -distance) : Vec3::UnitZ();
    return start;
}

/// A pair that touches in one point.
inline PairContact single_contact(const FeaturePoint& point, const ConvexRadius& radius,
                                  const CoreCall& call) {
    FeatureSum features(call.pair, point.overlap);
    features.add(point, 1.0);
    return contact_force(features, radius.value(), call.law, call.dt, call.memory.history);
}

/// Error of the distance that the features make up for: those of cylinders and polyhedra are found
/// by themselves, the distance only says where to look. Polyhedra are exact at no cost.
template <class CoreI, class CoreJ>
double distance_error(const CoreI& /*i*/, const CoreJ& /*j*/) {
    return 0.0;
}
inline double distance_error(const PlacedCore& i, const PlacedCore& j) {
    using Core = ConvexShape::Core;
    const auto is_listed = [](const ConvexShape& s) {
        return s.core == Core::cylinder || (s.is_polyhedron() && s.vertices.size() > 1);
    };
    const bool has_round = !i.has_vertices() || !j.has_vertices();
    if (!has_round || !is_listed(i.shape) || !is_listed(j.shape)) return 0.0;
    return 1e-7 * (i.rounding + j.rounding);
}

template <class CoreI, class CoreJ>
void sharpen_single(const CoreI& /*i*/, const CoreJ& /*j*/, CoreDistance& /*found*/) {}
inline void sharpen_single(const PlacedCore& i, const PlacedCore& j, CoreDistance& found) {
    const bool is_single = i.shape.is_strictly_convex() || j.shape.is_strictly_convex();
    if (is_single && !found.overlaps) sharpen(i, j, found);
}

template <class CoreI, class CoreJ>
void sharpen_deepest(const CoreI& /*i*/, const CoreJ& /*j*/, Penetration& /*deepest*/) {}
inline void sharpen_deepest(const PlacedCore& i, const PlacedCore& j, Penetration& deepest) {
    if (i.shape.is_strictly_convex() || j.shape.is_strictly_convex()) sharpen(i, j, deepest);
}

/// Nearest or deepest points of a pair that touches.
struct ConvexTouch {
    FeaturePoint point;
    NearCores near;
};

template <class CoreI, class CoreJ>
ConvexTouch touch_of(const CoreI& i, const CoreJ& j, const CoreDistance& found) {
    const double reach = i.rounding + j.rounding;
    ConvexTouch touch;
    Vec3 on_i = found.point_i;
    touch.point.normal = found.normal;
    touch.point.overlap = reach - found.distance;
    double deepest = reach - found.proven;
    // Rims that all but touch: rounding has stopped the search.
    const double doubtful = 1e-8 * (i.size + j.size) + distance_error(i, j);
    if (found.overlaps || found.distance - found.proven > doubtful) {
        Penetration deep = found.overlaps ? core_penetration(i, j)
                                          : parted(i, j, found.normal, 1e-11 * (i.size + j.size));
        if (found.overlaps) sharpen_deepest(i, j, deep);
        on_i = deep.point_i;
        touch.point.normal = deep.normal;
        deepest = touch.point.overlap = reach + deep.depth;
    }
    touch.point.position = on_i - (i.rounding - 0.5 * touch.point.overlap) * touch.point.normal;
    touch.near = {touch.point.normal, deepest, found.overlaps, {}, {}};
    for (int k = 0; k < std::min(found.simplex.count, 3); ++k) {
        const SimplexPoint& p = found.simplex.point[static_cast<std::size_t>(k)];
        touch.near.i.add(p.vertex_a);
        touch.near.j.add(p.vertex_b);
    }
    return touch;
}

/// Bodies of which one has no flat part touch in one point.
template <class CoreI, class CoreJ>
void add_features(const CoreI& /*i*/, const CoreJ& /*j*/, const ConvexTouch& touch,
                  const CoreCall& /*call*/, FeatureSum& features) {
    features.add(touch.point, 1.0);
}

inline void add_features(const PlacedCore& i, const PlacedCore& j, const ConvexTouch& touch,
                         const CoreCall& call, FeatureSum& features) {
    ConvexScratch& scratch = *call.scratch.features;
    if (i.shape.is_strictly_convex() || j.shape.is_strictly_convex()) {
        features.add(touch.point, 1.0);
    } else if (i.has_vertices() && j.has_vertices() && touch.near.cores_overlap) {
        // Deep in each other, features may miss what is deepest.
        FeatureSum others(features.pair(), features.deepest());
        add_polyhedra(i, j, touch.near, scratch, others);
        add_remaining(touch.point, others, features);
    } else if (i.has_vertices() && j.has_vertices()) {
        LoneFeature& lone = call.memory.history.lone;
        Leash& leash = call.memory.history.leash;
        if (!add_lone_feature(i, j, touch.near, features, lone, leash))
            add_polyhedra(i, j, touch.near, scratch, features);
        if (features.count() == 1 && lone.kind == LoneFeature::Kind::none)
            look_for_lone_feature(i, j, features.pair(), touch.near, scratch, lone, leash);
    } else {
        add_round(i, j, touch.near, touch.point, call, features);
    }
}

/// The one point of `contact = centroid`.
template <class CoreI, class CoreJ>
FeaturePoint centroid_point(const CoreI& /*i*/, const CoreJ& /*j*/, const ConvexTouch& touch,
                            ConvexScratch& /*scratch*/) {
    return touch.point;
}
inline FeaturePoint centroid_point(const PlacedCore& i, const PlacedCore& j,
                                   const ConvexTouch& touch, ConvexScratch& scratch) {
    return patch_centroid(i, j, touch.point, touch.near, scratch);
}

/// A feature that is known to be the only one: nothing is searched. False if there is none.
template <class CoreI, class CoreJ>
bool is_lone_contact(const CoreI& /*i*/, const CoreJ& /*j*/, const ConvexRadius& /*radius*/,
                     const CoreCall& /*call*/, PairContact& /*contact*/) {
    return false;
}
inline bool is_lone_contact(const PlacedCore& i, const PlacedCore& j, const ConvexRadius& radius,
                            const CoreCall& call, PairContact& contact) {
    ConvexHistory& history = call.memory.history;
    const Vec3 normal = history.normal;
    const double overlap = lone_overlap(i, j, history.lone, normal);
    if (overlap > 0.0) {
        FeatureSum features(call.pair, overlap);
        add_known_feature(i, j, history.lone, normal, features);
        if (!features.empty()) {
            contact = contact_force(features, radius.value(), call.law, call.dt, history);
            return true;
        }
    }
    history.lone.kind = LoneFeature::Kind::none;
    return false;
}

template <class CoreI, class CoreJ>
PairContact core_contact(const CoreI& i, const CoreJ& j, const ConvexRadius& radius,
                         const CoreCall& call) {
    ConvexHistory& history = call.memory.history;
    const Vec3& d = call.pair.displacement;
    const double reach = i.rounding + j.rounding;
    const bool touched = history.touched();
    PairContact lone;
    if (history.leash.room > 0.0 && !holds(history.leash, call.pair, j.size)) {
        history.leash.room = 0.0;
        history.lone.kind = LoneFeature::Kind::none;
    }
    if (touched && is_lone_contact(i, j, radius, call, lone)) return lone;
    if (!touched && Vec3(call.memory.cache.axis).squaredNorm() > 0.0) {
        const Vec3 axis = call.memory.cache.axis;
        const double gap = -axis.dot(gjk::support(i, j, axis, 0, 0).w) - reach;
        if (gap > 0.0) return apart(call, gap, axis);
    }
    CoreDistance found =
        core_distance(i, j, touched ? history.search : canonical_start(d), distance_error(i, j));
    if (!found.overlaps && (found.proven >= reach || found.distance >= reach))
        return apart(call, std::max(found.proven - reach, 0.0), -found.normal);
    sharpen_single(i, j, found);
    const ConvexTouch touch = touch_of(i, j, found);
    // Cores that share a point without a body around them.
    if (!(touch.point.overlap > 0.0)) return apart(call, 0.0);
    FeatureSum features(call.pair, touch.point.overlap);
    if (call.law.geometry.method == ContactLaw::Method::centroid) {
        features.add(centroid_point(i, j, touch, *call.scratch.features), 1.0);
    } else {
        add_features(i, j, touch, call, features);
    }
    if (features.empty()) features.add(touch.point, 1.0);
    PairContact contact = contact_force(features, radius.value(), call.law, call.dt, history);
    contact.cores_met = found.overlaps && history.cores_met == 0;
    if (found.overlaps) history.cores_met = 1;
    history.search = next_start(i, j, found);
    return contact;
}

/// core_contact() with nothing known of where the bodies are.
template <class CoreI, class CoreJ>
PairContact between_cores(const CoreI& i, const CoreJ& j, const ConvexRadius& radius,
                          const CoreCall& call) {
    const double spheres = call.pair.displacement.norm() - i.size - j.size;
    if (spheres > 0.0) return apart(call, spheres, call.memory.cache.axis);
    return core_contact(i, j, radius, call);
}

}  // namespace dem::runtime
