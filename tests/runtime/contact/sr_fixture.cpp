// SPDX-License-Identifier: BSD-3-Clause
#include "tests/runtime/contact/sr_fixture.hpp"

#include "common/random.hpp"
#include "common/shapes/sdf_quadtree.hpp"
#include "common/shapes/support_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem::test {

namespace {

/// A polyline with exact distances to it.
class Outline {
  public:
    explicit Outline(const std::vector<Vec2>& points) : points_(points), arc_(points.size(), 0.0) {
        for (std::size_t k = 1; k < points.size(); ++k) {
            arc_[k] = arc_[k - 1] + (points[k] - points[k - 1]).norm();
            longest_ = std::max(longest_, arc_[k] - arc_[k - 1]);
        }
    }

    std::size_t size() const { return points_.size(); }
    const Vec2& point(std::size_t k) const { return points_[k]; }
    double arc_length(std::size_t k) const { return arc_[k]; }

    Vec2 normal(std::size_t k) const {
        const Vec2 t = points_[std::min(k + 1, size() - 1)] - points_[k == 0 ? 0 : k - 1];
        return k == 0 ? Vec2(0, -1) : k + 1 == size() ? Vec2(0, 1) : Vec2(t.y(), -t.x()) / t.norm();
    }

    /// Angle between the segments that meet at a point; 0 on a line.
    double turn(std::size_t k) const {
        if (k == 0 || k + 1 == size()) return 0.0;
        const Vec2 u = points_[k] - points_[k - 1];
        const Vec2 v = points_[k + 1] - points_[k];
        return std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    }

    /// Mean curvature from the turn of the polyline and the normal's angle with the axis.
    double mean_curvature(std::size_t k) const {
        const std::size_t m = std::clamp<std::size_t>(k, 1, size() - 2);
        const double kappa_1 = 2.0 * turn(m) / (arc_[m + 1] - arc_[m - 1]);
        const double kappa_2 =
            points_[m].x() > 1e-3 * arc_.back() ? normal(m).x() / points_[m].x() : kappa_1;
        return 0.5 * (kappa_1 + kappa_2);
    }

    /// Skips the points that cannot be nearest, because a distance changes no faster than the arc.
    double signed_distance(const Vec2& x) const {
        std::size_t best = 0;
        double least = (points_[0] - x).norm();
        for (std::size_t k = 0; k < size();) {
            const double distance = (points_[k] - x).norm();
            if (distance < least) {
                least = distance;
                best = k;
            }
            const double reach = arc_[k] + std::max(distance - least - longest_, 0.0);
            const auto next =
                std::upper_bound(arc_.begin() + static_cast<std::ptrdiff_t>(k), arc_.end(), reach);
            k = std::max<std::size_t>(k + 1, static_cast<std::size_t>(next - arc_.begin()));
        }
        double distance = std::numeric_limits<double>::infinity();
        for (std::size_t k = best == 0 ? 0 : best - 1; k < std::min(best + 1, size() - 1); ++k) {
            const Vec2 u = points_[k + 1] - points_[k];
            const Vec2 d = x - points_[k];
            const double t = std::clamp(d.dot(u) / u.squaredNorm(), 0.0, 1.0);
            const double gap = (d - t * u).norm();
            const bool outside = d.x() * u.y() - d.y() * u.x() > 0.0;
            if (gap < std::abs(distance)) distance = outside ? gap : -gap;
        }
        return distance;
    }

  private:
    std::vector<Vec2> points_;
    std::vector<double> arc_;
    double longest_ = 0.0;
};

/// Builds the two-level field; hanging values follow the coarser side.
class SdfBuilder {
  public:
    SdfBuilder(const Outline& outline, SdfQuadtree& sdf) : outline_(outline), sdf_(sdf) {}

    void build(double length, double max_radius, double min_z, double max_z) {
        sdf_.base_size = length / 50.0;
        sdf_.origin_r = -0.125 * sdf_.base_size;
        constexpr std::uint32_t cells = 6;  // of margin
        sdf_.margin = cells * sdf_.base_size;
        sdf_.origin_z = min_z - sdf_.margin;
        sdf_.cells_r = static_cast<std::uint32_t>(max_radius / sdf_.base_size + cells + 2);
        sdf_.cells_z = static_cast<std::uint32_t>((max_z - min_z) / sdf_.base_size + 2 * cells + 1);
        choose_levels();
        fill();
        sdf_.cells = cells_;
        sdf_.values = values_;
        measure_errors();
    }

