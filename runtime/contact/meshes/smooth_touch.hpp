// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "runtime/contact/meshes/mesh_touches.hpp"
#include "runtime/contact/smooth/common_normal.hpp"
#include "runtime/contact/smooth/mean_place.hpp"

#include <algorithm>
#include <cmath>

/// Where a convex body that is known by its support function touches a surface of triangles
/// (docs/mesh-walls.md, "Smooth bodies").
namespace dem::runtime {

/// How such a body lies, frame of the mesh.
struct SmoothBody {
    Vec3 center;    ///< [m]
    Vec3 axis;      ///< unit
    double radius;  ///< bounding radius [m]
    Vec3 spin;      ///< how far it turns relative to the wall in a step [rad]
};

struct PointSupport {
    SupportSample operator()(const Vec3& /*n*/) const {
        return {0.0, Vec3::Zero(), 0.0, 0.0, 0.0, no_jump};
    }
};

/// What the body touches, gathered triangle by triangle in rising order. Along a unit normal n of
/// the surface, towards the body, its overlap with a point p of the surface is
///     F(n) = h(-n) - n.(c - p),
/// c its center. A face has its own normal and is touched where the body's place, the support point
/// of -n, is over it. An edge that bulges is touched at the minimum of F over the normals between
/// those of its faces, a corner at the minimum over those between its edges: at a minimum within
/// the range the body's place is on the normal through p. Where the range ends the neighbor goes
/// on with the same normal, place and overlap: F is one potential, without gaps.
template <class Support>
class SmoothTouches : public MeshTouches {
  public:
    SmoothTouches(const WallMesh& mesh, const Support& support, const SmoothBody& body,
                  const MeshHistory& history, TouchedSides& sides)
        : MeshTouches(mesh, body.center, body.radius, history, sides),
          support_(support),
          body_(body) {}

    /// Adds what of triangle t is touched. Returns the distance of its nearest point from the
    /// center [m].
    double add(std::uint32_t t) {
        const TrianglePoint nearest = nearest_of(t, center_);
        const double distance = (center_ - nearest.point).norm();
        if (!(distance < reach_)) return distance;
        add_face(t);
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            add_edge(h);
            add_corner(h);
        }
        return distance;
    }

    /// Leaves out what the body is free of once it is free of something beside it: where the
    /// surface bulges there may be several minima of F around a corner, the lowest of which counts.
    void leave_lowest();

  private:
    bool frees(const MeshTouch& touch, const MeshTouch& other) const;
    /// Along the normals between two faces of an edge.
    struct Probe {
        double angle, f, slope, curvature;
        Vec3 n, point;
    };
    struct Arc {
        Vec3 corner, start, outward;
        double end;  ///< [rad]
    };

    TrianglePoint nearest_of(std::uint32_t t, const Vec3& x) const {
        return nearest_on_triangle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), x);
    }
    double slack() const { return rounding * radius_; }
    /// Unit, in the plane of its triangle, away from it.
    Vec3 outward(std::uint32_t h) const {
        const Vec3 along = mesh_.corner(h / 3, (h + 1) % 3) - mesh_.corner(h / 3, h % 3);
        return along.cross(mesh_.normals[h / 3]).normalized();
    }
    void add_face(std::uint32_t t);
    NormalProbe deepest(const Vec3& to, const Vec3& start) const;
    bool is_behind(std::uint32_t t, const Vec3& x, double height, double overlap) const;
    void add_edge(std::uint32_t h);
    double arc_end(std::uint32_t h, const Vec3& n, const Vec3& out) const;
    void add_arc(std::uint32_t h, const Arc& arc);
    Probe probe_at(const Arc& arc, double angle) const;
    bool bracket(const Arc& arc, Probe& low, Probe& high) const;
    Probe minimum(const Arc& arc, Probe low, Probe high) const;
    void add_corner(std::uint32_t h);
    bool is_normal_at(std::uint32_t vertex, const Vec3& n, double most) const;
    bool is_flat_at(std::uint32_t vertex, const Vec3& n) const;

    const Support& support_;
    SmoothBody body_;
};

template <class Support>
void SmoothTouches<Support>::add_face(std::uint32_t t) {
    const double height = (center_ - mesh_.corner(t, 0)).dot(mesh_.normals[t]);
    const bool is_front = height >= 0.0;
    const Vec3 normal = is_front ? mesh_.normals[t] : Vec3(-mesh_.normals[t]);
    const SupportSample s = support_(-normal);
    const double overlap = s.h - std::abs(height);
    if (!(overlap > -most_blend * radius_)) return;
    const PlaneSwing<double> swing = plane_swing<double>(body_.axis, normal, body_.spin);
    const std::optional<Vec3> mean = mean_place(support_, s, normal, swing, radius_);
    const Vec3 point = center_ + (mean ? *mean : s.point(-normal));
    const Vec3 foot = point - (point - mesh_.corner(t, 0)).dot(normal) * normal;
    const TrianglePoint nearest = nearest_of(t, foot);
    const double beside2 = (foot - nearest.point).squaredNorm();
    const PatchSide side = 2 * mesh_.patches[t] + (is_front ? 0U : 1U);
    if (nearest.part == TrianglePoint::inside || beside2 <= square(slack())) {
        if (overlap > 0.0) {
            if (!is_behind(t, point, std::abs(height), overlap)) return;
            if (!history_.knows(side) && history_.knows(other_side(side)) && overlap > 0.1 * s.h)
                is_lost_ = true;
        }
        keep(overlap, normal, side, false, {point, mesh_.triangles[t]});
        return;
    }
    if (beside2 <= square(widest_blend * radius_) && is_blended(t, nearest, is_front, foot))
        keep(overlap, normal, side, true, {point, mesh_.triangles[t]});
}

