// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/clump.hpp"
#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/fields/node_fields.hpp"
#include "runtime/contact/fields/node_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

/// Which spheres of a clump, or pairs of spheres of two, touch: the same ones, in rising order, as
/// a walk over all finds, by the two means of node_search.hpp, bounding balls and a list kept from
/// step to step. A set of such elements offers
///
///     Sample sample(k)              .distance: gap of element k, negative when it overlaps [m]
///     bool accepts(k, sample)       false where what it would touch has been cut off (a rim)
///     double visit_near(margin, f)  f(k, sample) for all nearer than the margin [m], in rising
///                                   order; returns a lower bound of the distance of the others
///     double proven_gap(d)          as of a field (node_fields.hpp)
namespace dem::runtime {

/// Calls visit(k, sample) for every element that touches, in rising order.
template <class Elements, class Visit>
void visit_touching(const Elements& elements, double margin, double travel, NearCache& cache,
                    const Visit& visit) {
    if (travel < cache.listed_until) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t n = 0; n < cache.count; ++n) {
            const auto sample = elements.sample(cache.nodes[n]);
            nearest = std::min(nearest, sample.distance);
            if (sample.distance < 0.0 && elements.accepts(cache.nodes[n], sample))
                visit(cache.nodes[n], sample);
        }
        cache.clear_until = std::min(cache.listed_until, travel + elements.proven_gap(nearest));
        return;
    }
    NodeListBuilder list(cache);
    const double others = elements.visit_near(margin, [&](std::uint32_t k, const auto& sample) {
        list.add(k, sample.distance);
        if (sample.distance < 0.0 && elements.accepts(k, sample)) visit(k, sample);
    });
    list.finish(others, elements, travel);
}

/// A clump, or a sphere as a clump of one, at its place relative to the center of i.
class PlacedSpheres {
  public:
    PlacedSpheres(const Clump& clump, const Quat& orientation, const Vec3& center)
        : PlacedSpheres(clump.spheres.span(), clump.balls.span(), orientation, center) {}
    PlacedSpheres(std::span<const ClumpSphere> spheres, std::span<const Clump::Ball> balls,
                  const Quat& orientation, const Vec3& center)
        : spheres_(spheres),
          balls_(balls),
          to_world_(orientation.toRotationMatrix()),
          center_(center) {}

    std::uint32_t count() const { return static_cast<std::uint32_t>(spheres_.size()); }
    double radius(std::uint32_t k) const { return spheres_[k].radius; }
    Vec3 place(const Vec3& x_body) const { return center_ + to_world_ * x_body; }
    Vec3 center(std::uint32_t k) const { return place(spheres_[k].center()); }
    /// A place in the frame of the body.
    Vec3 in_body(const Vec3& x) const { return to_world_.transpose() * (x - center_); }
    /// A ball around all spheres, body frame.
    Clump::Ball bound() const {
        const ClumpSphere& s = spheres_[0];
        return balls_.empty() ? Clump::Ball{s.x, s.y, s.z, s.radius} : balls_.back();
    }

    template <class Skip, class Visit>
    void visit(const Skip& skip, const Visit& visit) const {
        visit_spheres(spheres_, ClumpLevels(spheres_.size(), balls_), skip, visit);
    }

  private:
    std::span<const ClumpSphere> spheres_;
    std::span<const Clump::Ball> balls_;
    Mat3 to_world_;
    Vec3 center_;
};

/// All pairs of a sphere of i with one of j; pair k is of sphere k / count(j) and sphere k %
/// count(j).
struct SpherePairs {
    struct Sample {
        double distance;  ///< gap [m]
        double centers;   ///< distance of the centers [m]
        Vec3 center_i;    ///< [m]
        Vec3 from_j;      ///< from the center of j's sphere to that of i's [m]
        double radius_i, radius_j;
    };

    const PlacedSpheres& i;
    const PlacedSpheres& j;
    double rounding;  ///< of positions and travels, generously [m]

    Sample sample(std::uint32_t k) const { return sample(k / j.count(), k % j.count()); }
    Sample sample(std::uint32_t a, std::uint32_t b) const {
        const Vec3 x = i.center(a);
        const Vec3 d = x - j.center(b);
        const double centers = d.norm();
        const double reach = i.radius(a) + j.radius(b);
        return {centers - reach, centers, x, d, i.radius(a), j.radius(b)};
    }
    static bool accepts(std::uint32_t /*k*/, const Sample& /*sample*/) { return true; }
    double proven_gap(double distance) const { return distance - rounding; }

    template <class Visit>
    double visit_near(double margin, const Visit& visit) const {
        double others = std::numeric_limits<double>::infinity();
        const double limit = margin + rounding;
        // Whether balls of these centers and radii are farther apart than the margin.
        const auto are_apart = [&](const Vec3& x, double radius_x, const Clump::Ball& ball) {
            const double gap = (x - ball.center()).norm() - radius_x - ball.radius;
            if (gap < limit) return false;
            others = std::min(others, gap);
            return true;
        };
        const Clump::Ball all_j = j.bound();
        const auto visit_partners = [&](std::uint32_t a) {
            const Vec3 x = j.in_body(i.center(a));
            j.visit([&](const Clump::Ball& ball) { return are_apart(x, i.radius(a), ball); },
                    [&](std::uint32_t b) {
                        const Sample s = sample(a, b);
                        if (s.distance < margin)
                            visit(a * j.count() + b, s);
                        else
                            others = std::min(others, s.distance);
                    });
        };
        i.visit(
            [&](const Clump::Ball& ball) {
                return are_apart(j.in_body(i.place(ball.center())), ball.radius, all_j);
            },
            visit_partners);
        return others;
    }
};

/// The spheres of a clump in a field (node_fields.hpp) given relative to the center of i.
template <class Field>
struct SpheresInField {
    struct Sample {
        double distance;               ///< gap [m]
        Vec3 center;                   ///< [m]
        double radius;                 ///< [m]
        typename Field::Sample field;  ///< at the center
    };

    const PlacedSpheres& spheres;
    const Field& field;

    Sample sample(std::uint32_t k) const {
        const Vec3 x = spheres.center(k);
        const auto at_center = field.sample(x);
        return {at_center.distance - spheres.radius(k), x, spheres.radius(k), at_center};
    }
    bool accepts(std::uint32_t /*k*/, const Sample& s) const { return field.accepts(s.center); }
    double proven_gap(double distance) const { return field.proven_gap(distance); }

    template <class Visit>
    double visit_near(double margin, const Visit& visit) const {
        double others = std::numeric_limits<double>::infinity();
        spheres.visit(
            [&](const Clump::Ball& ball) {
                const double bound =
                    field.sample(spheres.place(ball.center())).distance - ball.radius - field.slack;
                if (bound < margin) return false;
                others = std::min(others, bound);
                return true;
            },
            [&](std::uint32_t k) {
                const Sample s = sample(k);
                if (s.distance < margin)
                    visit(k, s);
                else
                    others = std::min(others, s.distance);
            });
        return others;
    }
};

}  // namespace dem::runtime