  private:
    void choose_levels() {
        std::vector<Vec2> corners;
        for (std::size_t k = 1; k + 1 < outline_.size(); ++k)
            if (outline_.turn(k) > 10.0 / 180.0 * pi) corners.push_back(outline_.point(k));
        const double h = sdf_.base_size;
        for (std::uint32_t k = 0; k < sdf_.cells_z; ++k)
            for (std::uint32_t i = 0; i < sdf_.cells_r; ++i) {
                const Vec2 center(sdf_.origin_r + (i + 0.5) * h, sdf_.origin_z + (k + 0.5) * h);
                const bool corner = std::any_of(corners.begin(), corners.end(), [&](const Vec2& c) {
                    return (c - center).cwiseAbs().maxCoeff() < 1.01 * h;
                });
                const bool interface = std::abs(outline_.signed_distance(center)) < 2.0 * h;
                cells_.push_back({0, corner ? 4U : interface ? 2U : 0U});
            }
    }

    std::uint32_t level(std::int64_t i, std::int64_t k, std::uint32_t otherwise) const {
        if (i < 0 || k < 0 || i >= sdf_.cells_r || k >= sdf_.cells_z) return otherwise;
        return cells_[static_cast<std::size_t>(k) * sdf_.cells_r + static_cast<std::size_t>(i)]
            .level;
    }

    double exact(double u, double v) const {
        return outline_.signed_distance(
            {std::abs(sdf_.origin_r + u * sdf_.base_size), sdf_.origin_z + v * sdf_.base_size});
    }

    /// At (u, v) in base cells, on an edge along r or z: linear between the grid points of the
    /// coarser of the two cells that share it.
    double on_edge(double u, double v, bool along_r, std::uint32_t coarser) const {
        const double n = static_cast<double>(1U << coarser);
        const double t = (along_r ? u : v) * n;
        const double low = std::floor(t);
        const double f = t - low;
        const auto at = [&](double w) { return along_r ? exact(w / n, v) : exact(u, w / n); };
        return f == 0.0 ? at(low) : (1.0 - f) * at(low) + f * at(low + 1.0);
    }

    void fill() {
        for (std::uint32_t k = 0; k < sdf_.cells_z; ++k)
            for (std::uint32_t i = 0; i < sdf_.cells_r; ++i) {
                SdfCell& cell = cells_[k * sdf_.cells_r + i];
                cell.first_value = static_cast<std::uint32_t>(values_.size());
                const std::uint32_t n = 1U << cell.level;
                for (std::uint32_t b = 0; b <= n; ++b)
                    for (std::uint32_t a = 0; a <= n; ++a) values_.push_back(value(i, k, a, b));
            }
    }

    double value(std::uint32_t i, std::uint32_t k, std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t own = cells_[k * sdf_.cells_r + i].level;
        const std::uint32_t n = 1U << own;
        const double u = i + a / static_cast<double>(n);
        const double v = k + b / static_cast<double>(n);
        const std::int64_t ii = i;
        const std::int64_t kk = k;
        if (a != 0 && a != n && (b == 0 || b == n))
            return on_edge(u, v, true, std::min(own, level(ii, b == 0 ? kk - 1 : kk + 1, own)));
        if (b != 0 && b != n && (a == 0 || a == n))
            return on_edge(u, v, false, std::min(own, level(a == 0 ? ii - 1 : ii + 1, kk, own)));
        return exact(u, v);
    }

    void measure_errors() {
        sdf_.surface_band = 0.25 * sdf_.base_size;
        for (double v = 0.21; v < sdf_.cells_z; v += 0.31)
            for (double u = 0.17; u < sdf_.cells_r; u += 0.31) {
                const double r = std::abs(sdf_.origin_r + u * sdf_.base_size);
                const double z = sdf_.origin_z + v * sdf_.base_size;
                const double distance = interpolate(sdf_, r, z).distance;
                const double error = 2.0 * std::abs(distance - exact(u, v));
                if (distance > 0.0) sdf_.lipschitz_slack = std::max(sdf_.lipschitz_slack, error);
                if (std::abs(distance) <= sdf_.surface_band)
                    sdf_.surface_slack = std::max(sdf_.surface_slack, error);
            }
    }

