// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_mesh.hpp"
#include "runtime/contact/meshes/mesh_history.hpp"

#include <array>
#include <cstdint>

/// The places where a body touches a surface of triangles (docs/mesh-walls.md, "Contact").
namespace dem::runtime {

/// The sides of patches that a body touches in a step, and which of them belong to one contact.
class TouchedSides {
  public:
    static constexpr std::size_t capacity = 32;

    /// Number of a side, which is added if it is not there. Where there are too many, the last
    /// number stands for all others.
    std::uint32_t number_of(PatchSide side) {
        for (std::uint32_t k = 0; k < count_; ++k)
            if (sides_[k] == side) return k;
        if (count_ == capacity) return count_ - 1;
        sides_[count_] = side;
        parent_[count_] = count_;
        return count_++;
    }
    /// The lowest number among the sides that belong to the same contact.
    std::uint32_t contact_of(std::uint32_t number) const {
        while (parent_[number] != number) number = parent_[number];
        return number;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = contact_of(a);
        b = contact_of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    std::uint32_t count() const { return count_; }
    PatchSide side(std::uint32_t number) const { return sides_[number]; }

  private:
    std::uint32_t count_ = 0;
    std::array<PatchSide, capacity> sides_{};
    std::array<std::uint32_t, capacity> parent_{};
};

/// What a touch of a body that is no ball knows besides.
struct TouchedPart {
    Vec3 point = Vec3::Zero();     ///< of the body, deepest behind the surface
    WallMesh::Triangle corners{};  ///< of what is touched, repeated if there are fewer
};

/// One place where a body touches: a face, the inside of a bulging edge or a corner, or the plane
/// of a face behind a hollow edge, into which the plane beside it is blended.
struct MeshTouch : TouchedPart {
    double overlap;      ///< [m]; negative by less than `blend` where only the other may touch
    Vec3 normal;         ///< unit, towards the body; frame of the mesh
    std::uint32_t side;  ///< its number among the TouchedSides
    double blend;        ///< largest difference of overlaps that is blended [m]
    bool is_blended;     ///< a plane beyond its hollow edge: nothing by itself
};

/// What a body touches, gathered triangle by triangle in rising order by those who derive from it.
class MeshTouches {
  public:
    static constexpr std::size_t capacity = 24;
    /// Differences of overlaps that are blended, at most, in radii: the smooth surface of a hollow
    /// edge stands above its faces by less than half of it.
    static constexpr double most_blend = 0.04;
    /// Triangles that are farther than this many radii from its center mean nothing to a body.
    static double reach(const WallMesh& mesh) { return is_blended(mesh) ? 1.06 : plain_reach; }
    /// A body whose center is farther than this many radii from the surface does not touch it.
    static double touching_reach(const WallMesh& mesh) {
        return is_blended(mesh) ? 1.0 + 0.5 * most_blend : plain_reach;
    }

    /// Whether the body has come so far through the surface that nothing says any more from where
    /// it came.
    bool is_lost() const { return is_lost_; }

    /// A place that stands for all that are near it.
    struct Place {
        double overlap;  ///< [m]
        Vec3 gradient;   ///< a unit vector, a little shorter where planes are blended
        Vec3 point;      ///< of the body, where the force acts; frame of the mesh
    };
    /// Calls visit(place, side) for each place, deepest first.
    template <class Visit>
    void visit_places(const Visit& visit);

  protected:
    /// Center and radius of the body, or of a ball around it [m], frame of the mesh; what the pair
    /// remembers of sides.
    MeshTouches(const WallMesh& mesh, const Vec3& center, double radius, const MeshHistory& history,
                TouchedSides& sides)
        : mesh_(mesh),
          center_(center),
          radius_(radius),
          reach_(reach(mesh) * radius),
          history_(history),
          sides_(sides) {}

    static constexpr double rounding = 1e-11;
    static constexpr double widest_blend = 0.1;  // from an edge on, in radii

    void join_around(std::uint32_t half_edge, const Vec3& from);
    bool is_hollow_around(std::uint32_t t, std::uint32_t corner, bool is_front) const;
    bool is_blended(std::uint32_t t, const TrianglePoint& nearest, bool is_front,
                    const Vec3& x) const;
    PatchSide side_of(std::uint32_t t, const Vec3& from) const {
        return 2 * mesh_.patches[t] + (from.dot(mesh_.normals[t]) < 0.0 ? 1U : 0U);
    }
    void keep(double overlap, const Vec3& normal, PatchSide side, bool is_blended,
              const TouchedPart& part = {});

    std::array<MeshTouch, capacity> touches_;  // NOLINT: filled up to count_
    std::uint32_t count_ = 0;
    const WallMesh& mesh_;
    Vec3 center_;
    double radius_;
    double reach_;
    const MeshHistory& history_;
    TouchedSides& sides_;
    bool is_lost_ = false;

  private:
    static constexpr double plain_reach = 1.0 + 1e-6;
    /// Whether a patch bends anywhere.
    static bool is_blended(const WallMesh& mesh) {
        return mesh.least_bends.back() < WallMesh::sharp;
    }
    double blend_of(std::uint32_t patch) const;
    void sort();
    Place blended(std::uint32_t first, const std::array<bool, capacity>& belongs) const;
};

template <class Visit>
void MeshTouches::visit_places(const Visit& visit) {
    // Places on a body whose normals are apart by more are places of their own.
    constexpr double near_cosine = 0.5;
    sort();
    std::array<bool, capacity> done{};
    for (std::uint32_t k = 0; k < count_; ++k) {
        if (done[k]) continue;
        std::array<bool, capacity> belongs{};
        bool is_real = false;
        const std::uint32_t contact = sides_.contact_of(touches_[k].side);
        for (std::uint32_t m = k; m < count_; ++m) {
            belongs[m] = !done[m] && sides_.contact_of(touches_[m].side) == contact &&
                         touches_[k].normal.dot(touches_[m].normal) > near_cosine;
            done[m] = done[m] || belongs[m];
            is_real = is_real || (belongs[m] && !touches_[m].is_blended);
        }
        if (!is_real) continue;
        const Place place = blended(k, belongs);
        if (place.overlap > 0.0) visit(place, touches_[k].side);
    }
}

}  // namespace dem::runtime
