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

    /// The masses, or nothing when the moments cannot be met within the tolerance.
    std::optional<std::vector<double>> solve(double tolerance) {
        const std::array<double, 4> exact{1.0, 0.0, 0.0, 0.0};
        for (int r = 0; r < 4; ++r)
            glp_set_row_bnds(problem_.get(), r + 1, GLP_FX, exact[static_cast<std::size_t>(r)],
                             0.0);
        for (int r = 0; r < 6; ++r) {
            const double wanted = r < 3 ? moments_[r] : 0.0;
            const double slack = tolerance * (r < 3 ? wanted : moments_.mean());
            glp_set_row_bnds(problem_.get(), r + 5, slack > 0.0 ? GLP_DB : GLP_FX, wanted - slack,
                             wanted + slack);
        }
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
    Vec3 moments_;
};

}  // namespace

MassBalance balance_masses(std::span<const Ball> balls, const MassProperties& body) {
    Program program(balls, body);
    MassBalance result;
    auto masses = program.solve(0.0);
    double low = 0.0;
    double high = 1e-4;
    for (; !masses && high < 1e3; low = high, high *= 4.0) {
        masses = program.solve(high);
        result.tolerance = high;
        if (masses) break;
    }
    if (!masses)
        throw Error("clump",
                    "found spheres whose masses cannot have the body's center of mass, "
                    "expected spheres on all sides of it");
    while (result.tolerance > 0.0 && result.tolerance - low > 1e-3 * result.tolerance) {
        const double middle = 0.5 * (low + result.tolerance);
        if (auto tighter = program.solve(middle)) {
            masses = std::move(tighter);
            result.tolerance = middle;
        } else {
            low = middle;
        }
    }
    for (const double mass : *masses) result.shares.push_back(mass * body.volume);
    return result;
}

}  // namespace dem
