// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/convex_shape.hpp"
#include "common/shapes/mass_properties.hpp"
#include "shapegen/solids/convex_polyhedron.hpp"

#include <span>

/// Convex shapes from their dimensions, rounded inwards: a body of the given outer dimensions whose
/// edges and corners are replaced by those of a sphere of radius `rounding` that rolls inside of
/// it. Every function throws Error for dimensions that are not positive and finite and for a
/// rounding that is negative or leaves no core.
namespace dem::shapegen {

/// A shape with what a template says about every solid. Mass properties are those of the rounded
/// body: in closed form, for an ellipsoid with a rounding by quadrature to 1e-9.
struct ConvexSolid {
    ConvexShape shape;
    MassProperties mass_properties;
    double mean_squared_surface_distance = 0.0;  ///< area-weighted, from the center of mass [m^2]
    double surface_area = 0.0;                   ///< [m^2]
    /// Share of the volume of the sharp body that the rounding took.
    double rounding_loss = 0.0;
    /// How far the farthest corner of the sharp body lies outside of the rounded one [m].
    double corner_retreat = 0.0;
    /// How far facets are from the curved surface that they stand for [m].
    double facet_error = 0.0;
};

/// How far the farthest of the points, in the frame of the solid's input, lies outside of it [m].
double farthest_outside(const ConvexSolid& solid, std::span<const Vec3> points);

/// The hull of points, its center of mass and principal axes found. Points inside are left out.
ConvexSolid make_convex_polyhedron(std::span<const Vec3> points, double rounding,
                                   const HullOfPoints& hull);

/// The rest have their center at the origin of the input's frame, a cone that of its base.
ConvexSolid make_cuboid(const Vec3& edge_lengths, double rounding);
ConvexSolid make_cylinder(double radius, double height, double rounding);  ///< about z
ConvexSolid make_cone(double radius, double height, double rounding);      ///< tip at +z
ConvexSolid make_ellipsoid(const Vec3& semi_axes);
/// A sphere swept along a piece of the z axis; `length` between the outermost points.
ConvexSolid make_capsule(double radius, double length);
/// A sphere swept over a disc normal to z; `radius` of the disc with its rounded edge.
ConvexSolid make_rounded_disc(double radius, double thickness);
ConvexSolid make_convex_sphere(double radius);

/// A body that is the solid, as its core, and all within `rounding` of it; in the solid's frame,
/// its size and mass properties left to with_mass_properties().
ConvexShape rounded_around(const ConvexPolyhedron& core, double rounding);

/// Mass properties of any convex shape, about any origin: its own frame is the frame of the input.
ConvexSolid with_mass_properties(ConvexShape shape);

}  // namespace dem::shapegen
