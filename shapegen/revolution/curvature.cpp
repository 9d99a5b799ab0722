// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/curvature.hpp"

#include "common/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {
namespace {

constexpr double tolerance = 1e-3;
constexpr int deepest_level = 16;

struct Sample {
    double t;
    Vec2 point;
    double curvature;
};

/// Cuts segments into stretches on which H is nearly linear in the arc length.
class CurvatureSampler {
  public:
    CurvatureSampler(const Profile& profile, double equivalent_diameter)
        : profile_(profile),
          diameter_(equivalent_diameter),
          longest_step_(profile.length() / 200.0 * (1.0 + 1e-9)) {}

    void append_segment(std::size_t segment, double length) {
        segment_ = segment;
        start_ = arc_;
        const auto parts =
            std::max<int>(1, static_cast<int>(std::ceil(200.0 * length / profile_.length())));
        Sample from = sample(0.0);
        append(from.point, from.curvature);
        for (int i = 1; i <= parts; ++i) {
            const Sample to = sample(static_cast<double>(i) / parts);
            refine(from, to, 0);
            from = to;
        }
        // The sum of many parts drifts by rounding; the whole is known.
        arc_ = start_ + length;
        table_.samples.back().arc_length = arc_;
    }

    void append(const Vec2& point, double curvature) {
        table_.samples.push_back({point.x(), point.y(), arc_, curvature});
    }

    CurvatureTable take() { return std::move(table_); }

  private:
    Sample sample(double t) const {
        return {t, evaluate(profile_.segments()[segment_], t).point,
                stored_mean_curvature(mean_curvature(profile_, segment_, t), diameter_)};
    }

    void refine(const Sample& from, const Sample& to, int level) {
        const Sample middle = sample(0.5 * (from.t + to.t));
        const double whole = arc_length(profile_.segments()[segment_], from.t, to.t);
        const double error =
            std::max({error_at(from, to, 0.25, whole), error_at(from, to, 0.5, whole),
                      error_at(from, to, 0.75, whole)});
        if ((error > tolerance && level < deepest_level) || whole > longest_step_) {
            refine(from, middle, level + 1);
            refine(middle, to, level + 1);
            return;
        }
        table_.largest_error = std::max(table_.largest_error, error);
        arc_ += whole;
        append(to.point, to.curvature);
    }

    double error_at(const Sample& from, const Sample& to, double fraction, double whole) const {
        const Sample exact = sample(from.t + fraction * (to.t - from.t));
        const double share = arc_length(profile_.segments()[segment_], from.t, exact.t) / whole;
        const double linear = from.curvature + share * (to.curvature - from.curvature);
        return std::abs(linear - exact.curvature) /
               std::max(std::abs(exact.curvature), 0.2 / diameter_);
    }

    const Profile& profile_;
    double diameter_;
    double longest_step_;
    std::size_t segment_ = 0;
    double start_ = 0.0;
    double arc_ = 0.0;
    CurvatureTable table_;
};

/// Lines that meet at less than the angle of a corner stand for a smooth curve (a table of points).
struct FacetJoint {
    double turn = 0.0;       ///< of the path [rad]
    double curvature = 0.0;  ///< the turn spread over half of each line [1/m]
};

/// The joint before segment k; at a pole with the mirror image. Empty where no smooth curve is
/// meant.
FacetJoint facet_joint(const Profile& profile, std::size_t k) {
    const auto segments = profile.segments();
    const auto* before = std::get_if<LineSegment>(&segments[k == 0 ? 0 : k - 1]);
    const auto* after = std::get_if<LineSegment>(&segments[std::min(k, segments.size() - 1)]);
    if (before == nullptr || after == nullptr) return {};
    Vec2 in = before->to - before->from;
    Vec2 out = after->to - after->from;
    if (k == 0) in.y() = -in.y();
    if (k == segments.size()) out.y() = -out.y();
    const double turn = math::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    constexpr double corner = 10.0 * pi / 180.0;
    if (std::abs(turn) >= corner) return {};
    return {turn, turn / (0.5 * (in.norm() + out.norm()))};
}

/// kappa_1 and n_r of the smooth curve that a line stands for: the curvatures of its joints
/// interpolated, the normal its own in the middle and halfway to the neighbors' at the joints.
struct Facet {
    double meridional;
    double n_r;
};
Facet facet(const Profile& profile, std::size_t k, double t, const Vec2& along) {
    const FacetJoint lower = facet_joint(profile, k);
    const FacetJoint upper = facet_joint(profile, k + 1);
    const double tilt = t < 0.5 ? -(0.5 - t) * lower.turn : (t - 0.5) * upper.turn;
    const double angle = math::atan2(along.y(), along.x());  // n_r = sin of the tangent's angle
    return {(1.0 - t) * lower.curvature + t * upper.curvature, math::sin(angle + tilt)};
}

}  // namespace

double mean_curvature(const Profile& profile, std::size_t segment, double t) {
    const CurveJet jet = evaluate(profile.segments()[segment], t);
    Facet local{signed_curvature(jet), jet.first.y() / jet.first.norm()};
    if (std::holds_alternative<LineSegment>(profile.segments()[segment]))
        local = facet(profile, segment, t, jet.first);
    const double r = jet.point.x();
    // Below this radius n_r is lost to rounding on a smooth pole, while a cone's tip keeps it.
    if (r <= 1e-9 * profile.max_radius() && std::abs(local.n_r) < 1e-6) return local.meridional;
    return 0.5 * (local.meridional + local.n_r / std::max(r, 1e-300));
}

double stored_mean_curvature(double mean_curvature, double equivalent_diameter) {
    const double limit = 100.0 / equivalent_diameter;
    return std::clamp(mean_curvature, -limit, limit);
}

CurvatureTable curvature_table(const Profile& profile, double equivalent_diameter) {
    CurvatureSampler sampler(profile, equivalent_diameter);
    const double limit = stored_mean_curvature(1e300, equivalent_diameter);
    const auto corners = profile.corners();
    for (std::size_t i = 0; i < profile.segments().size(); ++i) {
        sampler.append_segment(i, arc_length(profile.segments()[i]));
        for (const Profile::Corner& corner : corners)
            if (corner.segment == i) sampler.append(corner.point, limit);
    }
    return sampler.take();
}

}  // namespace dem::shapegen
