// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/core_pair.hpp"
#include "runtime/contact/cores/ellipsoid_normal.hpp"
#include "runtime/integrator/rigid_body.hpp"
#include "tests/physics/convex_combinations.hpp"
#include "tests/runtime/contact/cores/polyhedron_gap.hpp"
#include "tests/runtime/contact/cores/round_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <gtest/gtest.h>

/// Overlap and normal of convex pairs against a second method, for the eight combinations of [GC]
/// Sec. 6.2. PAIRS of each combination, overlaps from 1e-6 to 0.1 of the size, attitudes at random
/// and tilted against flat on flat by 1 down to 0.
namespace dem::test {

using namespace runtime;

namespace {

constexpr double size = 1.0;

/// What a contact is made of.
struct Deepest {
    double overlap;
    Vec3 normal;            ///< from j towards i
    bool is_start = false;  ///< of several features, or cores that overlap: where to look for them
};

/// As the kernel finds it. Cylinders touch by their features: where that is one, it counts, else
/// the nearest points that lead to the features, without the error that these make up for.
Deepest found_by_kernel(const ConvexShape& a, const ConvexShape& b, const PairState& pair) {
    const Vec3& d = pair.displacement;
    if (a.is_strictly_convex() && b.is_strictly_convex()) {
        const EllipsoidNormal at = common_normal({a, pair.i.orientation}, {b, pair.j.orientation},
                                                 d, -Vec3(canonical_start(d).direction));
        return {at.overlap, -at.n};
    }
    const PlacedCore i(a, pair.i.orientation, Vec3::Zero());
    const PlacedCore j(b, pair.j.orientation, d);
    CoreDistance found = core_distance(i, j, canonical_start(d), 0.0);
    EXPECT_LT(found.evaluations, gjk::most_evaluations);
    sharpen_single(i, j, found);
    const ConvexTouch touch = touch_of(i, j, found);
    const bool is_point = a.is_strictly_convex() || b.is_strictly_convex();
    const bool are_polyhedra = a.is_polyhedron() && b.is_polyhedron();
    if (is_point || are_polyhedra) return {touch.point.overlap, touch.point.normal};
    if (!found.overlaps && touch.point.overlap > 0.0) {
        ConvexHistory history;
        MissCache miss;
        ConvexScratch scratch;
        FeatureSum features(pair, touch.point.overlap);
        const ContactLaw law;
        const CoreCall call{pair, law, 0.0, {history, miss}, 0.0, {nullptr, &scratch}};
        add_features(i, j, touch, call, features);
        // What the nearest points still count beside a feature is rounding.
        const bool is_one = features.count() == 1 ||
                            (features.count() == 2 && std::abs(features.power() - 1.0) < 1e-8);
        if (is_one) return {features.overlap(), features.direction().force.normalized()};
    }
    return {touch.point.overlap, touch.point.normal, true};
}

/// Overlap of two bodies along a direction, from j towards i: the true one is the least of all.
double overlap_along(const PlacedCore& i, const PlacedCore& j, const Vec3& n) {
    return i.rounding + j.rounding + n.dot(j.support(n, 0).position - i.support(-n, 0).position);
}

/// Polyhedra that overlap: the least overlap along all normals of faces and all cross products of
/// edges.
void try_axes(const PlacedCore& i, const PlacedCore& j, Deepest& best) {
    best.overlap = std::numeric_limits<double>::infinity();
    const auto offer = [&](const Vec3& n) {
        const double overlap = overlap_along(i, j, n);
        if (overlap < best.overlap) best = {overlap, n};
    };
    for (const ConvexShape::Plane& face : i.shape.planes) offer(-i.turned(face.normal));
    for (const ConvexShape::Plane& face : j.shape.planes) offer(j.turned(face.normal));
    for (const ConvexShape::Edge& e : i.shape.edges) {
        for (const ConvexShape::Edge& f : j.shape.edges) {
            const Vec3 n = direction_of(i, e).cross(direction_of(j, f));
            if (n.norm() < 1e-9) continue;
            offer(n.normalized());
            offer(-n.normalized());
        }
    }
}

/// Others: what no direction beats, of many and of ever nearer neighbors of the best one.
class DirectionSearch {
  public:
    DirectionSearch(const PlacedCore& i, const PlacedCore& j, Random& random)
        : i_(i), j_(j), best_{std::numeric_limits<double>::infinity(), Vec3::UnitZ()} {
        for (int k = 0; k < 300; ++k) offer(random.direction());
        refine();
    }
    /// Goes on from another direction if that is better.
    void refine_from(const Vec3& n) {
        if (offer(n)) refine();
    }
    const Deepest& best() const { return best_; }

  private:
    bool offer(const Vec3& n) {
        const double overlap = overlap_along(i_, j_, n);
        if (!(overlap < best_.overlap)) return false;
        best_ = {overlap, n};
        return true;
    }
    void refine() {
        for (double step = 0.1; step > 1e-9; step *= 0.5) {
            bool has_moved = true;
            for (int k = 0; k < 100 && has_moved; ++k) {
                const Vec3 n = best_.normal;
                const Vec3 across = n.unitOrthogonal();
                has_moved = false;
                for (int m = 0; m < 8; ++m) {
                    const double angle = 0.25 * pi * m;
                    const Vec3 side = std::cos(angle) * across + std::sin(angle) * n.cross(across);
                    has_moved = offer((n + step * side).normalized()) || has_moved;
                }
            }
        }
    }

