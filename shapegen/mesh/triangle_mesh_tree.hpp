// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/mesh/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace dem::shapegen {

/// A point on a surface and the triangle it lies on.
struct SurfacePoint {
    Vec3 point = Vec3::Zero();  ///< [m]
    double distance = 0.0;      ///< from the point asked about [m]
    std::uint32_t triangle = 0;
};

/// Triangles in a tree of boxes, four to a node so that one pass of vector instructions tests them
/// together. Built once, in O(n log n); queries change nothing and may run in any number of
/// threads.
class TriangleMeshTree {
  public:
    /// Needs at least one triangle. Keeps its own copy of the corners.
    explicit TriangleMeshTree(const TriangleMesh& mesh);

    /// The point of the surface nearest to p; of equally near triangles the one with the lowest
    /// index: to the bit what a loop over all triangles finds. Thin triangles are as exact as
    /// others. Whoever knows that the surface is `within` a distance [m] is answered sooner; where
    /// it is not, the distance given is infinite or larger than that.
    SurfacePoint nearest(const Vec3& p,
                         double within = std::numeric_limits<double>::infinity()) const;

    /// Radius [m] of the largest ball, of those up to `largest`, that touches the surface at q,
    /// `inward` being the unit vector from there to its center, and that holds nothing of the
    /// surface once it is smaller by the part `touching`: it shrinks on its way through the tree
    /// (after Ma, Bae, Choi 2012). 0 where rounding leaves no ball.
    double tangent_radius(const Vec3& q, const Vec3& inward, double largest, double touching) const;

    /// Calls visit(triangle index) for each triangle whose box meets the ray from p along +z.
    template <class Visit>
    void visit_above(const Vec3& p, const Visit& visit) const;

  private:
    static constexpr std::size_t width = 4;
    static constexpr std::size_t largest_leaf = 4;
    // 2^32 triangles are 16 levels of nodes, each of which leaves three children waiting.
    static constexpr std::size_t largest_stack = 64;

    /// Boxes of the children, coordinate by coordinate; unused ones are empty (lower > upper).
    struct Node {
        std::array<std::array<double, width>, 3> lower, upper;
        std::array<std::uint32_t, width> first{};  ///< of the leaf's triangles, or the child node
        std::array<std::uint32_t, width> count{};  ///< triangles of a leaf; 0: an inner node
    };
    struct Triangle {
        Vec3 a, ab, ac;
        std::uint32_t index;
        bool is_thin;  ///< its plane is too uncertain to trust: its edges are asked as well
    };
    struct Candidate {
        Vec3 offset;  ///< from p
        double squared;
    };
    struct Builder;
    struct Nearest;
    struct TangentBall;

    template <class Probe>
    void search(Probe& probe) const;

    static Candidate nearest_on(const Triangle& triangle, const Vec3& p);

    std::vector<Node> nodes_;
    std::vector<Triangle> triangles_;  ///< in the order of the leaves
    double rounding_ = 0.0;  ///< what a distance to a triangle may be below that to its box [m]
};

template <class Visit>
void TriangleMeshTree::visit_above(const Vec3& p, const Visit& visit) const {
    std::array<std::uint32_t, largest_stack> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        for (std::size_t k = 0; k < width; ++k) {
            if (p.x() < node.lower[0][k] || p.x() > node.upper[0][k] || p.y() < node.lower[1][k] ||
                p.y() > node.upper[1][k] || p.z() > node.upper[2][k])
                continue;
            if (node.count[k] == 0) {
                stack[size++] = node.first[k];
                continue;
            }
            const auto leaf = std::span(triangles_).subspan(node.first[k], node.count[k]);
            for (const Triangle& triangle : leaf) visit(triangle.index);
        }
    }
}

}  // namespace dem::shapegen
