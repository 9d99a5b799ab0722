// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/mesh/triangle_mesh_tree.hpp"

#include "common/error.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace dem::shapegen {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The point of the segment (0, direction) nearest to `to`.
Vec3 nearest_on_segment(const Vec3& direction, const Vec3& to) {
    const double length2 = direction.squaredNorm();
    if (!(length2 > 0.0)) return Vec3::Zero();
    return std::clamp(to.dot(direction) / length2, 0.0, 1.0) * direction;
}

/// The offset from p to the nearest point of the triangle (a, a + ab, a + ac), `pa` = a - p, by the
/// Voronoi regions of its corners and edges (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 offset_to_triangle(const Vec3& pa, const Vec3& ab, const Vec3& ac) {
    const double d1 = -ab.dot(pa);
    const double d2 = -ac.dot(pa);
    if (d1 <= 0.0 && d2 <= 0.0) return pa;
    Vec3 pb = pa + ab;
    const double d3 = -ab.dot(pb);
    const double d4 = -ac.dot(pb);
    if (d3 >= 0.0 && d4 <= d3) return pb;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return pa + (d1 / (d1 - d3)) * ab;
    Vec3 pc = pa + ac;
    const double d5 = -ab.dot(pc);
    const double d6 = -ac.dot(pc);
    if (d6 >= 0.0 && d5 <= d6) return pc;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return pa + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6)
        return pb + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (ac - ab);
    const double sum = va + vb + vc;
    if (!(sum > 0.0)) return pa;  // no area: the edges answer
    return pa + (vb / sum) * ab + (vc / sum) * ac;
}

}  // namespace

TriangleMeshTree::Candidate TriangleMeshTree::nearest_on(const Triangle& t, const Vec3& p) {
    const Vec3 pa = t.a - p;
    const Vec3 offset = offset_to_triangle(pa, t.ab, t.ac);
    Candidate best{offset, offset.squaredNorm()};
    if (!t.is_thin) return best;
    // Any point of the face that the uncertain weights gave is at least on the triangle, and the
    // edges are never further from the true one than the triangle is thin.
    const auto ask = [&best](const Vec3& start, const Vec3& direction) {
        const Vec3 other = start + nearest_on_segment(direction, -start);
        if (const double squared = other.squaredNorm(); squared < best.squared)
            best = {other, squared};
    };
    ask(pa, t.ab);
    ask(pa, t.ac);
    ask(pa + t.ab, t.ac - t.ab);
    return best;
}

/// Halves the triangles at the median of their centers along the longest side, twice per node.
struct TriangleMeshTree::Builder {
    struct Item {
        Aabb box;
        Vec3 center;
        std::uint32_t triangle;
    };
    using Items = std::span<Item>;

    const TriangleMesh& mesh;
    TriangleMeshTree& tree;

    static std::pair<Items, Items> halves(Items items) {
        if (items.size() <= largest_leaf) return {items, {}};
        Aabb centers;
        for (const Item& item : items) centers.extend(item.center);
        int axis = 0;
        (centers.upper - centers.lower).maxCoeff(&axis);
        const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
        std::nth_element(items.begin(), middle, items.end(), [axis](const Item& l, const Item& r) {
            return std::pair(l.center[axis], l.triangle) < std::pair(r.center[axis], r.triangle);
        });
        return {{items.begin(), middle}, {middle, items.end()}};
    }

    void append_leaf(Items items) {
        for (const Item& item : items) {
            const auto& [i, j, k] = mesh.triangles[item.triangle];
            const Vec3& a = mesh.vertices[i];
            const Vec3 ab = mesh.vertices[j] - a;
            const Vec3 ac = mesh.vertices[k] - a;
            // The weights of a face lose (size / height)^2 of their digits.
            const double size2 = std::max(ab.squaredNorm(), ac.squaredNorm());
            const bool is_thin = ab.cross(ac).squaredNorm() < 1e-6 * square(size2);
            tree.triangles_.push_back({a, ab, ac, item.triangle, is_thin});
        }
    }

    std::uint32_t build(Items items) {
        const auto index = static_cast<std::uint32_t>(tree.nodes_.size());
        tree.nodes_.emplace_back();
        const auto [left, right] = halves(items);
        const auto [first, second] = halves(left);
        const auto [third, fourth] = halves(right);
        const std::array<Items, width> children{first, second, third, fourth};
        for (std::size_t k = 0; k < width; ++k) {
            Aabb box;
            for (const Item& item : children[k]) box.extend(item.box);
            std::uint32_t start = 0;
            const bool is_leaf = children[k].size() <= largest_leaf;
            if (is_leaf) {
                start = static_cast<std::uint32_t>(tree.triangles_.size());
                append_leaf(children[k]);
            } else {
                start = build(children[k]);
            }
            Node& node = tree.nodes_[index];
            for (std::size_t c = 0; c < 3; ++c) {
                node.lower[c][k] = box.lower[static_cast<Eigen::Index>(c)];
                node.upper[c][k] = box.upper[static_cast<Eigen::Index>(c)];
            }
            node.first[k] = start;
            node.count[k] = is_leaf ? static_cast<std::uint32_t>(children[k].size()) : 0;
        }
        return index;
    }
};

