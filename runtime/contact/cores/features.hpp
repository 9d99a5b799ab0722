// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/cap.hpp"
#include "runtime/contact/cores/feature_patch.hpp"

#include <array>
#include <limits>

/// Which vertices, edges and rims of two cores are near each other, and how far they overlap
/// (docs/contact-convex.md, "Features").
namespace dem::runtime {

/// Room for the features of one pair, owned by the host, one per thread. Grows to what the shapes
/// of a run need and is allocated no more then.
struct ConvexScratch {
    ConvexCap i, j;
    std::vector<FeaturePoint> points;  ///< of walls
    std::vector<Vec3> corners;         ///< centroid.hpp
    std::vector<Vec2> polygon_i, polygon_j;
};

using CoreCall = Call<ConvexHistory, MissCache>;

/// The vertices of a polyhedron that the nearest points lie between; of other cores without
/// meaning.
struct NearVertices {
    std::array<std::uint32_t, 3> vertex{};
    std::size_t count = 0;

    void add(std::uint32_t v) {
        for (std::size_t k = 0; k < count; ++k)
            if (vertex[k] == v) return;
        vertex[count++] = v;
    }
};

/// What the distance of the cores tells about the pair.
struct NearCores {
    Vec3 normal;         ///< unit, from j towards i
    double deepest;      ///< overlap of the bodies [m], > 0
    bool cores_overlap;  ///< the distances of features are signed, and all faces count
    NearVertices i, j;
};

/// How far the bodies of a pair may move until what was proven of their features is proven again
/// [m]: enough for thousands of steps at rest, and little against what a rounding reaches.
inline double leash_room(const PlacedCore& i, const PlacedCore& j) {
    return 0.02 * (i.rounding + j.rounding);
}

/// A core with its cap: of a polyhedron whatever may be nearest to the other body.
struct CappedCore {
    const PlacedCore& core;
    const ConvexCap& cap;
};

/// A vertex against the other core. `sign`: 1 where it is of i, -1 of j.
void add_vertex(const PlacedCore& core, std::uint32_t vertex, const CappedCore& other,
                const NearCores& near, double sign, FeatureSum& features);

/// A vertex x against the other core, from which its distance is known.
void add_vertex_at(const PlacedCore& core, const Vec3& x, const PlacedCore& other,
                   const SurfaceDistance& distance, double sign, FeatureSum& features);

/// Two lines against each other; their roundings [m].
void add_line_pair(const EdgeLine& a, const EdgeLine& b, const NearCores& near, double rounding_i,
                   double rounding_j, FeatureSum& features);

/// The lines of both sides against each other; their roundings [m].
void add_edges(const ConvexScratch& scratch, const NearCores& near, double rounding_i,
               double rounding_j, FeatureSum& features);

/// Distance of a core's surface, as seen from the world. Of a point farther than `beyond` a lower
/// bound that is no less will do.
SurfaceDistance distance_to(const PlacedCore& core, const ConvexCap& cap, bool cores_overlap,
                            const Vec3& x, double beyond = std::numeric_limits<double>::infinity());
/// Distance of a core's surface, all in the frame of the core.
SurfaceDistance distance_in_body(const PlacedCore& core, const ConvexCap& cap, bool cores_overlap,
                                 const Vec3& x,
                                 double beyond = std::numeric_limits<double>::infinity());

/// Contacts of edges fade towards parallel over this squared sine: there the vertices carry, and
/// the nearest points run away. Below the least nothing is left of the weight, and rounding would
/// rule.
inline constexpr double parallel_sine2 = 1e-2;
inline constexpr double least_sine2 = 1e-8;

/// A smooth step from 0 at x <= 0 to 1 at x >= 1 with its slope.
struct Ramp {
    double value = 1.0;
    double slope = 0.0;

    Ramp(double v, double s) : value(v), slope(s) {}
    explicit Ramp(double x) {
        if (x >= 1.0) return;
        value = x > 0.0 ? x * x * (3.0 - 2.0 * x) : 0.0;
        slope = x > 0.0 ? 6.0 * x * (1.0 - x) : 0.0;
    }
};

/// Weight of a contact at the place t of an edge, 0 < t < length, and its derivative by t.
Ramp end_ramp(const EdgeLine& edge, double t);

/// The features of two polyhedra of at least two vertices: each vertex of one against the other
/// body, and each pair of edges whose nearest points lie inside both. Those that cannot overlap,
/// being too far behind the nearest point, are left out without loss.
void add_polyhedra(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                   ConvexScratch& scratch, FeatureSum& features);

}  // namespace dem::runtime
