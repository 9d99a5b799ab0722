// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/gjk.hpp"

namespace dem::runtime {

namespace {

/// A candidate for the nearest point: which points of the simplex it lies between.
struct Candidate {
    double distance2 = std::numeric_limits<double>::infinity();
    std::array<std::size_t, 3> index{};
    std::array<double, 3> weight{};
    int count = 0;
};

void offer(Candidate& best, const Candidate& other) {
    if (other.distance2 < best.distance2) best = other;
}

Candidate of_point(const Simplex& s, std::size_t a) {
    return {s.point[a].w.squaredNorm(), {a}, {1.0}, 1};
}

/// Nearest point of a segment, its ends included.
Candidate of_segment(const Simplex& s, std::size_t a, std::size_t b) {
    const Vec3& p = s.point[a].w;
    const Vec3& q = s.point[b].w;
    const Vec3 along = q - p;
    const double length2 = along.squaredNorm();
    const double t = -p.dot(along);
    if (!(t > 0.0)) return of_point(s, a);
    if (!(t < length2)) return of_point(s, b);
    const double u = t / length2;
    // Measured from the nearer end: fewer digits are lost.
    const Vec3 v = u < 0.5 ? Vec3(p + u * along) : Vec3(q - (1.0 - u) * along);
    return {v.squaredNorm(), {a, b}, {1.0 - u, u}, 2};
}

/// Nearest point of a triangle. Weights are the areas that the projected origin spans with the
/// sides; where one is not positive the sides are asked, all of them, for a thin triangle may show
/// wrong signs.
Candidate of_triangle(const Simplex& s, std::size_t a, std::size_t b, std::size_t c) {
    const Vec3& p = s.point[a].w;
    const Vec3& q = s.point[b].w;
    const Vec3& r = s.point[c].w;
    const Vec3 n = (q - p).cross(r - p);
    const double n2 = n.squaredNorm();
    const double w_a = n.dot(q.cross(r));
    const double w_b = n.dot(r.cross(p));
    const double w_c = n.dot(p.cross(q));
    if (w_a > 0.0 && w_b > 0.0 && w_c > 0.0 && n2 > 0.0) {
        const double sum = w_a + w_b + w_c;
        const double height = n.dot(p);
        return {height * height / n2, {a, b, c}, {w_a / sum, w_b / sum, w_c / sum}, 3};
    }
    Candidate best = of_segment(s, a, b);
    offer(best, of_segment(s, b, c));
    offer(best, of_segment(s, c, a));
    return best;
}

/// Signs of the origin and the fourth point seen from the plane of the other three.
bool on_same_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& fourth) {
    const Vec3 n = (b - a).cross(c - a);
    const double origin = -n.dot(a);
    const double other = n.dot(fourth - a);
    // A flat tetrahedron has no inside.
    const double least = 1e-14 * n.norm() * (fourth - a).norm();
    return (origin > 0.0 && other > least) || (origin < 0.0 && other < -least);
}

bool holds_origin(const Simplex& s) {
    const Vec3& a = s.point[0].w;
    const Vec3& b = s.point[1].w;
    const Vec3& c = s.point[2].w;
    const Vec3& d = s.point[3].w;
    return on_same_side(a, b, c, d) && on_same_side(b, c, d, a) && on_same_side(c, d, a, b) &&
           on_same_side(d, a, b, c);
}

}  // namespace

bool reduce(Simplex& simplex) {
    Candidate best;
    switch (simplex.count) {
        case 1:
            best = of_point(simplex, 0);
            break;
        case 2:
            best = of_segment(simplex, 0, 1);
            break;
        case 3:
            best = of_triangle(simplex, 0, 1, 2);
            break;
        default:
            if (holds_origin(simplex)) return false;
            best = of_triangle(simplex, 0, 1, 2);
            offer(best, of_triangle(simplex, 0, 1, 3));
            offer(best, of_triangle(simplex, 0, 2, 3));
            offer(best, of_triangle(simplex, 1, 2, 3));
            break;
    }
    // Indices of a candidate need not rise.
    const std::array<SimplexPoint, 4> points = simplex.point;
    simplex.count = best.count;
    for (std::size_t k = 0; k < static_cast<std::size_t>(best.count); ++k) {
        simplex.point[k] = points[best.index[k]];
        simplex.weight[k] = best.weight[k];
    }
    return true;
}

}  // namespace dem::runtime
