// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstddef>
#include <vector>

namespace dem::runtime {

/// A disc seen from above: on a square grid of vertical lines, the highest point that each meets.
/// Coordinates are right-handed with the disc's center in the origin and z upward [m].
class HeightMap {
  public:
    /// Lines `spacing` apart wherever they fall within `radius`; all of height 0.
    HeightMap(double radius, double spacing);

    void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c);
    void add_sphere(const Vec3& center, double radius);

    /// Below the heights of all lines, each standing for a square of the grid [m^3].
    double volume() const;
    /// Area of the squares of all lines; tends to that of the disc [m^2].
    double area() const;

  private:
    /// Calls use(x, y, index) for the lines in a rectangle that stand in the disc.
    template <class Use>
    void for_lines(double x_min, double x_max, double y_min, double y_max, const Use& use) const;

    double radius_;
    double spacing_;
    long half_;  // lines from -half_ to half_ in both directions
    std::vector<double> height_;
};

}  // namespace dem::runtime
