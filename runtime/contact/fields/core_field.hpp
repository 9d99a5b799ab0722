// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"
#include "runtime/contact/fields/node_fields.hpp"

namespace dem::runtime {

/// A convex shape as a field (node_fields.hpp), exact.
struct ConvexField : ExactField {
    struct Sample {
        double distance;
        Vec3 normal;  ///< in the frame of the field
    };

    const ConvexShape* shape;
    Mat3 turn;    ///< from the shape's frame to that of the field
    Vec3 center;  ///< of the shape [m]

    Sample sample(const Vec3& x) const {
        const SurfaceDistance d = surface_distance(*shape, turn.transpose() * (x - center));
        return {d.distance, turn * d.normal};
    }
    static Vec3 gradient(const Vec3& /*x*/, const Sample& s) { return s.normal; }
    /// Bodies with edges have creases in their cores, and round the edges of those off.
    bool may_turn_within(const Sample& s, double way) const {
        return s.distance + shape->rounding < way && !shape->is_strictly_convex();
    }
};

}  // namespace dem::runtime
