// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/sr_sr_continuous.hpp"

#include "runtime/contact/common_normal.hpp"
#include "runtime/contact/convex_contact.hpp"
#include "runtime/contact/wall_frame.hpp"

namespace dem {

namespace {

/// One side of the pair: support function in the world frame, and sizes.
template <class Support>
struct Side {
    Support support;
    double bounding_radius;      ///< [m]
    double equivalent_diameter;  ///< [m]
};

Side<SrSupport> side(const SrShape& shape, const BodyState& body) {
    return {{shape.support, body_axis(body.orientation)},
            shape.bounding_radius,
            shape.equivalent_diameter};
}
Side<SphereSupport> side(const Sphere& shape, const BodyState&) {
    return {{shape.radius}, shape.radius, 2.0 * shape.radius};
}

template <class SupportI, class SupportJ>
PairContact convex_contact(const Side<SupportI>& i, const Side<SupportJ>& j, const PairState& pair,
                           const ContactLaw& law, double dt, PointHistory& history,
                           MissCache& miss) {
    const Vec3& d = pair.displacement;
    const double distance = d.norm();
    const bool touched = history.effective_radius > 0.0;
    const double reach = i.bounding_radius + j.bounding_radius;
    if (distance > reach) return no_contact(history, miss, distance - reach, miss.axis);

    const auto separated = [&](const NormalProbe& p) {
        return p.f < -NormalSearch::margin * distance;
    };
    if (!touched && Vec3(miss.axis).squaredNorm() > 0.0) {
        const NormalProbe p = common_normal(i.support, j.support, d, miss.axis);
        if (separated(p)) return no_contact(history, miss, -p.f, p.n);
    }
    Vec3 start = -Vec3(history.normal);
    if (!touched) start = distance > 0.0 ? Vec3(d / distance) : Vec3::UnitZ();
    const NormalProbe p = common_normal(i.support, j.support, d, start);
    if (!(p.f > 0.0)) return no_contact(history, miss, -p.f, p.n);

    const Vec3 on_i = p.i.point(p.n);
    const Vec3 on_j = d + p.j.point(-p.n);
    const ContactPoint point{0.5 * (on_i + on_j), -p.n, p.f, 0};
    double radius = 0.0;
    if (hertz::needs_local_radius(law, history))
        radius = contact_radius(law, p.i, i.equivalent_diameter, p.j, j.equivalent_diameter);
    return contact_force(point, radius, pair, law, dt, history);
}

}  // namespace

PairContact collide(const SrShape& a, const SrShape& b, const PairState& pair,
                    const ContactLaw& law, double dt, PointHistory& history, MissCache& miss) {
    return convex_contact(side(a, pair.i), side(b, pair.j), pair, law, dt, history, miss);
}

PairContact collide(const Sphere& a, const SrShape& b, const PairState& pair, const ContactLaw& law,
                    double dt, PointHistory& history, MissCache& miss) {
    return convex_contact(side(a, pair.i), side(b, pair.j), pair, law, dt, history, miss);
}

PairContact collide(const SrShape& a, const Sphere& b, const PairState& pair, const ContactLaw& law,
                    double dt, PointHistory& history, MissCache& miss) {
    return convex_contact(side(a, pair.i), side(b, pair.j), pair, law, dt, history, miss);
}

}  // namespace dem
