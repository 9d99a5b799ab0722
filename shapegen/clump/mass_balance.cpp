// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/mass_balance.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <Eigen/QR>
#include <glpk.h>

namespace dem::shapegen {
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

/// Equations that are met together: rows of a column() and what their errors are relative to.
enum Group { centers, moments, products };
constexpr std::array<Group, 9> group_of{centers, centers,  centers,  moments, moments,
                                        moments, products, products, products};

/// The linear program. The mass of ball i, in units of the body's, is e_i x + s_i with x and s_i >=
/// 0 and e_i that of an even density; so the least ratio of a mass to that of an even density is x
/// at least, and there are no more rows than equations. A last variable t is a tolerance that can
/// be minimized.
class Program {
  public:
    Program(std::span<const Ball> balls, const MassProperties& body)
        : count_(static_cast<int>(balls.size())), problem_(glp_create_prob(), glp_delete_prob) {
        glp_term_out(GLP_OFF);
        const double length = math::cbrt(body.volume);
        const Vec3 principal = body.principal_moments_per_density / (body.volume * square(length));
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            scales_[a] = math::cbrt(6.0 / pi);  // the diameter of the sphere of volume 1
            wanted_[3 + a] = scales_[3 + a] = principal[axis];
            scales_[6 + a] = principal.mean();
        }
        double total = 0.0;
        for (const Ball& ball : balls) total += cube(ball.radius);
        for (const Ball& ball : balls) {
            columns_.push_back(column(ball, length));
            even_.push_back(cube(ball.radius) / total);
        }
        fill();
    }

    /// The least tolerance of a group's equations; that of the others is as set, or any.
    double least_tolerance(Group group) {
        set_column(tolerance_column(), [&](std::size_t q, int side) {
            return group_of[q] == group ? side * scales_[q] : 0.0;
        });
        glp_set_obj_dir(problem_.get(), GLP_MIN);
        glp_set_obj_coef(problem_.get(), 1, 0.0);
        glp_set_obj_coef(problem_.get(), tolerance_column(), 1.0);
        set_tolerance(group, 0.0);
        for (std::size_t q = 0; q < wanted_.size(); ++q)
            if (group_of[q] == group) set_bounds(q, GLP_UP, GLP_LO);
        if (!solve()) fail();
        return glp_get_obj_val(problem_.get());
    }

    void set_tolerance(Group group, double tolerance) {
        for (std::size_t q = 0; q < wanted_.size(); ++q) {
            if (group_of[q] != group) continue;
            slacks_[q] = tolerance * scales_[q];
            set_bounds(q, slacks_[q] > 0.0 ? GLP_UP : GLP_FX, slacks_[q] > 0.0 ? GLP_LO : GLP_FR);
        }
    }

    /// Whether there are masses within the tolerances that are set.
    bool is_feasible() {
        make_even();
        return solve();
    }

    /// With the tolerances set, the masses that are most even.
    std::vector<double> most_even_masses() {
        if (!is_feasible()) fail();
        const double x = glp_get_col_prim(problem_.get(), 1);
        std::vector<double> masses;
        masses.reserve(even_.size());
        for (int i = 0; i < count_; ++i)
            masses.push_back(std::max(
                even_[static_cast<std::size_t>(i)] * x + glp_get_col_prim(problem_.get(), 2 + i),
                0.0));
        remove_rounding(masses);
        return masses;
    }

    [[noreturn]] static void fail() {
        throw Error("clump",
                    "found no masses for its spheres, expected them by linear programming");
    }

  private:
    static constexpr int below = -1;  // sum - tolerance <= wanted
    static constexpr int above = 1;
    static int row(std::size_t q, int side) {
        return 2 + 2 * static_cast<int>(q) + (side == above ? 1 : 0);
    }
    int tolerance_column() const { return 2 + count_; }

