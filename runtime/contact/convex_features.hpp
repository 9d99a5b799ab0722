// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/convex_patch.hpp"
#include "runtime/contact/placed_core.hpp"

#include <span>
#include <vector>

/// Which vertices, edges and rims of two cores are near each other, and how far they overlap
/// (docs/contact-convex.md, "Features").
namespace dem {

/// Room for the features of one pair, owned by the host, one per thread. Grows to what the shapes
/// of a run need and is allocated no more then.
struct ConvexScratch {
    struct EdgeLine {
        Vec3 start;      ///< relative to the center of i [m]
        Vec3 direction;  ///< unit
        double length;   ///< [m]
        double ramp;     ///< from its ends on contacts fade over this length [m]
    };
    struct Side {
        std::vector<std::uint32_t> vertices, edges, faces;
        std::vector<EdgeLine> lines;  ///< of the edges
    };
    Side i, j;
};

/// What the distance of the cores tells about the pair.
struct NearCores {
    Vec3 normal;            ///< unit, from j towards i
    double deepest;         ///< overlap of the bodies [m], > 0
    bool cores_overlap;     ///< the distances of features are signed, and all faces count
    std::uint32_t start_i;  ///< a vertex near the contact
    std::uint32_t start_j;
};

/// The vertices of a polyhedron less than `depth` behind its farthest point along `direction`, and
/// the edges and faces that begin there: a plane cuts off a connected part of the graph. `start`: a
/// vertex near that point.
void collect(const PlacedCore& core, const Vec3& direction, double depth, std::uint32_t start,
             ConvexScratch::Side& side);

/// Vertices against the other core. `sign`: 1 where they are of i, -1 of j. `other_side`: of a
/// polyhedron whatever may be nearest to them.
void add_vertices(const PlacedCore& core, const ConvexScratch::Side& side, const PlacedCore& other,
                  const ConvexScratch::Side& other_side, const NearCores& near, double sign,
                  FeatureSum& features);

/// The lines of both sides against each other; their roundings [m].
void add_edges(const ConvexScratch& scratch, const NearCores& near, double rounding_i,
               double rounding_j, FeatureSum& features);

/// Distance of a core's surface, as seen from the world.
SurfaceDistance distance_to(const PlacedCore& core, const ConvexScratch::Side& side,
                            bool cores_overlap, const Vec3& x);

/// Contacts along an edge fade towards its ends over this part of the size of the body.
inline constexpr double edge_ramp = 0.05;
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
Ramp end_ramp(const ConvexScratch::EdgeLine& edge, double t);

/// The features of two polyhedra of at least two vertices: each vertex of one against the other
/// body, and each pair of edges whose nearest points lie inside both. Those that cannot overlap,
/// being too far behind the nearest point, are left out without loss.
void add_polyhedra(const PlacedCore& i, const PlacedCore& j, const NearCores& near,
                   ConvexScratch& scratch, FeatureSum& features);

}  // namespace dem
