// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <memory>
#include <variant>

/// What a profile is made of: lines, ellipse arcs and smooth parametric curves in the half plane
/// (r, z). Lengths in meters.
namespace dem::shapegen {

/// Point and derivatives of a segment with respect to its parameter t in [0, 1].
struct CurveJet {
    Vec2 point, first, second;
};

struct LineSegment {
    Vec2 from, to;
};

/// Arc of an axis-aligned ellipse: center + (a cos(phi), b sin(phi)), phi from `start` to `end`
/// [rad] (either sense). A circular arc has a == b.
struct EllipseArc {
    Vec2 center;
    double a, b;
    double start, end;
};

/// A smooth curve given by a parametrization, t in [0, 1], with a first derivative that vanishes
/// nowhere (superquadric, Cassini oval, spline, ...).
class ParametricCurve {
  public:
    virtual ~ParametricCurve() = default;
    virtual CurveJet evaluate(double t) const = 0;
};
struct FreeCurve {
    std::shared_ptr<const ParametricCurve> curve;
};

using ProfileSegment = std::variant<LineSegment, EllipseArc, FreeCurve>;

CurveJet evaluate(const ProfileSegment& segment, double t);

/// Length of the part of a segment between two parameters, t0 <= t1: closed form on lines and
/// circular arcs, otherwise by quadrature to 1e-14 [m].
double arc_length(const ProfileSegment& segment, double t0 = 0.0, double t1 = 1.0);

/// The segment run through from its end to its start.
ProfileSegment reversed(const ProfileSegment& segment);

/// The segment moved by `offset` [m].
ProfileSegment translated(const ProfileSegment& segment, const Vec2& offset);

/// Signed curvature of a curve at a jet [1/m]: positive where it turns to the left.
double signed_curvature(const CurveJet& jet);

}  // namespace dem::shapegen
