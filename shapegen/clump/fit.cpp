// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/fit.hpp"

#include "common/threads/thread_team.hpp"
#include "shapegen/clump/sample_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace dem::shapegen {
namespace {

using Vec4 = Eigen::Matrix<double, 4, 1>;
using Mat4 = Eigen::Matrix<double, 4, 4>;

/// The ball that each sample is nearest to.
class Assignment {
  public:
    explicit Assignment(std::span<const SurfaceSample> samples) : blocks_(samples) {}

    /// After the balls have moved.
    void update(std::span<const Ball> balls);

    /// Numbers of the samples of a ball.
    std::span<const std::uint32_t> samples_of(std::size_t ball) const {
        return std::span(order_).subspan(begin_[ball], begin_[ball + 1] - begin_[ball]);
    }
    double sum_of_squares() const { return sum_of_squares_; }  ///< of the distances [m^2]

  private:
    SampleBlocks blocks_;
    std::vector<std::uint32_t> order_;  ///< by the ball
    std::vector<std::uint32_t> begin_;  ///< of each ball's; one more at the end
    double sum_of_squares_ = 0.0;
};

void Assignment::update(std::span<const Ball> balls) {
    const std::vector<BallTree::Answer> answers = blocks_.nearest(BallTree(balls), balls);
    begin_.assign(balls.size() + 1, 0);
    sum_of_squares_ = 0.0;
    for (const auto& answer : answers) {
        ++begin_[answer.ball + 1];
        sum_of_squares_ += square(answer.distance);
    }
    for (std::size_t b = 0; b < balls.size(); ++b) begin_[b + 1] += begin_[b];
    order_.resize(answers.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < answers.size(); ++i) order_[next[answers[i].ball]++] = i;
}

/// The surface points that a ball is to follow.
class Patch {
  public:
    Patch(std::span<const SurfaceSample> samples, std::span<const std::uint32_t> own)
        : samples_(samples), own_(own) {}

    double sum_of_squares(const Ball& ball) const {
        double sum = 0.0;
        for (const std::uint32_t i : own_)
            sum += square((samples_[i].point - ball.center).norm() - ball.radius);
        return sum;
    }

    /// One damped Gauss-Newton step for least squares of |x - c| - r. A patch that is nearly flat
    /// says little about c along its normal and r at once; the damping keeps both where they are.
    Vec4 free_step(const Ball& ball) const {
        Mat4 normal = Mat4::Zero();
        Vec4 right = Vec4::Zero();
        add_up(ball, [&](const Vec3& way, double residual) {
            Vec4 row;
            row << way, 1.0;  // minus the derivative of the residual by (c, r)
            normal.noalias() += row * row.transpose();
            right += residual * row;
        });
        normal.diagonal().array() += damping * static_cast<double>(own_.size());
        return normal.ldlt().solve(right);
    }

    /// The step of c alone for a ball as large as its place allows: r grows with the distance from
    /// the surface, that is by `inward` . dc.
    Vec3 sliding_step(const Ball& ball, const Vec3& inward) const {
        Mat3 normal = Mat3::Zero();
        Vec3 right = Vec3::Zero();
        add_up(ball, [&](const Vec3& way, double residual) {
            const Vec3 row = way + inward;
            normal.noalias() += row * row.transpose();
            right += residual * row;
        });
        normal.diagonal().array() += damping * static_cast<double>(own_.size());
        return normal.ldlt().solve(right);
    }

  private:
    static constexpr double damping = 1e-3;

    /// Calls add(unit vector from the center to a point, its residual) for every point.
    template <class Add>
    void add_up(const Ball& ball, const Add& add) const {
        for (const std::uint32_t i : own_) {
            const Vec3 way = samples_[i].point - ball.center;
            const double length = way.norm();
            if (length > 0.0) add(way / length, length - ball.radius);
        }
    }

    std::span<const SurfaceSample> samples_;
    std::span<const std::uint32_t> own_;
};

/// A ball with its center inside, and the point of the surface nearest to that.
struct PlacedBall {
    Ball ball;
    SurfacePoint near;
};

/// A step may be too long, above all where a ball is as large as it may be: it is halved until the
/// ball follows its points better.
class Improvement {
  public:
    Improvement(const SurfaceQuery& surface, const Patch& patch, const FitOptions& options,
                const PlacedBall& start)
        : surface_(surface),
          patch_(patch),
          options_(options),
          start_(start),
          best_(start),
          least_(patch.sum_of_squares(start.ball)) {}

    PlacedBall operator()() {
        const auto& [ball, near] = start_;
        const Vec4 step = patch_.free_step(ball);
        try_along(step.head<3>(), step[3]);
        const bool is_full = ball.radius > 0.999 * (near.distance + options_.protrusion);
        if (is_full && near.distance > 0.0) {
            const Vec3 inward = (ball.center - near.point) / near.distance;
            const Vec3 slide = patch_.sliding_step(ball, inward);
            try_along(slide, slide.norm());  // the place caps the radius
        }
        return best_;
    }

  private:
    void try_along(const Vec3& step, double growth) {
        constexpr int halvings = 4;
        double part = 1.0;
        for (int n = 0; n <= halvings; ++n, part *= 0.5) {
            const Vec3 center = start_.ball.center + part * step;
            const double moved = part * step.norm();
            const double depth_before = start_.near.distance;
            if (moved >= depth_before && !surface_.is_inside(center)) continue;
            constexpr double room = 1.0 + 1e-9;  // for rounding
            const SurfacePoint near = surface_.nearest(center, room * (depth_before + moved));
            const double radius =
                std::min(start_.ball.radius + part * growth, near.distance + options_.protrusion);
            if (!(near.distance > 0.0) || radius < options_.min_radius) continue;
            const Ball ball{center, radius};
            const double sum = patch_.sum_of_squares(ball);
            if (sum >= least_) continue;
            least_ = sum;
            best_ = {ball, near};
            return;
        }
    }

    const SurfaceQuery& surface_;
    const Patch& patch_;
    const FitOptions& options_;
    PlacedBall start_, best_;
    double least_;
};

}  // namespace

void fit(const SurfaceQuery& surface, std::span<const SurfaceSample> samples,
         const FitOptions& options, std::vector<Ball>& balls) {
    std::vector<PlacedBall> placed(balls.size());
    share_each(balls.size(), 2, [&](std::size_t b) {
        placed[b] = {balls[b], surface.nearest(balls[b].center)};
    });
    Assignment assignment(samples);
    std::vector<Ball> best = balls;
    double least = std::numeric_limits<double>::infinity();
    constexpr int patience = 5;  // steps without
    constexpr double enough = 0.99;
    double least_at_progress = least;
    int progress_at = 0;
    for (int step = 0; step <= options.steps; ++step) {
        assignment.update(balls);
        if (assignment.sum_of_squares() < enough * least_at_progress) {
            least_at_progress = assignment.sum_of_squares();
            progress_at = step;
        }
        if (assignment.sum_of_squares() < least) {
            least = assignment.sum_of_squares();
            best = balls;
        }
        if (step == options.steps || step - progress_at == patience) break;
        share_each(balls.size(), 1, [&](std::size_t b) {
            const auto own = assignment.samples_of(b);
            if (own.empty()) return;
            placed[b] = Improvement(surface, Patch(samples, own), options, placed[b])();
            balls[b] = placed[b].ball;
        });
    }
    balls = best;
}

}  // namespace dem::shapegen
