// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// The generating curve of a surface of revolution: an ordered path in the half plane (r, z), r >=
/// 0, from the lower end of the axis to the upper one. Lengths in metres.
namespace dem {

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

/// A smooth curve given by a parametrisation, t in [0, 1] (superquadric, Cassini oval, spline,
/// ...).
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
double arc_length(const ProfileSegment& segment);

/// Nearest point of a profile to a query point.
struct ProfilePoint {
    Vec2 point;
    std::size_t segment;
    double t;
    double distance;  ///< unsigned [m]
};

/// A closed generating curve: first and last points lie on the axis (r == 0), consecutive segments
/// join, it does not cross itself and encloses a volume. The constructor checks all of that and
/// throws Error naming the segment (by `labels`, e.g. "tablet.profile:12") and the point.
class Profile {
  public:
    /// `labels`: one text per segment for messages; end faces added by the caller carry their own.
    Profile(std::vector<ProfileSegment> segments, std::vector<std::string> labels);

    std::span<const ProfileSegment> segments() const { return segments_; }
    const std::string& label(std::size_t segment) const { return labels_[segment]; }

    double length() const;             ///< arc length [m]
    double max_radius() const;         ///< [m]
    double bottom_z() const;           ///< lower end on the axis [m]
    double top_z() const;              ///< upper end on the axis [m]
    double min_z() const;              ///< lowest point [m]; below bottom_z() for a dimpled shape
    double max_z() const;              ///< [m]
    double major_axis_length() const;  ///< l = max(height, 2 max_radius) [m]

    /// Exact nearest point (not of a polyline).
    ProfilePoint nearest(const Vec2& x) const;
    /// Exact signed distance, negative inside [m].
    double signed_distance(const Vec2& x) const;
    bool contains(const Vec2& x) const;

    /// Outward unit normal at a point of a segment.
    Vec2 outward_normal(std::size_t segment, double t) const;

    /// Joints (index = the segment that ends there) whose interior angle is below `max_angle`
    /// [rad]; the poles are included when the profile meets the axis at such an angle.
    struct Corner {
        std::size_t segment;  ///< ends at the corner; segments().size() for the bottom pole
        Vec2 point;
        double interior_angle;
    };
    std::vector<Corner> corners(double max_angle = 170.0 * pi / 180.0) const;

    /// Moves the whole profile along z.
    Profile translated(double dz) const;

  private:
    std::vector<ProfileSegment> segments_;
    std::vector<std::string> labels_;
};

}  // namespace dem
