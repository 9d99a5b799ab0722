// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/cores/nearest_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::runtime {

namespace {

Vec3 projected(const PlacedCore& core, const Vec3& x) {
    const SurfaceDistance d = core_distance(core.shape, core.in_body(x));
    return x - d.distance * core.turned(d.normal);
}

/// The last steps: where they began, and by how much a projection there and back moved them.
struct Steps {
    std::array<Vec3, 2> image_change, residual_change;
    int count = 0;

    void add(const Vec3& image, const Vec3& residual) {
        image_change[1] = image_change[0];
        residual_change[1] = residual_change[0];
        image_change[0] = image;
        residual_change[0] = residual;
        count = std::min(count + 1, 2);
    }
    /// What a linear map that agrees with the last steps does not move.
    Vec3 fixed_point(const Vec3& image, const Vec3& residual) const {
        if (count == 0) return image;
        const Vec3& a = residual_change[0];
        const double aa = a.squaredNorm();
        if (!(aa > 0.0)) return image;
        if (count == 1) return image - (a.dot(residual) / aa) * image_change[0];
        const Vec3& b = residual_change[1];
        const double ab = a.dot(b);
        const double bb = b.squaredNorm();
        const double determinant = aa * bb - ab * ab;
        if (!(determinant > 1e-10 * aa * bb))
            return image - (a.dot(residual) / aa) * image_change[0];
        const double ra = a.dot(residual);
        const double rb = b.dot(residual);
        return image - ((bb * ra - ab * rb) / determinant) * image_change[0] -
               ((aa * rb - ab * ra) / determinant) * image_change[1];
    }
};

}  // namespace

void sharpen(const PlacedCore& i, const PlacedCore& j, CoreDistance& found) {
    const double enough = 1e-14 * (i.size + j.size);
    Vec3 y = found.point_j;
    Vec3 last_image = Vec3::Zero();
    Vec3 last_residual = Vec3::Zero();
    Steps steps;
    Vec3 x = found.point_i;
    Vec3 image = y;
    for (int k = 0; k < 16; ++k) {
        x = projected(i, y);
        image = projected(j, x);
        const Vec3 residual = image - y;
        if (residual.squaredNorm() <= enough * enough) break;
        if (k > 0) steps.add(image - last_image, residual - last_residual);
        last_image = image;
        last_residual = residual;
        y = steps.fixed_point(image, residual);
    }
    const Vec3 gap = x - image;
    const double distance = gap.norm();
    if (!(distance > 0.0 && distance <= found.distance + 1e-9 * (i.size + j.size))) return;
    found.distance = distance;
    found.normal = gap / distance;
    found.point_i = x;
    found.point_j = image;
}

void sharpen(const PlacedCore& i, const PlacedCore& j, Penetration& deepest) {
    const double gap = 0.01 * std::min(i.size, j.size);
    const auto overlap_along = [&](const Vec3& n) {
        return -n.dot(gjk::support(i, j, -n, 0, 0).w);
    };
    double overlap = overlap_along(deepest.normal);
    for (int k = 0; k < 32; ++k) {
        const Vec3 way = (gap + overlap) * deepest.normal;
        PlacedCore moved = i;
        moved.center += way;
        SearchStart start;
        start.direction = deepest.normal;
        CoreDistance left = core_distance(moved, j, start, 0.0);
        if (left.overlaps) return;
        sharpen(moved, j, left);
        const double next = overlap_along(left.normal);
        if (!(next < overlap)) return;
        overlap = next;
        deepest.depth = next;
        deepest.normal = left.normal;
        deepest.point_i = left.point_i - way;
        deepest.point_j = left.point_j;
    }
}

}  // namespace dem::runtime
