// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/solids/make_convex.hpp"
#include "tests/physics/contact_of.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/sample_clumps.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <array>
#include <map>

/// Balls as bodies of every kind: what holds for spheres in closed form is asked of all.
namespace dem::test {

using namespace runtime;
using namespace shapegen;

/// A sphere as one of the kinds of bodies.
struct KindOfBall {
    const char* name;
    Contact (*on_plane)(double radius, const ContactLaw& law);
    Contact (*of_pair)(double radius_i, double radius_j, const ContactLaw& law);
};

inline const SrShape& noded(double radius) {
    static std::map<double, SrShape> shapes;
    const auto known = shapes.find(radius);
    if (known != shapes.end()) return known->second;
    return shapes.emplace(radius, make_sr_shape(spheroid_outline(radius, radius), true, 2000))
        .first->second;
}

inline const std::array<KindOfBall, 5> kinds_of_ball{
    {{"sphere",
      [](double r, const ContactLaw& law) { return by_sphere(Sphere{r}, PlaneWall{}, law); },
      [](double i, double j, const ContactLaw& law) {
          return by_sphere(Sphere{i}, Sphere{j}, law);
      }},
     {"sr, continuous",
      [](double r, const ContactLaw& law) {
          return by_support(round_body(r).shape, PlaneWall{}, law);
      },
      [](double i, double j, const ContactLaw& law) {
          return by_support(round_body(i).shape, round_body(j).shape, law);
      }},
     {"sr, nodes",
      [](double r, const ContactLaw& law) { return by_points(noded(r), PlaneWall{}, law); },
      [](double i, double j, const ContactLaw& law) { return by_points(noded(i), noded(j), law); }},
     {"clump",
      [](double r, const ContactLaw& law) {
          return by_points(ring_clump(0.0, r, 1), PlaneWall{}, law);
      },
      [](double i, double j, const ContactLaw& law) {
          return by_points(ring_clump(0.0, i, 1), ring_clump(0.0, j, 1), law);
      }},
     {"convex",
      [](double r, const ContactLaw& law) {
          return by_cores(make_convex_sphere(r).shape, PlaneWall{}, law);
      },
      [](double i, double j, const ContactLaw& law) {
          return by_cores(make_convex_sphere(i).shape, make_convex_sphere(j).shape, law);
      }}}};

inline InverseInertia ball(double density, double radius) {
    InverseInertia inverse = solid_sphere(density, radius);
    inverse.surface = square(radius) * inverse.moments.x();
    return inverse;
}

}  // namespace dem::test
