// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <concepts>
#include <limits>

/// A wall as a field of distances, placed in the frame of who asks. Beside what every field offers
/// (fields/node_fields.hpp) a wall says where it acts: a surface may be cut off at a rim.
namespace dem::runtime {

/// What the fields whose distance is exact have in common, and the answers of a surface that is cut
/// off nowhere.
struct ExactField {
    double slack;  ///< rounding [m]

    static double floor(const Vec3& /*x*/) { return -std::numeric_limits<double>::infinity(); }
    double proven_gap(double distance) const { return distance - slack; }
    static bool accepts(const Vec3& /*x*/) { return true; }
    static bool lets_pass(const Vec3& /*center*/) { return false; }
};

/// The field of a wall. Positive distances are in front of it.
template <class Field>
concept WallField = requires(const Field& field, const Vec3& x,
                             const typename Field::Sample& sample) {
    /// Signed distance of a point, and what follows from it [m].
    { field.sample(x) } -> std::same_as<typename Field::Sample>;
    { sample.distance } -> std::convertible_to<double>;
    /// Unit vector out of the wall; zero where there is none.
    { field.gradient(x, sample) } -> std::convertible_to<Vec3>;
    /// False where the surface has been cut off: the point does not touch, whatever its distance.
    { field.accepts(x) } -> std::same_as<bool>;
    /// Whether a body whose center is here does not feel the wall at all, being behind it. It has
    /// at least the way back to the surface to go before it does.
    { field.lets_pass(x) } -> std::same_as<bool>;
    /// Lower bound of the distance to where the wall acts, exact in front of it [m]: a body within
    /// r of the point cannot touch the wall when this is more than r.
    { field.clearance(x) } -> std::same_as<double>;
    { field.floor(x) } -> std::same_as<double>;
    { field.proven_gap(1.0) } -> std::same_as<double>;
};

}  // namespace dem::runtime
