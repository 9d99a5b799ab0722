// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/smooth/sr_curvature.hpp"

#include "common/shapes/support_map.hpp"

#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

double distance(const CurvatureSample& s, double r, double z) {
    return std::sqrt(square(r - s.r) + square(z - s.z));
}

/// Index of the nearest sample. Where a sample is farther than the best by d, so are all within
/// the arc length d of it; a coarse pass finds a good best to begin with.
std::size_t nearest_sample(const SharedArray<CurvatureSample>& samples, double r, double z) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    const auto look_at = [&](std::size_t k) {
        const double d = distance(samples[k], r, z);
        if (d < least || (d == least && k < best)) {
            least = d;
            best = k;
        }
        return d;
    };
    constexpr std::size_t stride = 12;
    for (std::size_t k = 0; k < samples.size(); k += stride) look_at(k);
    for (std::size_t k = 0; k < samples.size();) {
        const double skip_to = samples[k].arc_length + look_at(k) - least;
        ++k;
        while (k < samples.size() && samples[k].arc_length < skip_to) ++k;
    }
    return best;
}

/// Linear in arc length between two samples, at the foot of (r, z) on the chord.
double interpolated(const CurvatureSample& a, const CurvatureSample& b, double r, double z,
                    double& least) {
    const double dr = b.r - a.r;
    const double dz = b.z - a.z;
    const double length2 = dr * dr + dz * dz;
    const double t =
        length2 > 0.0 ? std::clamp(((r - a.r) * dr + (z - a.z) * dz) / length2, 0.0, 1.0) : 0.0;
    least = std::sqrt(square(a.r + t * dr - r) + square(a.z + t * dz - z));
    return a.mean_curvature + t * (b.mean_curvature - a.mean_curvature);
}

double from_table(const SharedArray<CurvatureSample>& samples, double r, double z) {
    const std::size_t k = nearest_sample(samples, r, z);
    double before = std::numeric_limits<double>::infinity();
    double after = before;
    double h_before = samples[k].mean_curvature;
    double h_after = h_before;
    if (k > 0) h_before = interpolated(samples[k - 1], samples[k], r, z, before);
    if (k + 1 < samples.size()) h_after = interpolated(samples[k], samples[k + 1], r, z, after);
    return after < before ? h_after : h_before;
}

}  // namespace

double mean_curvature_near(const SrShape& shape, double r, double z, double n_r, double n_z) {
    if (shape.support.pieces.empty()) return from_table(shape.curvature, r, z);
    const double length = std::sqrt(n_r * n_r + n_z * n_z);
    const SupportPoint s = support_point(shape.support, n_r / length, n_z / length);
    constexpr double corner = std::numeric_limits<double>::infinity();
    const double kappa_1 = s.meridional_radius > 0.0 ? 1.0 / s.meridional_radius : corner;
    const double kappa_2 = s.circumferential_radius > 0.0 ? 1.0 / s.circumferential_radius : corner;
    return 0.5 * (kappa_1 + kappa_2);
}

}  // namespace dem::runtime
