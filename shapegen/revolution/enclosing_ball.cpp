// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/enclosing_ball.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <CGAL/Cartesian.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>

namespace dem::shapegen {

SurfaceNodes::Ball enclosing_ball(std::span<const Vec3> points) {
    using Kernel = CGAL::Cartesian<double>;
    using Traits = CGAL::Min_sphere_of_points_d_traits_3<Kernel, double, CGAL::Tag_true>;
    std::vector<Kernel::Point_3> input;
    for (const Vec3& p : points) input.emplace_back(p.x(), p.y(), p.z());
    CGAL::Min_sphere_of_spheres_d<Traits> sphere(input.begin(), input.end());
    const auto center = sphere.center_cartesian_begin();
    SurfaceNodes::Ball ball{center[0], center[1], center[2], 0.0};
    for (const Vec3& p : points) {
        ball.radius = std::max(ball.radius, (p - Vec3(ball.x, ball.y, ball.z)).norm());
    }
    return ball;
}

}  // namespace dem::shapegen