    const Outline& outline_;
    SdfQuadtree& sdf_;
    std::vector<SdfCell> cells_;
    std::vector<double> values_;
};

/// Rings about `spacing` apart, turned against each other by the golden angle.
std::vector<SurfaceNodes::Node> ring_nodes(const Outline& outline, double spacing) {
    std::vector<SurfaceNodes::Node> nodes;
    const double length = outline.arc_length(outline.size() - 1);
    const auto rings = static_cast<std::size_t>(std::lround(length / spacing));
    std::size_t k = 0;
    for (std::size_t ring = 0; ring <= rings; ++ring) {
        const double arc = length * static_cast<double>(ring) / static_cast<double>(rings);
        while (k + 1 < outline.size() && outline.arc_length(k) < arc) ++k;
        const Vec2 p = outline.point(k);
        const auto count = std::max<std::size_t>(
            1, static_cast<std::size_t>(std::lround(2.0 * pi * p.x() / spacing)));
        const double radius = count == 1 ? 0.0 : p.x();
        for (std::size_t m = 0; m < count; ++m) {
            const double angle = 2.0 * pi * static_cast<double>(m) / static_cast<double>(count) +
                                 2.39996322972865332 * static_cast<double>(ring);
            nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), p.y(),
                             outline.mean_curvature(k)});
        }
    }
    return nodes;
}

/// Halves along the longest side of the box, at multiples of 256 and then of 16 nodes: super blocks
/// and blocks of near nodes.
void sort_in_blocks(std::vector<SurfaceNodes::Node>& nodes, std::size_t first, std::size_t last) {
    const std::size_t unit = last - first > 256 ? 256 : 16;
    const std::size_t parts = (last - first + unit - 1) / unit;
    if (parts < 2) return;
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = -low;
    for (std::size_t k = first; k < last; ++k) {
        const Vec3 x(nodes[k].x, nodes[k].y, nodes[k].z);
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    Vec3::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const auto key = [axis](const SurfaceNodes::Node& n) {
        return axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    };
    const std::size_t middle = first + unit * (parts / 2);
    const auto at = [&](std::size_t k) { return nodes.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](const auto& a, const auto& b) { return key(a) < key(b); });
    sort_in_blocks(nodes, first, middle);
    sort_in_blocks(nodes, middle, last);
}

SurfaceNodes::Ball ball_about(const std::vector<SurfaceNodes::Node>& nodes, std::size_t first,
                              std::size_t last) {
    Vec3 center = Vec3::Zero();
    for (std::size_t k = first; k < last; ++k)
        center += Vec3(nodes[k].x, nodes[k].y, nodes[k].z) / static_cast<double>(last - first);
    double radius = 0.0;
    for (std::size_t k = first; k < last; ++k)
        radius = std::max(radius, (Vec3(nodes[k].x, nodes[k].y, nodes[k].z) - center).norm());
    return {center.x(), center.y(), center.z(), radius * (1.0 + 1e-12)};
}

SurfaceNodes in_blocks(std::vector<SurfaceNodes::Node> nodes) {
    SurfaceNodes out;
    out.count = static_cast<std::uint32_t>(nodes.size());
    sort_in_blocks(nodes, 0, nodes.size());
    while (nodes.size() % SurfaceNodes::block_size != 0) nodes.push_back(nodes.back());
    std::vector<SurfaceNodes::Ball> blocks;
    std::vector<SurfaceNodes::Ball> super_blocks;
    for (std::size_t k = 0; k < nodes.size(); k += 16)
        blocks.push_back(ball_about(nodes, k, k + 16));
    for (std::size_t k = 0; k < nodes.size(); k += 256)
        super_blocks.push_back(ball_about(nodes, k, std::min<std::size_t>(k + 256, nodes.size())));
    out.nodes = std::move(nodes);
    out.blocks = std::move(blocks);
    out.super_blocks = std::move(super_blocks);
    return out;
}

}  // namespace

std::vector<Vec2> spheroid_outline(double equatorial, double polar, int samples) {
    std::vector<Vec2> points;
    for (int k = 0; k <= samples; ++k) {
        const double t = pi * (static_cast<double>(k) / samples - 0.5);
        points.emplace_back(k == 0 || k == samples ? 0.0 : equatorial * std::cos(t),
                            polar * std::sin(t));
    }
    return points;
}

std::vector<Vec2> peanut_outline(double f, double b, int samples) {
    std::vector<Vec2> points;
    for (int k = 0; k <= samples; ++k) {
        const double t = pi * (1.0 - static_cast<double>(k) / samples);  // from the axis +z
        const double c = std::cos(2.0 * t);
        const double s = f * std::sqrt(c + std::sqrt(c * c - 1.0 + std::pow(b / f, 4.0)));
        points.emplace_back(k == 0 || k == samples ? 0.0 : s * std::sin(t), s * std::cos(t));
    }
    return points;
}

