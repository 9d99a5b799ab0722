// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/meshes/mesh_touches.hpp"

#include <algorithm>
#include <cmath>

// Where the surface is hollow within a patch, two planes are near at a time. They are blended by a
// smooth maximum of their overlaps d_k,
//   d = max over shares s_k >= 0 with sum 1 of  sum s_k d_k + e/2 (1 - sum s_k^2),
// whose gradients are the shares: conservative, without a jump, the deepest alone where it is ahead
// by more than e. The planes differ by e at e / (angle between them) from their edge: e is bounded
// so that this is neither beyond the middle of a face (WallMesh::blends) nor more than a tenth of
// the radius.

namespace dem::runtime {

/// The sides that meet in an edge are those of one contact; around a rim the front becomes the
/// back.
void MeshTouches::join_around(std::uint32_t half_edge, const Vec3& from) {
    const PatchSide side = side_of(half_edge / 3, from);
    const std::uint32_t number = sides_.number_of(side);
    if (mesh_.twins[half_edge] == half_edge)
        sides_.join(number, sides_.number_of(other_side(side)));
    for (std::uint32_t h = mesh_.twins[half_edge]; h != half_edge; h = mesh_.twins[h])
        sides_.join(number, sides_.number_of(side_of(h / 3, from)));
}

/// Whether the surface goes on around a corner of a triangle, flat or hollow, within its patch.
bool MeshTouches::is_hollow_around(std::uint32_t t, std::uint32_t corner, bool is_front) const {
    const std::uint32_t vertex = mesh_.triangles[t][corner];
    std::uint32_t out = 3 * t + corner;
    do {
        const std::uint32_t in = out - out % 3 + (out + 2) % 3;
        const double bend = mesh_.bends[in];
        const bool bulges = is_front ? bend > level_bend : bend < -level_bend;
        if (bulges || !mesh_.is_smooth(in)) return false;
        out = mesh_.twins[in];
        if (mesh_.triangles[out / 3][out % 3] != vertex) return false;
    } while (out / 3 != t);
    return true;
}

/// Whether x, the center of a ball or the place of a body, lies beyond hollow edges of a triangle
/// alone, edges within its patch.
bool MeshTouches::is_blended(std::uint32_t t, const TrianglePoint& nearest, bool is_front,
                             const Vec3& x) const {
    bool is_beyond = false;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Vec3& start = mesh_.corner(t, k);
        const Vec3 along = mesh_.corner(t, (k + 1) % 3) - start;
        if (along.cross(mesh_.normals[t]).dot(x - start) <= 0.0) continue;
        const double bend = mesh_.bends[3 * t + k];
        const bool is_hollow = is_front ? bend < -level_bend : bend > level_bend;
        if (!is_hollow || !mesh_.is_smooth(3 * t + k)) return false;
        is_beyond = true;
    }
    return is_beyond && (!nearest.is_corner() || is_hollow_around(t, nearest.part, is_front));
}

/// Largest difference of overlaps that is blended in a patch [m]. Seen from the center of a ball of
/// radius R a face between two neighbors is narrower than it is by R times the angle.
double MeshTouches::blend_of(std::uint32_t patch) const {
    const double bend = mesh_.least_bends[patch];
    const double within_faces = mesh_.blends[patch] - 0.5 * radius_ * square(bend);
    return std::max(0.0,
                    std::min({within_faces, most_blend * radius_, widest_blend * radius_ * bend}));
}

void MeshTouches::keep(double overlap, const Vec3& normal, PatchSide side, bool is_blended,
                       const TouchedPart& part) {
    const double blend = blend_of(side / 2);
    if (!(overlap > -blend)) return;
    const std::uint32_t number = sides_.number_of(side);
    const MeshTouch touch{part, overlap, normal, number, blend, is_blended};
    for (std::uint32_t k = 0; k < count_; ++k) {
        MeshTouch& other = touches_[k];
        if ((other.normal - normal).squaredNorm() > square(level_bend)) continue;
        sides_.join(other.side, number);
        const bool is_only_blended = other.is_blended && is_blended;
        if (overlap > other.overlap) other = touch;
        other.is_blended = is_only_blended;
        return;
    }
    if (count_ < capacity) {
        touches_[count_++] = touch;
        return;
    }
    const auto shallowest =
        std::min_element(touches_.begin(), touches_.end(),
                         [](const auto& a, const auto& b) { return a.overlap < b.overlap; });
    if (overlap > shallowest->overlap) *shallowest = touch;
}

/// Deepest first, equal ones in the order in which they came.
void MeshTouches::sort() {
    for (std::uint32_t k = 1; k < count_; ++k) {
        const MeshTouch touch = touches_[k];
        std::uint32_t place = k;
        for (; place > 0 && touches_[place - 1].overlap < touch.overlap; --place)
            touches_[place] = touches_[place - 1];
        touches_[place] = touch;
    }
}

/// The smooth maximum of those that belong together, `first` the deepest of them: shares are what
/// stands above a level that makes their sum one.
MeshTouches::Place MeshTouches::blended(std::uint32_t first,
                                        const std::array<bool, capacity>& belongs) const {
    const MeshTouch& deepest = touches_[first];
    double width = deepest.blend;
    for (std::uint32_t k = first + 1; k < count_; ++k)
        if (belongs[k]) width = std::min(width, touches_[k].blend);
    Place place{deepest.overlap, deepest.normal, deepest.point};
    if (!(width > 0.0)) return place;
    // Overlaps relative to the deepest, in widths.
    const auto depth = [&](std::uint32_t k) {
        return (touches_[k].overlap - deepest.overlap) / width;
    };
    double sum = 0.0;
    double level = -1.0;
    std::uint32_t parts = 0;
    for (std::uint32_t k = first; k < count_; ++k) {
        if (!belongs[k]) continue;
        const double next = (sum + depth(k) - 1.0) / (parts + 1.0);
        if (!(depth(k) > next)) break;
        sum += depth(k);
        ++parts;
        level = next;
    }
    if (parts == 1) return place;
    double squares = 0.0;
    double mean = 0.0;
    place.gradient = Vec3::Zero();
    Vec3 arm = Vec3::Zero();     // mean of the points, from the center
    Vec3 torque = Vec3::Zero();  // gradient of the overlap for turns
    for (std::uint32_t k = first; k < count_; ++k) {
        if (!belongs[k] || !(depth(k) > level)) continue;
        const double share = depth(k) - level;
        squares += square(share);
        mean += share * depth(k);
        place.gradient += share * touches_[k].normal;
        arm += share * (touches_[k].point - center_);
        torque += share * (touches_[k].point - center_).cross(touches_[k].normal);
    }
    place.overlap = deepest.overlap + width * (mean + 0.5 * (1.0 - squares));
    // The place from which the force has that torque.
    const Vec3& g = place.gradient;
    place.point = center_ + arm + g.cross(torque - arm.cross(g)) / g.squaredNorm();
    return place;
}

}  // namespace dem::runtime