TriangleMeshTree::TriangleMeshTree(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) throw Error("mesh", "found no triangles, expected a surface");
    std::vector<Builder::Item> items(mesh.triangles.size());
    Aabb all;
    for (std::uint32_t t = 0; t < items.size(); ++t) {
        Aabb box;
        for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.vertices[v]);
        items[t] = {box, 0.5 * (box.lower + box.upper), t};
        all.extend(box);
    }
    triangles_.reserve(items.size());
    nodes_.reserve(items.size() / 4 + 1);
    Builder{mesh, *this}.build(items);
    const double extent =
        std::max(all.lower.cwiseAbs().maxCoeff(), all.upper.cwiseAbs().maxCoeff());
    rounding_ = 32.0 * std::numeric_limits<double>::epsilon() * extent;
}

/// Boxes nearer to probe.center than the square root of probe.limit are opened, the nearest ones
/// first, and their triangles shown to the probe, which may move and shrink on the way as long as
/// it never reaches to where it did not before.
template <class Probe>
void TriangleMeshTree::search(Probe& probe) const {
    struct Entry {
        double squared;
        std::uint32_t node;
    };
    std::array<Entry, largest_stack> stack;
    std::size_t size = 0;
    stack[size++] = {0.0, 0};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (Probe::stands_still && entry.squared > probe.limit) continue;
        const Node& node = nodes_[entry.node];
        std::array<double, width> squared;
        for (std::size_t k = 0; k < width; ++k) {
            double sum = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double x = probe.center[static_cast<Eigen::Index>(c)];
                const double gap =
                    std::max(std::max(node.lower[c][k] - x, x - node.upper[c][k]), 0.0);
                sum += gap * gap;
            }
            squared[k] = sum;
        }
        const std::size_t bottom = size;
        // A probe that has moved since must not compare its new size with its old distances.
        const double before = probe.limit;
        for (std::size_t k = 0; k < width; ++k) {
            const double limit = Probe::stands_still ? probe.limit : before;
            if (squared[k] > limit || squared[k] == infinity) continue;
            if (node.count[k] == 0) {
                // Kept in falling order, so that the nearest child is the next to come.
                std::size_t at = size++;
                for (; at > bottom && stack[at - 1].squared < squared[k]; --at)
                    stack[at] = stack[at - 1];
                stack[at] = {squared[k], node.first[k]};
                continue;
            }
            for (const Triangle& t : std::span(triangles_).subspan(node.first[k], node.count[k]))
                probe.meet(t);
        }
    }
}

/// Keeps the nearest point of the triangles it meets.
struct TriangleMeshTree::Nearest {
    static constexpr bool stands_still = true;
    Vec3 center;
    double rounding;
    double limit;  ///< squared
    SurfacePoint best{Vec3::Zero(), infinity, 0};
    double best_squared = infinity;

    void meet(const Triangle& t) {
        const Candidate candidate = nearest_on(t, center);
        if (candidate.squared > best_squared ||
            (candidate.squared == best_squared && t.index > best.triangle))
            return;
        best_squared = candidate.squared;
        best = {center + candidate.offset, std::sqrt(best_squared), t.index};
        limit = std::min(limit, square(best.distance + rounding) * (1.0 + 1e-14));
    }
};

SurfacePoint TriangleMeshTree::nearest(const Vec3& p, double within) const {
    Nearest probe{p, rounding_, square(within + rounding_) * (1.0 + 1e-14)};
    search(probe);
    return probe.best;
}

/// A ball that touches the surface at q and shrinks until it holds none of the triangles it meets.
struct TriangleMeshTree::TangentBall {
    static constexpr bool stands_still = false;
    const Vec3& q;
    const Vec3& inward;
    double touching;
    double radius;
    Vec3 center = q + radius * inward;
    double limit = square(radius * (1.0 - touching));

    void meet(const Triangle& t) {
        // The nearest point is not that which shrinks the ball most: a few rounds.
        for (;;) {
            const Candidate candidate = nearest_on(t, center);
            if (candidate.squared >= limit) return;
            const Vec3 way = center + candidate.offset - q;
            const double along = way.dot(inward);
            const double next = along > 0.0 ? 0.5 * way.squaredNorm() / along : 0.0;
            // Rounding near q may leave no ball at all.
            radius = next < radius ? next : 0.0;
            center = q + radius * inward;
            limit = square(radius * (1.0 - touching));
        }
    }
};

double TriangleMeshTree::tangent_radius(const Vec3& q, const Vec3& inward, double largest,
                                        double touching) const {
    TangentBall ball{q, inward, touching, largest};
    search(ball);
    return ball.radius;
}

}  // namespace dem::shapegen
