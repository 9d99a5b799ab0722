// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/meshes/ball_touch.hpp"

#include <algorithm>
#include <cmath>

// A ball touches where its center is nearer to the surface than its radius and no way along the
// surface leads nearer: over a face; in front of a bulging edge or corner, where the direction to
// the center lies between the normals of the faces there; at a rim. Flat and hollow edges are never
// nearest by themselves, so that every place is counted once, and neighbors in one plane are one
// plane. By rounding a center over an edge may seem to be beside both of its faces: the conditions
// give way by `rounding`, and touches of one direction are one.
//
// Where the surface is hollow within a patch, two planes are near at a time. They are blended by a
// smooth maximum of their overlaps d_k,
//   d = max over shares s_k >= 0 with sum 1 of  sum s_k d_k + e/2 (1 - sum s_k^2),
// whose gradients are the shares: conservative, without a jump, the deepest alone where it is ahead
// by more than e. The planes differ by e at e / (angle between them) from their edge: e is bounded
// so that this is neither beyond the middle of a face (WallMesh::blends) nor more than a tenth of
// the radius.

namespace dem::runtime {

namespace {

constexpr double rounding = 1e-11;
constexpr double widest_blend = 0.1;  // from an edge on, in radii
/// Nobody touches a side for the first time with a center nearer than this, in radii.
constexpr double first_touch = 0.9;

}  // namespace

double BallTouches::add(std::uint32_t t) {
    const Vec3& a = mesh_.corner(t, 0);
    const TrianglePoint nearest =
        nearest_on_triangle(a, mesh_.corner(t, 1), mesh_.corner(t, 2), center_);
    const double distance = (center_ - nearest.point).norm();
    if (!(distance < reach_)) return distance;
    const Vec3& n = mesh_.normals[t];
    const double height = (center_ - a).dot(n);
    const bool is_front = height >= 0.0;
    const PatchSide side = 2 * mesh_.patches[t] + (is_front ? 0U : 1U);
    const Vec3 normal = is_front ? n : Vec3(-n);
    const double overlap = radius_ - std::abs(height);
    // A center that has come through keeps its side; a ball that comes from the other side touches
    // it far from its center first.
    const bool is_from_behind = !history_.knows(side) && history_.knows(other_side(side));
    const bool has_come_through = is_from_behind && distance < 0.5 * radius_;
    if (is_from_behind && !has_come_through && distance < first_touch * radius_) is_lost_ = true;
    if (nearest.part == TrianglePoint::inside) {
        if (has_come_through)
            keep(radius_ + std::abs(height), -normal, other_side(side), false);
        else
            keep(overlap, normal, side, false);
        return distance;
    }
    if (has_come_through) {
        if (is_nearest(t, nearest))
            keep(radius_ + std::abs(height), -normal, other_side(side), false);
        return distance;
    }
    const bool is_near = square(distance) - square(height) <= square(widest_blend * radius_);
    if (is_near && is_blended(t, nearest, is_front)) keep(overlap, normal, side, true);
    if (!is_nearest(t, nearest)) return distance;
    if (distance < radius_) join_sides(t, nearest);
    // So near that rounding would say where it points.
    const bool has_direction = distance > 1e-6 * radius_;
    keep(radius_ - distance, has_direction ? Vec3((center_ - nearest.point) / distance) : normal,
         side, false);
    return distance;
}

/// Whether no way along the surface leads from a point of an edge or a corner nearer to the center.
bool BallTouches::is_nearest(std::uint32_t t, const TrianglePoint& nearest) const {
    const Vec3 from = center_ - nearest.point;
    const auto leads_nearer = [&](const Vec3& way) {
        const double along = from.dot(way);
        return along > 0.0 && along > rounding * radius_ * way.norm();
    };
    if (nearest.is_corner()) {
        const std::uint32_t vertex = mesh_.triangles[t][nearest.part];
        for (std::uint32_t k = mesh_.fan_begin[vertex]; k < mesh_.fan_begin[vertex + 1]; ++k)
            if (leads_nearer(mesh_.vertices[mesh_.fan[k]] - nearest.point)) return false;
        return true;
    }
    // The center lies across the edge from its nearest point: ways into a triangle are as good as
    // those straight away from the edge.
    const std::uint32_t half_edge = 3 * t + nearest.part - 3;
    for (std::uint32_t h = mesh_.twins[half_edge]; h != half_edge; h = mesh_.twins[h])
        if (leads_nearer(mesh_.corner(h / 3, (h + 2) % 3) - nearest.point)) return false;
    return true;
}

/// At a corner the edges of each of its triangles come in turn.
void BallTouches::join_sides(std::uint32_t t, const TrianglePoint& nearest) {
    const Vec3 from = center_ - nearest.point;
    if (nearest.is_edge()) {
        join_around(3 * t + nearest.part - 3, from);
        return;
    }
    join_around(3 * t + nearest.part, from);
    join_around(3 * t + (nearest.part + 2) % 3, from);
}

/// The sides that meet in an edge are those of one contact; around a rim the front becomes the
/// back.
void BallTouches::join_around(std::uint32_t half_edge, const Vec3& from) {
    const PatchSide side = side_of(half_edge / 3, from);
    const std::uint32_t number = sides_.number_of(side);
    if (mesh_.twins[half_edge] == half_edge)
        sides_.join(number, sides_.number_of(other_side(side)));
    for (std::uint32_t h = mesh_.twins[half_edge]; h != half_edge; h = mesh_.twins[h])
        sides_.join(number, sides_.number_of(side_of(h / 3, from)));
}

/// Whether the surface goes on around a corner of a triangle, flat or hollow, within its patch.
bool BallTouches::is_hollow_around(std::uint32_t t, std::uint32_t corner, bool is_front) const {
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

/// Whether the center lies beyond hollow edges of a triangle alone, edges within its patch.
bool BallTouches::is_blended(std::uint32_t t, const TrianglePoint& nearest, bool is_front) const {
    bool is_beyond = false;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Vec3& start = mesh_.corner(t, k);
        const Vec3 along = mesh_.corner(t, (k + 1) % 3) - start;
        if (along.cross(mesh_.normals[t]).dot(center_ - start) <= 0.0) continue;
        const double bend = mesh_.bends[3 * t + k];
        const bool is_hollow = is_front ? bend < -level_bend : bend > level_bend;
        if (!is_hollow || !mesh_.is_smooth(3 * t + k)) return false;
        is_beyond = true;
    }
    return is_beyond && (!nearest.is_corner() || is_hollow_around(t, nearest.part, is_front));
}

/// Largest difference of overlaps that is blended in a patch [m]. Seen from the center of a ball of
/// radius R a face between two neighbors is narrower than it is by R times the angle.
double BallTouches::blend_of(std::uint32_t patch) const {
    const double bend = mesh_.least_bends[patch];
    const double within_faces = mesh_.blends[patch] - 0.5 * radius_ * square(bend);
    return std::max(0.0,
                    std::min({within_faces, most_blend * radius_, widest_blend * radius_ * bend}));
}

void BallTouches::keep(double overlap, const Vec3& normal, PatchSide side, bool is_blended) {
    const double blend = blend_of(side / 2);
    if (!(overlap > -blend)) return;
    const std::uint32_t number = sides_.number_of(side);
    const MeshTouch touch{overlap, normal, number, blend, is_blended};
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
void BallTouches::sort() {
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
BallTouches::Place BallTouches::blended(std::uint32_t first,
                                        const std::array<bool, capacity>& belongs) const {
    const MeshTouch& deepest = touches_[first];
    double width = deepest.blend;
    for (std::uint32_t k = first + 1; k < count_; ++k)
        if (belongs[k]) width = std::min(width, touches_[k].blend);
    Place place{deepest.overlap, deepest.normal};
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
    for (std::uint32_t k = first; k < count_; ++k) {
        if (!belongs[k] || !(depth(k) > level)) continue;
        const double share = depth(k) - level;
        squares += square(share);
        mean += share * depth(k);
        place.gradient += share * touches_[k].normal;
    }
    place.overlap = deepest.overlap + width * (mean + 0.5 * (1.0 - squares));
    return place;
}

}  // namespace dem::runtime