    const PlacedCore& i_;
    const PlacedCore& j_;
    Deepest best_;
};

Deepest reference(const PlacedCore& i, const PlacedCore& j, const Deepest& found, Random& random) {
    Deepest best{-std::numeric_limits<double>::infinity(), found.normal};
    const bool are_apart = found.overlap < i.rounding + j.rounding;
    const bool are_round = !i.has_vertices() || !j.has_vertices();
    if (are_round && are_apart) {
        const SurfaceDistance gap = RoundGap(i, j).least();
        return {i.rounding + j.rounding - gap.distance, gap.normal};
    }
    if (are_round) {
        DirectionSearch search(i, j, random);
        search.refine_from(found.normal);
        return search.best();
    }
    if (!are_apart) {
        try_axes(i, j, best);
        return best;
    }
    const SurfaceDistance gap = polyhedron_gap(i, j);
    return {i.rounding + j.rounding - gap.distance, gap.normal};
}

Quat tilted_to(const Vec3& direction, double tilt, Random& random) {
    const Quat spun =
        orientation_towards(direction) * rotation(random.uniform(0.0, 2.0 * pi) * Vec3::UnitZ());
    return rotation(tilt * random.uniform() * random.direction()) * spun;
}

/// Largest errors over some pairs.
struct Errors {
    double overlap = 0.0;   ///< relative
    double distance = 0.0;  ///< [m]
    double normal = 0.0;    ///< [rad]
    double start = 0.0;     ///< of normals that only lead to the features [rad]
    double deep = 0.0;      ///< likewise, where cores overlap [rad]
    int pairs = 0;
};

Errors compare(const ConvexShape& a, const ConvexShape& b, int pairs) {
    Errors worst;
    Random random(31, 7);
    for (int k = 0; worst.pairs < pairs; ++k) {
        PairState pair{};
        const Vec3 direction = random.direction();
        const double tilt = k % 8 == 0 ? 0.0 : std::pow(10.0, random.uniform(-9.0, 0.0));
        pair.i.orientation = k % 2 == 0 ? random.orientation() : tilted_to(direction, tilt, random);
        pair.j.orientation = k % 2 == 0 ? random.orientation() : tilted_to(direction, tilt, random);
        const Vec3 beside = random.uniform(0.0, 0.4) * direction.unitOrthogonal();
        const double wanted = std::pow(10.0, random.uniform(-6.0, -1.0)) * size;
        const auto at = [&](double x) {
            pair.displacement = x * direction + beside;
            return found_by_kernel(a, b, pair).overlap;
        };
        double low = 0.0;
        double high = 4.0 * size;
        for (int step = 0; step < 40; ++step) {
            const double middle = 0.5 * (low + high);
            (at(middle) > wanted ? low : high) = middle;
        }
        at(low);
        const Deepest found = found_by_kernel(a, b, pair);
        if (!(found.overlap > 0.0 && found.overlap < 0.15 * size)) continue;
        ++worst.pairs;
        const PlacedCore i(a, pair.i.orientation, Vec3::Zero());
        const PlacedCore j(b, pair.j.orientation, pair.displacement);
        const Deepest expected = reference(i, j, found, random);
        const double off = std::abs(found.overlap - expected.overlap);
        worst.distance = std::max(worst.distance, off);
        worst.overlap = std::max(worst.overlap, off / expected.overlap);
        // Where the overlap hardly depends on the direction, that is as good as any.
        const double along = overlap_along(i, j, found.normal);
        const bool is_deep = found.overlap >= i.rounding + j.rounding;
        double& normal = !found.is_start ? worst.normal : is_deep ? worst.deep : worst.start;
        if (along > (1.0 + 1e-12) * expected.overlap)
            normal = std::max(normal, found.normal.cross(expected.normal).norm());
    }
    return worst;
}

TEST(ConvexReference, OverlapAndNormalOfTheEightCombinations) {
    for (const Combination& c : combinations(size)) {
        const bool are_polyhedra = c.a.shape.is_polyhedron() && c.b.shape.is_polyhedron();
        const Errors worst = compare(c.a.shape, c.b.shape, PAIRS);
        const double aim = are_polyhedra ? 1e-6 : 1e-5;
        EXPECT_LT(worst.overlap, aim) << c.name;
        EXPECT_LT(worst.normal, aim) << c.name;
        EXPECT_LT(worst.start, 5e-5) << c.name;
        EXPECT_LT(worst.deep, 1e-3) << c.name;  // where the overlap hardly depends on it
        std::printf("%-28s overlap %.1e (%.1e of the size), normal %.1e rad, start %.1e %.1e rad\n",
                    c.name, worst.overlap, worst.distance / size, worst.normal, worst.start,
                    worst.deep);
    }
}

}  // namespace
}  // namespace dem::test
