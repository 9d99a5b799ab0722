// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/certificate/sr_certificate.hpp"

#include "shapegen/revolution/support.hpp"
#include "shapegen/revolution/surface_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem::shapegen {

namespace {

double frustums(const Profile& profile, int chords) {
    double volume = 0.0;
    for (const ProfileSegment& segment : profile.segments()) {
        const int n = std::holds_alternative<LineSegment>(segment) ? 1 : chords;
        Vec2 from = evaluate(segment, 0.0).point;
        for (int i = 1; i <= n; ++i) {
            const Vec2 to = evaluate(segment, static_cast<double>(i) / n).point;
            volume +=
                pi / 3.0 * (square(from[0]) + from[0] * to[0] + square(to[0])) * (to[1] - from[1]);
            from = to;
        }
    }
    return volume;
}

struct Spacing {
    double mean = 0.0, max = 0.0;
};

Spacing node_spacing(const SurfaceNodes& nodes) {
    Spacing spacing;
    for (std::uint32_t i = 0; i < nodes.count; ++i) {
        const auto& a = nodes.nodes[i];
        const auto& b =
            nodes.nodes[nodes.stencil[static_cast<std::size_t>(i) * SurfaceNodes::stencil_size]];
        const double d = Vec3(a.x - b.x, a.y - b.y, a.z - b.z).norm();
        spacing.mean += d / nodes.count;
        spacing.max = std::max(spacing.max, d);
    }
    return spacing;
}

}  // namespace

double polygon_volume(const Profile& profile, int n) {
    return (4.0 * frustums(profile, 2 * n) - frustums(profile, n)) / 3.0;
}

Certificate sr_certificate(const Profile& profile, const ParticleTemplate& shape, const SrShape& sr,
                           const CookingRecord& record) {
    const SdfError& sdf = record.sdf;
    const auto& rings = record.rings;
    const double l = sr.major_axis_length;
    const double degrees = 180.0 / pi;
    Certificate certificate{{"sdf_error_mean", sdf.mean / l},
                            {"sdf_error_rms", sdf.rms / l},
                            {"sdf_error_max", sdf.max / l},
                            {"sdf_gradient_angle_rms", sdf.angle_rms * degrees},
                            {"sdf_gradient_angle_max", sdf.angle_max * degrees}};
    if (sr.is_convex) {
        certificate.emplace_back("support_error_max", support_error(profile, sr.support) / l);
    }
    certificate.emplace_back("curvature_error_max", record.curvature_error);
    const Spacing spacing = node_spacing(sr.nodes);
    certificate.emplace_back("node_spacing_mean", spacing.mean / l);
    certificate.emplace_back("node_spacing_max", spacing.max / l);
    certificate.emplace_back(
        "node_surface_error_max",
        surface_deviation(profile, ring_points(rings), ring_triangles(rings)) / l);
    certificate.emplace_back("display_mesh_error_max", shape.display_mesh.max_deviation / l);
    const double volume = shape.mass_properties.volume;
    certificate.emplace_back("volume_error", std::abs(polygon_volume(profile) / volume - 1.0));
    return certificate;
}

}  // namespace dem::shapegen