std::vector<Vec2> red_blood_cell_outline(double f, double b, int samples) {
    std::vector<Vec2> points;
    for (int k = 0; k <= samples; ++k) {
        const double t = pi * (static_cast<double>(k) / samples - 0.5);  // from the equator
        const double c = std::cos(2.0 * t);
        const double s = f * std::sqrt(c + std::sqrt(c * c - 1.0 + std::pow(b / f, 4.0)));
        points.emplace_back(k == 0 || k == samples ? 0.0 : s * std::cos(t), s * std::sin(t));
    }
    return points;
}

std::vector<Vec2> tablet_outline(double band_radius, double band_height, double cap_height,
                                 int samples) {
    const double cap =
        (square(band_radius) + square(cap_height)) / (2.0 * cap_height);  // radius of a cap
    const double half = std::asin(band_radius / cap);
    const double top = 0.5 * band_height + cap_height;
    const int arc = samples / 3;
    std::vector<Vec2> points;
    for (int k = 0; k <= arc; ++k) {
        const double t = half * k / arc;
        points.emplace_back(cap * std::sin(t), -(top - cap + cap * std::cos(t)));
    }
    for (int k = 1; k < arc; ++k)
        points.emplace_back(band_radius, band_height * (static_cast<double>(k) / arc - 0.5));
    for (int k = arc; k >= 0; --k) {
        const double t = half * k / arc;
        points.emplace_back(cap * std::sin(t), top - cap + cap * std::cos(t));
    }
    return points;
}

SrShape make_sr_shape(const std::vector<Vec2>& points, bool is_convex, std::uint32_t nodes) {
    const Outline outline(points);
    SrShape shape;
    shape.is_convex = is_convex;
    shape.bottom_z = points.front().y();
    shape.top_z = points.back().y();
    double min_z = shape.bottom_z;
    double max_z = shape.top_z;
    double area = 0.0;
    double volume = 0.0;
    std::vector<CurvatureSample> curvature;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2& p = points[k];
        shape.max_radius = std::max(shape.max_radius, p.x());
        shape.bounding_radius = std::max(shape.bounding_radius, p.norm());
        min_z = std::min(min_z, p.y());
        max_z = std::max(max_z, p.y());
        if (k > 0) {
            const Vec2& o = points[k - 1];
            area += pi * (p.x() + o.x()) * (p - o).norm();
            volume += pi / 3.0 * (p.x() * p.x() + p.x() * o.x() + o.x() * o.x()) * (p.y() - o.y());
        }
        if (k % 8 == 0)
            curvature.push_back({p.x(), p.y(), outline.arc_length(k), outline.mean_curvature(k)});
    }
    shape.equivalent_diameter = std::cbrt(6.0 * volume / pi);
    shape.major_axis_length = std::max(max_z - min_z, 2.0 * shape.max_radius);
    shape.curvature = std::move(curvature);
    SdfBuilder(outline, shape.sdf).build(shape.major_axis_length, shape.max_radius, min_z, max_z);
    shape.nodes = in_blocks(ring_nodes(outline, std::sqrt(area / nodes)));
    return shape;
}

SrShape candy(std::uint32_t nodes) {
    SrShape shape = make_sr_shape(spheroid_outline(6.585e-3, 3.395e-3), true, nodes);
    shape.support.pieces = std::vector<SupportPiece>{{0.0, 0.0, 6.585e-3, 3.395e-3}};
    shape.support.piece_end = std::vector<double>{1.0};
    shape.support.first_piece = std::vector<std::uint32_t>{0, 0};
    shape.support.bounds = support_bounds(shape.support);
    return shape;
}
SrShape sharp_tablet(std::uint32_t nodes) {
    return make_sr_shape(tablet_outline(5.675e-3, 4.0e-3, 1.23e-3), true, nodes);
}
SrShape peanut(std::uint32_t nodes) {
    return make_sr_shape(peanut_outline(4.5e-3, 4.8e-3), false, nodes);
}
SrShape red_blood_cell(std::uint32_t nodes) {
    return make_sr_shape(red_blood_cell_outline(4.5e-3, 4.8e-3), false, nodes);
}

}  // namespace dem::test
