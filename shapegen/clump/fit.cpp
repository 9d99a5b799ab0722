// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/fit.hpp"

#include "shapegen/clump/nearest_ball.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

namespace dem {
namespace {

using Vec4 = Eigen::Matrix<double, 4, 1>;
using Mat4 = Eigen::Matrix<double, 4, 4>;

/// Numbers of the samples, ordered by the ball they are assigned to.
struct Assignment {
    std::vector<std::uint32_t> samples;
    std::vector<std::uint32_t> begin;  ///< of each ball's; one more at the end
    double sum_of_squares = 0.0;       ///< of the distances [m^2]
};

Assignment assign(std::span<const SurfaceSample> samples, std::span<const Ball> balls) {
    const NearestBall nearest(balls);
    std::vector<NearestBall::Answer> answers(samples.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < samples.size(); ++i) answers[i] = nearest(samples[i].point);
    Assignment result;
    result.begin.assign(balls.size() + 1, 0);
    for (const auto& answer : answers) {
        ++result.begin[answer.ball + 1];
        result.sum_of_squares += square(answer.distance);
    }
    for (std::size_t b = 0; b < balls.size(); ++b) result.begin[b + 1] += result.begin[b];
    result.samples.resize(samples.size());
    std::vector<std::uint32_t> next(result.begin.begin(), result.begin.end() - 1);
    for (std::uint32_t i = 0; i < samples.size(); ++i) result.samples[next[answers[i].ball]++] = i;
    return result;
}

/// One damped Gauss-Newton step for least squares of |x - c| - r. A patch that is nearly flat says
/// little about c along its normal and r at once; the damping keeps both where they are.
Ball improved(const Ball& ball, std::span<const SurfaceSample> samples,
              std::span<const std::uint32_t> own) {
    constexpr double damping = 1e-3;
    Mat4 normal = Mat4::Zero();
    Vec4 right = Vec4::Zero();
    for (const std::uint32_t i : own) {
        const Vec3 way = samples[i].point - ball.center;
        const double length = way.norm();
        if (length == 0.0) continue;
        Vec4 row;
        row << way / length, 1.0;  // minus the derivative of the residual by (c, r)
        normal.noalias() += row * row.transpose();
        right += (length - ball.radius) * row;
    }
    normal.diagonal().array() += damping * static_cast<double>(own.size());
    const Vec4 step = normal.ldlt().solve(right);
    return {ball.center + step.head<3>(), ball.radius + step[3]};
}

}  // namespace

void fit(const SurfaceQuery& surface, std::span<const SurfaceSample> samples,
         const FitOptions& options, std::vector<Ball>& balls) {
    std::vector<Ball> best = balls;
    double least = std::numeric_limits<double>::infinity();
    for (int step = 0; step <= options.steps; ++step) {
        const Assignment assignment = assign(samples, balls);
        if (assignment.sum_of_squares < least) {
            least = assignment.sum_of_squares;
            best = balls;
        }
        if (step == options.steps) break;
#pragma omp parallel for schedule(dynamic, 16)
        for (std::size_t b = 0; b < balls.size(); ++b) {
            const auto own =
                std::span(assignment.samples)
                    .subspan(assignment.begin[b], assignment.begin[b + 1] - assignment.begin[b]);
            if (own.empty()) continue;
            Ball next = improved(balls[b], samples, own);
            const double depth = -surface.signed_distance(next.center);
            next.radius = std::min(next.radius, depth + options.protrusion);
            if (depth > 0.0 && next.radius >= options.min_radius) balls[b] = next;
        }
    }
    balls = best;
}

}  // namespace dem
