// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/epa.hpp"

#include <limits>

namespace dem::runtime {

namespace {

/// Relative to the extent of the polytope: nearer to a face than this a point lies on it.
constexpr double flat = 1e-12;

template <std::size_t n, class Measure>
std::size_t most(const std::array<SimplexPoint, n>& points, const Measure& measure) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < n; ++k)
        if (measure(points[k].w) > measure(points[best].w)) best = k;
    return best;
}

}  // namespace

std::array<SimplexPoint, 4> widest(const std::array<SimplexPoint, 6>& supports) {
    const Vec3 a = supports[0].w;
    const std::size_t b = most(supports, [&](const Vec3& p) { return (p - a).squaredNorm(); });
    const Vec3 along = supports[b].w - a;
    const std::size_t c =
        most(supports, [&](const Vec3& p) { return along.cross(p - a).squaredNorm(); });
    const Vec3 normal = along.cross(supports[c].w - a);
    const std::size_t d =
        most(supports, [&](const Vec3& p) { return std::abs(normal.dot(p - a)); });
    return {supports[0], supports[b], supports[c], supports[d]};
}

bool ExpandingPolytope::start(const std::array<SimplexPoint, 4>& points) {
    std::copy(points.begin(), points.end(), points_.begin());
    point_count_ = 4;
    const Vec3& a = points[0].w;
    const Vec3 normal = (points[1].w - a).cross(points[2].w - a);
    const double height = normal.dot(points[3].w - a);
    const double extent = (points[1].w - a).norm();
    if (!(std::abs(height) > flat * extent * normal.norm())) return false;
    if (height > 0.0) std::swap(points_[1], points_[2]);
    return add_face(0, 1, 2) && add_face(0, 2, 3) && add_face(0, 3, 1) && add_face(1, 3, 2);
}

bool ExpandingPolytope::add_face(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
    const Vec3& p = points_[a].w;
    const Vec3 cross = (points_[b].w - p).cross(points_[c].w - p);
    const double length = cross.norm();
    std::size_t place = 0;
    while (place < face_count_ && faces_[place].is_alive) ++place;
    if (place == most_faces) return false;
    face_count_ = std::max(face_count_, place + 1);
    // A face without area has no normal: it is never the nearest and never seen.
    Face& face = faces_[place];
    face.point = {a, b, c};
    face.is_alive = true;
    face.normal = length > 0.0 ? Vec3(cross / length) : Vec3::Zero();
    face.offset = length > 0.0 ? face.normal.dot(p) : std::numeric_limits<double>::infinity();
    return true;
}

const ExpandingPolytope::Face& ExpandingPolytope::nearest() const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < face_count_; ++f) {
        if (faces_[f].is_alive && faces_[f].offset < least) {
            least = faces_[f].offset;
            best = f;
        }
    }
    return faces_[best];
}

bool ExpandingPolytope::add(const SimplexPoint& p) {
    if (point_count_ == most_points) return false;
    const double extent = (points_[1].w - points_[0].w).norm();
    std::array<bool, most_faces> sees{};
    for (std::size_t f = 0; f < face_count_; ++f) {
        const Face& face = faces_[f];
        sees[f] = face.is_alive && face.normal.dot(p.w) - face.offset > flat * extent;
    }
    // Sides of the seen part: directed edges whose opposite is not seen.
    std::array<std::array<std::uint8_t, 2>, 3 * static_cast<std::size_t>(most_points)> sides{};
    std::size_t side_count = 0;
    for (std::size_t f = 0; f < face_count_; ++f) {
        if (!sees[f]) continue;
        for (std::size_t e = 0; e < 3; ++e) {
            const std::uint8_t from = faces_[f].point[e];
            const std::uint8_t to = faces_[f].point[(e + 1) % 3];
            bool is_inner = false;
            for (std::size_t g = 0; g < face_count_ && !is_inner; ++g) {
                if (!sees[g] || g == f) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    is_inner = is_inner ||
                               (faces_[g].point[k] == to && faces_[g].point[(k + 1) % 3] == from);
                }
            }
            if (is_inner) continue;
            if (side_count == sides.size()) return false;
            sides[side_count++] = {from, to};
        }
    }
    if (side_count == 0) return false;
    for (std::size_t f = 0; f < face_count_; ++f)
        if (sees[f]) faces_[f].is_alive = false;
    const auto apex = static_cast<std::uint8_t>(point_count_);
    points_[point_count_++] = p;
    for (std::size_t k = 0; k < side_count; ++k)
        if (!add_face(sides[k][0], sides[k][1], apex)) return false;
    return true;
}

Penetration ExpandingPolytope::penetration(const Face& face) const {
    const SimplexPoint& a = points_[face.point[0]];
    const SimplexPoint& b = points_[face.point[1]];
    const SimplexPoint& c = points_[face.point[2]];
    const Vec3 foot = face.offset * face.normal;
    const Vec3 cross = (b.w - a.w).cross(c.w - a.w);
    const double area = cross.squaredNorm();
    Penetration result;
    result.depth = face.offset;
    result.normal = -face.normal;
    double w_a = 1.0;
    double w_b = 0.0;
    if (area > 0.0) {
        w_a = cross.dot((b.w - foot).cross(c.w - foot)) / area;
        w_b = cross.dot((c.w - foot).cross(a.w - foot)) / area;
    }
    const double w_c = 1.0 - w_a - w_b;
    result.point_i = w_a * a.a + w_b * b.a + w_c * c.a;
    result.point_j = w_a * a.b + w_b * b.b + w_c * c.b;
    return result;
}

}  // namespace dem::runtime