/// Whether a place of the body has come through a face from the side of the center. It may be on
/// the other side because the center is beyond an edge: then its foot is not in the body.
template <class Support>
bool SmoothTouches<Support>::is_behind(std::uint32_t t, const Vec3& x, double height,
                                       double overlap) const {
    const Vec3 through = center_ + height / (height + overlap) * (x - center_);
    const TrianglePoint nearest = nearest_of(t, through);
    if (nearest.part == TrianglePoint::inside ||
        (through - nearest.point).squaredNorm() <= square(slack()))
        return true;
    const Vec3& n = mesh_.normals[t];
    const Vec3 to = x - (x - mesh_.corner(t, 0)).dot(n) * n - center_;
    const double distance = to.norm();
    return distance <= slack() || deepest(to, to / distance).f > 0.0;
}

/// The direction along which a point, relative to the center, is nearest to the surface of the
/// body, from a direction on; f < 0: it is outside.
template <class Support>
NormalProbe SmoothTouches<Support>::deepest(const Vec3& to, const Vec3& start) const {
    return common_normal(support_, PointSupport{}, to, start);
}

template <class Support>
void SmoothTouches<Support>::add_edge(std::uint32_t h) {
    const Vec3& a = mesh_.corner(h / 3, h % 3);
    const Vec3& b = mesh_.corner(h / 3, (h + 1) % 3);
    const std::uint32_t twin = mesh_.twins[h];
    const bool is_rim = twin == h;
    // Every edge of two faces once.
    if (!is_rim && mesh_.twins[twin] == h && twin < h) return;
    const Vec3 along = b - a;
    const double share = std::clamp((center_ - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    if (!((a + share * along - center_).squaredNorm() < square(radius_))) return;
    const Vec3 out = outward(h);
    for (const double sign : {1.0, -1.0}) {
        const Vec3 n = sign * mesh_.normals[h / 3];
        const double end = is_rim ? pi : arc_end(h, n, out);
        if (end > 1e-9) add_arc(h, {a, n, out, end});
        if (is_rim) return;
    }
}

/// How far the normals of an edge reach from that of the face of half edge h [rad]; 0: no way.
template <class Support>
double SmoothTouches<Support>::arc_end(std::uint32_t h, const Vec3& n, const Vec3& out) const {
    double end = pi;
    for (std::uint32_t g = mesh_.twins[h]; g != h; g = mesh_.twins[g]) {
        const Vec3 into = -outward(g);
        const double a = n.dot(into);
        if (!(a < 0.0)) return 0.0;
        end = std::min(end, math::atan2(-a, out.dot(into)));
    }
    return end;
}

template <class Support>
typename SmoothTouches<Support>::Probe SmoothTouches<Support>::probe_at(const Arc& arc,
                                                                        double angle) const {
    const math::SineCosine turn = math::sin_cos(angle);
    const Vec3 n = turn.cosine * arc.start + turn.sine * arc.outward;
    const Vec3 ahead = turn.cosine * arc.outward - turn.sine * arc.start;
    const SupportSample s = support_(-n);
    const Vec3 from = center_ - arc.corner;
    const Vec3 point = s.point(-n);
    const double f = s.h - n.dot(from);
    const double curvature = s.across + s.excess * square(s.meridian.dot(ahead)) - f;
    return {angle, f, -ahead.dot(point + from), curvature, n, center_ + point};
}

/// Two normals between which F has its lowest minimum, if that is within the arc.
template <class Support>
bool SmoothTouches<Support>::bracket(const Arc& arc, Probe& low, Probe& high) const {
    constexpr double widest = 0.3;
    const int steps = std::max(1, static_cast<int>(std::ceil(arc.end / widest)));
    low = probe_at(arc, 0.0);
    high = probe_at(arc, arc.end);
    if (steps > 1) {
        int best = 0;
        double least = low.f;
        for (int k = 1; k <= steps; ++k) {
            const double f = k == steps ? high.f : probe_at(arc, arc.end * k / steps).f;
            if (!(f < least)) continue;
            least = f;
            best = k;
        }
        if (best > 1) low = probe_at(arc, arc.end * (best - 1) / steps);
        if (best + 1 < steps) high = probe_at(arc, arc.end * (best + 1) / steps);
    }
    return low.slope < 0.0 && high.slope > 0.0;
}

/// Newton within the bracket, halved where that does not get along.
template <class Support>
typename SmoothTouches<Support>::Probe SmoothTouches<Support>::minimum(const Arc& arc, Probe low,
                                                                       Probe high) const {
    constexpr int most_steps = 80;
    Probe p = -low.slope < high.slope ? low : high;
    for (int k = 0; k < most_steps; ++k) {
        const double newton = p.angle - p.slope / p.curvature;
        const bool is_useful =
            p.curvature > 0.0 && newton > low.angle && newton < high.angle && k % 4 != 3;
        const double next = is_useful ? newton : 0.5 * (low.angle + high.angle);
        const double step = std::abs(next - p.angle);
        p = probe_at(arc, next);
        if (p.slope < 0.0)
            low = p;
        else
            high = p;
        if (step < 1e-14 || std::abs(p.slope) < 1e-15 * radius_) break;
    }
    return p;
}

template <class Support>
void SmoothTouches<Support>::add_arc(std::uint32_t h, const Arc& arc) {
    Probe low;
    Probe high;
    if (!bracket(arc, low, high)) return;
    const Probe p = minimum(arc, low, high);
    if (!(p.f > 0.0) || !(p.f < (center_ - arc.corner).dot(p.n))) return;
    const Vec3 along = mesh_.corner(h / 3, (h + 1) % 3) - arc.corner;
    const double way = (p.point - arc.corner).dot(along);
    const double slack = this->slack() * along.norm();
    if (!(way >= -slack && way <= along.squaredNorm() + slack)) return;
    join_around(h, p.n);
    const std::uint32_t first = mesh_.triangles[h / 3][h % 3];
    const std::uint32_t second = mesh_.triangles[h / 3][(h + 1) % 3];
    keep(p.f, p.n, side_of(h / 3, p.n), false, {p.point, {first, second, second}});
}

/// Whether n leads away from everything around a corner.
template <class Support>
bool SmoothTouches<Support>::is_normal_at(std::uint32_t vertex, const Vec3& n, double most) const {
    const Vec3& x = mesh_.vertices[vertex];
    for (std::uint32_t k = mesh_.fan_begin[vertex]; k < mesh_.fan_begin[vertex + 1]; ++k) {
        const Vec3 way = mesh_.vertices[mesh_.fan[k]] - x;
        if (n.dot(way) > most * way.norm()) return false;
    }
    return true;
}

template <class Support>
bool SmoothTouches<Support>::is_flat_at(std::uint32_t vertex, const Vec3& n) const {
    return is_normal_at(vertex, n, 1e-9) && is_normal_at(vertex, -n, 1e-9);
}

/// The corner at which half edge h begins.
template <class Support>
void SmoothTouches<Support>::add_corner(std::uint32_t h) {
    const std::uint32_t vertex = mesh_.triangles[h / 3][h % 3];
    const Vec3 to = mesh_.vertices[vertex] - center_;
    const double distance = to.norm();
    if (!(distance < radius_) || !(distance > slack())) return;
    const Vec3 towards = to / distance;
    if (!(support_(towards).h > distance)) return;
    const Vec3& front = mesh_.normals[h / 3];
    if (is_flat_at(vertex, front)) return;
    const PointSupport point;
    NormalProbe start = probe(support_, point, to, towards);
    for (const double sign : {1.0, -1.0}) {
        const NormalProbe other = probe(support_, point, to, Vec3(sign * front));
        if (other.f > 0.0 && other.f < start.f) start = other;
    }
    const NormalProbe p = descend(support_, point, to, start);
    const Vec3 n = -p.n;
    if (!(p.f > 0.0) || !(p.f < to.dot(p.n)) || !is_normal_at(vertex, n, 1e-8)) return;
    join_around(h, n);
    join_around(h - h % 3 + (h + 2) % 3, n);
    keep(p.f, n, side_of(h / 3, n), false, {center_ + p.i.point(p.n), {vertex, vertex, vertex}});
}

/// Whether something touched is beside another thing and behind the plane along which the body is
/// moved off that.
template <class Support>
bool SmoothTouches<Support>::frees(const MeshTouch& touch, const MeshTouch& other) const {
    if (touch.is_blended || other.is_blended) return false;
    const Vec3 to_other =
        other.point + other.overlap * other.normal - touch.point - touch.overlap * touch.normal;
    if (!(to_other.dot(touch.normal) <= slack())) return false;
    for (const std::uint32_t a : touch.corners)
        for (const std::uint32_t b : other.corners)
            if (a == b) return true;
    return false;
}

template <class Support>
void SmoothTouches<Support>::leave_lowest() {
    std::uint32_t kept = 0;
    std::array<bool, capacity> is_left_out{};
    for (std::uint32_t k = 0; k < count_; ++k)
        for (std::uint32_t m = 0; m < count_; ++m) {
            const bool is_lower = touches_[m].overlap > 0.0 &&
                                  (touches_[m].overlap < touches_[k].overlap ||
                                   (touches_[m].overlap == touches_[k].overlap && m < k));
            if (is_lower && frees(touches_[m], touches_[k])) is_left_out[k] = true;
        }
    for (std::uint32_t k = 0; k < count_; ++k)
        if (!is_left_out[k]) touches_[kept++] = touches_[k];
    count_ = kept;
}

}  // namespace dem::runtime
