// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/cores/placed_core.hpp"

#include <cstdint>
#include <vector>

/// The part of a polyhedron that can touch: what lies less than some depth behind its farthest
/// point along a direction (docs/contact-convex.md, "Features").
namespace dem::runtime {

/// Which numbers have been met. Clearing takes no time.
class Marks {
  public:
    void clear(std::size_t count) {
        if (++stamp_ == 0) last_.clear();
        if (last_.size() < count) last_.resize(count, stamp_ - 1);
    }
    /// False when it was met before.
    bool add(std::uint32_t k) {
        if (last_[k] == stamp_) return false;
        last_[k] = stamp_;
        return true;
    }

  private:
    std::vector<std::uint32_t> last_;
    std::uint32_t stamp_ = 0;
};

/// An edge of a body in the frame of its pair.
struct EdgeLine {
    Vec3 start;      ///< relative to the center of i [m]
    Vec3 direction;  ///< unit
    double length;   ///< [m]
    double ramp;     ///< from its ends on contacts fade over this length [m]
    Vec3 middle;     ///< of its part within the cap, relative to the center of i [m]
    double half;     ///< length of half that part [m]
};

/// A ball that holds a cap.
struct CapBall {
    Vec3 center;    ///< relative to the center of i [m]
    double radius;  ///< [m]

    bool meets(const Vec3& x, double reach) const {
        return (x - center).squaredNorm() < square(radius + reach);
    }
};

/// The cap of a polyhedron. Its lists grow to what the shapes of a run need and are allocated no
/// more then.
struct ConvexCap {
    struct Vertex {
        std::uint32_t number;
        double behind;  ///< the farthest point, along the direction [m]
    };
    /// The part of an edge within the cap, in the frame of the body.
    struct ClippedEdge {
        std::uint32_t number;
        Vec3 middle;  ///< [m]
        double half;  ///< [m]
    };
    std::vector<Vertex> vertices;
    std::vector<ClippedEdge> edges;    ///< those with an end in the cap
    std::vector<std::uint32_t> faces;  ///< of those edges; list_faces()
    std::vector<EdgeLine> lines;       ///< list_lines()
    CapBall ball;
    Marks marks;
};

/// Finds the vertices less than `depth` behind the farthest along `direction`: a plane cuts off a
/// connected part of the graph. `start`: a vertex near that point.
void collect_vertices(const PlacedCore& core, const Vec3& direction, double depth,
                      std::uint32_t start, ConvexCap& cap);

/// Finds those vertices, the edges that begin there, and the ball. All points of the cap lie
/// between its vertices and the places where its edges leave it.
void collect_cap(const PlacedCore& core, const Vec3& direction, double depth, std::uint32_t start,
                 ConvexCap& cap);

void list_faces(const PlacedCore& core, ConvexCap& cap);

/// An edge without the part of it within a cap.
EdgeLine line_of(const PlacedCore& core, std::uint32_t edge);

/// The edges that come within `reach` of a ball.
void list_lines(const PlacedCore& core, const CapBall& ball, double reach, ConvexCap& cap);

/// All edges.
void list_lines(const PlacedCore& core, ConvexCap& cap);

/// Contacts along an edge fade towards its ends over this part of the size of the body.
inline constexpr double edge_ramp = 0.05;

}  // namespace dem::runtime
