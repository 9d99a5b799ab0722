// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/mass_balance.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include <glpk.h>

namespace dem {
namespace {

constexpr int rows = 10;  // mass, center x y z, moments x y z, products xy yz zx

/// What a ball of unit mass adds to each row, in units of the body's own size.
std::array<double, rows> column(const Ball& ball, double length) {
    const Vec3 c = ball.center / length;
    const Vec3 own = Vec3::Constant(0.4 * square(ball.radius / length));
    const Vec3 moments = Vec3::Constant(c.squaredNorm()) - c.cwiseAbs2() + own;
    return {1.0,         c.x(),       c.y(),         c.z(),         moments.x(),
            moments.y(), moments.z(), c.x() * c.y(), c.y() * c.z(), c.z() * c.x()};
}

/// The linear program: masses x_i in units of the body's, and x_0, the least ratio of a mass to
/// that of an even density.
class Program {
  public:
    Program(std::span<const Ball> balls, const MassProperties& body)
        : count_(static_cast<int>(balls.size())), problem_(glp_create_prob(), glp_delete_prob) {
        glp_term_out(GLP_OFF);
        const double length = std::cbrt(body.volume);
        moments_ = body.principal_moments_per_density / (body.volume * square(length));
        double total = 0.0;
        for (const Ball& ball : balls) total += cube(ball.radius);
        glp_set_obj_dir(problem_.get(), GLP_MAX);
        glp_add_rows(problem_.get(), rows + count_);
        glp_add_cols(problem_.get(), 1 + count_);
        glp_set_obj_coef(problem_.get(), 1, 1.0);
        glp_set_col_bnds(problem_.get(), 1, GLP_LO, 0.0, 0.0);
        std::array<int, rows + 2> index{};
        std::array<double, rows + 2> value{};
        for (int i = 0; i < count_; ++i) {
            const Ball& ball = balls[static_cast<std::size_t>(i)];
            const auto entries = column(ball, length);
            for (int r = 0; r < rows; ++r) {
                index[static_cast<std::size_t>(r) + 1] = r + 1;
                value[static_cast<std::size_t>(r) + 1] = entries[static_cast<std::size_t>(r)];
            }
            index[rows + 1] = rows + 1 + i;
            value[rows + 1] = total / cube(ball.radius);
            glp_set_mat_col(problem_.get(), 2 + i, rows + 1, index.data(), value.data());
            glp_set_col_bnds(problem_.get(), 2 + i, GLP_LO, 0.0, 0.0);
            glp_set_row_bnds(problem_.get(), rows + 1 + i, GLP_LO, 0.0, 0.0);
        }
        set_least_ratio_column();
    }

    /// The masses, or nothing when center and moments cannot be met within the tolerances.
    std::optional<std::vector<double>> solve(double center_tolerance, double product_tolerance,
                                             double tolerance) {
        set_row(1, 1.0, 0.0);
        for (int r = 0; r < 3; ++r) set_row(2 + r, 0.0, center_tolerance * diameter_);
        for (int r = 0; r < 3; ++r) set_row(5 + r, moments_[r], tolerance * moments_[r]);
        for (int r = 0; r < 3; ++r) set_row(8 + r, 0.0, product_tolerance * moments_.mean());
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        glp_scale_prob(problem_.get(), GLP_SF_AUTO);
        glp_adv_basis(problem_.get(), 0);
        if (glp_simplex(problem_.get(), &settings) != 0 ||
            glp_get_status(problem_.get()) != GLP_OPT)
            return std::nullopt;
        std::vector<double> masses;
        for (int i = 0; i < count_; ++i)
            masses.push_back(std::max(glp_get_col_prim(problem_.get(), 2 + i), 0.0));
        return masses;
    }

  private:
    void set_row(int row, double wanted, double slack) {
        glp_set_row_bnds(problem_.get(), row, slack > 0.0 ? GLP_DB : GLP_FX, wanted - slack,
                         wanted + slack);
    }

    /// m_i / (even density) - x_0 >= 0 for each ball.
    void set_least_ratio_column() {
        std::vector<int> index{0};
        std::vector<double> value{0.0};
        for (int i = 0; i < count_; ++i) {
            index.push_back(rows + 1 + i);
            value.push_back(-1.0);
        }
        glp_set_mat_col(problem_.get(), 1, count_, index.data(), value.data());
    }

    int count_;
    std::unique_ptr<glp_prob, void (*)(glp_prob*)> problem_;
    double diameter_ = std::cbrt(6.0 / pi);  // of the sphere of volume 1
    Vec3 moments_;
};

struct Solution {
    double tolerance;
    std::vector<double> masses;
};

/// The least tolerance, to one part in a thousand, for which solve(tolerance) has an answer.
template <class Solve>
std::optional<Solution> least_tolerance(const Solve& solve) {
    constexpr double most = 1e3;  // beyond any size or moment
    if (auto masses = solve(0.0)) return Solution{0.0, std::move(*masses)};
    double low = 0.0;
    std::optional<Solution> found;
    for (double high = 1e-6; !found; high *= 4.0) {
        if (high > most) return std::nullopt;
        if (auto masses = solve(high))
            found = Solution{high, std::move(*masses)};
        else
            low = high;
    }
    while (found->tolerance - low > 1e-3 * found->tolerance) {
        const double middle = 0.5 * (low + found->tolerance);
        if (auto masses = solve(middle))
            found = Solution{middle, std::move(*masses)};
        else
            low = middle;
    }
    return found;
}

}  // namespace

MassBalance balance_masses(std::span<const Ball> balls, const MassProperties& body) {
    constexpr double any = 1e3;
    Program program(balls, body);
    const auto least = [](const auto& solve) {
        const auto found = least_tolerance(solve);
        if (!found)
            throw Error("clump",
                        "found no masses for its spheres, expected them by linear programming");
        return *found;
    };
    // At the very limit rounding may leave no way at all.
    constexpr double room = 1.0 + 1e-6;
    MassBalance result;
    result.center_tolerance =
        room * least([&](double t) { return program.solve(t, any, any); }).tolerance;
    result.product_tolerance = room * least([&](double t) {
                                          return program.solve(result.center_tolerance, t, any);
                                      }).tolerance;
    const Solution solution = least([&](double t) {
        return program.solve(result.center_tolerance, result.product_tolerance, t);
    });
    result.tolerance = solution.tolerance;
    for (const double mass : solution.masses) result.shares.push_back(mass * body.volume);
    return result;
}

}  // namespace dem