    void fill() {
        glp_add_rows(problem_.get(), 1 + 2 * (rows - 1));
        glp_add_cols(problem_.get(), 2 + count_);
        glp_set_row_bnds(problem_.get(), 1, GLP_FX, 1.0, 1.0);
        for (std::size_t q = 0; q < wanted_.size(); ++q) {
            glp_set_row_bnds(problem_.get(), row(q, below), GLP_FR, 0.0, 0.0);
            glp_set_row_bnds(problem_.get(), row(q, above), GLP_FR, 0.0, 0.0);
        }
        std::array<double, rows> even{};
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            for (std::size_t r = 0; r < rows; ++r) even[r] += even_[i] * columns_[i][r];
            set_column(
                2 + static_cast<int>(i), [&](std::size_t q, int) { return columns_[i][q + 1]; },
                1.0);
        }
        set_column(
            1, [&](std::size_t q, int) { return even[q + 1]; }, 1.0);
        for (int c = 1; c <= tolerance_column(); ++c)
            glp_set_col_bnds(problem_.get(), c, GLP_LO, 0.0, 0.0);
    }

    /// Sets the bounds of an equation's two rows, by the kinds of bounds that GLPK knows.
    void set_bounds(std::size_t q, int kind_below, int kind_above) {
        const double most = wanted_[q] + slacks_[q];
        const double least = wanted_[q] - slacks_[q];
        glp_set_row_bnds(problem_.get(), row(q, below), kind_below, most, most);
        glp_set_row_bnds(problem_.get(), row(q, above), kind_above, least, least);
    }

    /// value(equation, side) for all rows but the first.
    template <class Value>
    void set_column(int c, const Value& value, double mass = 0.0) {
        std::array<int, 2 * rows> index{};
        std::array<double, 2 * rows> values{};
        index[1] = 1;
        values[1] = mass;
        for (std::size_t q = 0; q < wanted_.size(); ++q) {
            for (const int side : {below, above}) {
                const int r = row(q, side);
                index[static_cast<std::size_t>(r)] = r;
                // All is of order one; less than this is rounding, and misleads the simplex method.
                const double entry = value(q, side);
                values[static_cast<std::size_t>(r)] = std::abs(entry) > 1e-12 ? entry : 0.0;
            }
        }
        glp_set_mat_col(problem_.get(), c, 2 * rows - 1, index.data(), values.data());
    }

    /// The last variable is left out, and the masses are to be most even.
    void make_even() {
        set_column(tolerance_column(), [](std::size_t, int) { return 0.0; });
        glp_set_obj_dir(problem_.get(), GLP_MAX);
        glp_set_obj_coef(problem_.get(), 1, 1.0);
        glp_set_obj_coef(problem_.get(), tolerance_column(), 0.0);
    }

    bool solve() {
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        glp_adv_basis(problem_.get(), 0);
        return glp_simplex(problem_.get(), &settings) == 0 &&
               glp_get_status(problem_.get()) == GLP_OPT;
    }

    /// The simplex method meets its rows to 1e-7: the rest is spread over the masses, in proportion
    /// to them, with the least squares that do it.
    void remove_rounding(std::vector<double>& masses) const {
        using Row = Eigen::Matrix<double, rows, 1>;
        Eigen::Matrix<double, rows, rows> normal = Eigen::Matrix<double, rows, rows>::Zero();
        Row sum = Row::Zero();
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const Eigen::Map<const Row> a(columns_[i].data());
            sum += masses[i] * a;
            normal += masses[i] * a * a.transpose();
        }
        Row missing;
        missing[0] = 1.0 - sum[0];
        for (std::size_t q = 0; q < wanted_.size(); ++q) {
            const auto r = static_cast<Eigen::Index>(q) + 1;
            missing[r] =
                std::clamp(sum[r], wanted_[q] - slacks_[q], wanted_[q] + slacks_[q]) - sum[r];
        }
        // Equations that no masses can change, and some are such by symmetry, are left as they are.
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, rows, rows>> solver;
        solver.setThreshold(1e-9);
        const Row change = solver.compute(normal).solve(missing);
        std::vector<double> factors;
        for (const auto& entries : columns_)
            factors.push_back(1.0 + Eigen::Map<const Row>(entries.data()).dot(change));
        // Larger changes are no rounding; the mass itself is met all the same.
        const bool is_rounding = std::all_of(factors.begin(), factors.end(), [](double factor) {
            return std::abs(factor - 1.0) <= 1e-3;
        });
        for (std::size_t i = 0; i < masses.size(); ++i)
            masses[i] *= is_rounding ? factors[i] : 1.0 / sum[0];
    }

    int count_;
    std::unique_ptr<glp_prob, void (*)(glp_prob*)> problem_;
    std::vector<std::array<double, rows>> columns_;
    std::vector<double> even_;
    std::array<double, rows - 1> wanted_{}, scales_{}, slacks_{};
};

}  // namespace

MassBalance balance_masses(std::span<const Ball> balls, const MassProperties& body) {
    constexpr double met = 1e-9;  // below it is rounding
    Program program(balls, body);
    const auto settle = [&](Group group) {
        const double least = program.least_tolerance(group);
        double tolerance = least > met ? least : 0.0;
        program.set_tolerance(group, tolerance);
        // At the very limit rounding may leave no way at all.
        for (double room = std::max(1e-6 * least, met); !program.is_feasible(); room *= 4.0) {
            if (room > 1.0) Program::fail();
            tolerance = least + room;
            program.set_tolerance(group, tolerance);
        }
        return tolerance;
    };
    MassBalance result;
    result.center_tolerance = settle(centers);
    result.product_tolerance = settle(products);
    result.tolerance = settle(moments);
    for (const double mass : program.most_even_masses())
        result.shares.push_back(mass * body.volume);
    return result;
}

}  // namespace dem::shapegen
