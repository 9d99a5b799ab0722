// SPDX-License-Identifier: BSD-3-Clause
// The two-level distance field against a uniform grid of interface cells: memory, error within one
// interface cell of the surface and down to an overlap of 0.057 l, time of a look-up. Prints one
// row per shape and field; docs/decisions/sdf-quadtree.md holds the results.
//   sdf_benchmark
#include "common/random.hpp"
#include "common/shapes/sdf_quadtree.hpp"
#include "shapegen/revolution/sdf.hpp"
#include "tests/shapegen/sample_profiles.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace dem::shapegen {
namespace {

/// One level of square cells over the same area.
struct UniformGrid {
    double origin_r, origin_z, size;
    std::uint32_t points_r, points_z;
    std::vector<double> values;
};

UniformGrid uniform_grid(const Profile& profile, const SdfQuadtree& like, double size) {
    UniformGrid grid{like.origin_r, like.origin_z, size, 0, 0, {}};
    const double per_base = like.base_size / size;
    grid.points_r = 1 + static_cast<std::uint32_t>(per_base * like.cells_r + 0.5);
    grid.points_z = 1 + static_cast<std::uint32_t>(per_base * like.cells_z + 0.5);
    for (std::uint32_t k = 0; k < grid.points_z; ++k) {
        for (std::uint32_t i = 0; i < grid.points_r; ++i) {
            grid.values.push_back(profile.signed_distance(
                {std::abs(grid.origin_r + i * size), grid.origin_z + k * size}));
        }
    }
    return grid;
}

/// Inside the grid only: the benchmark's points all are.
SdfSample interpolate(const UniformGrid& grid, double r, double z) {
    const double u = (r - grid.origin_r) / grid.size;
    const double v = (z - grid.origin_z) / grid.size;
    const auto i = static_cast<std::uint32_t>(u);
    const auto k = static_cast<std::uint32_t>(v);
    const double p = u - i;
    const double q = v - k;
    const double* value = grid.values.data() + k * grid.points_r + i;
    const double* above = value + grid.points_r;
    const double lower = value[0] + p * (value[1] - value[0]);
    const double upper = above[0] + p * (above[1] - above[0]);
    const double scale = 1.0 / grid.size;
    return {lower + q * (upper - lower),
            ((1.0 - q) * (value[1] - value[0]) + q * (above[1] - above[0])) * scale,
            (upper - lower) * scale};
}

struct Points {
    std::vector<Vec2> x;
    std::vector<double> exact;
};

/// Random points whose distance from the surface lies in [low, high].
Points points_between(const Profile& profile, double low, double high) {
    Random random(11, 0);
    Points points;
    const double margin = std::max(high, 0.0);
    while (points.x.size() < 100000) {
        const Vec2 x{random.uniform(0.0, profile.max_radius() + margin),
                     random.uniform(profile.min_z() - margin, profile.max_z() + margin)};
        const double d = profile.signed_distance(x);
        if (d < low || d > high) continue;
        points.x.push_back(x);
        points.exact.push_back(d);
    }
    return points;
}

struct Error {
    double mean = 0.0, max = 0.0;
};

template <class Field>
Error error_of(const Field& field, const Points& points) {
    Error error;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        const double e =
            std::abs(interpolate(field, points.x[i][0], points.x[i][1]).distance - points.exact[i]);
        error.mean += e / static_cast<double>(points.x.size());
        error.max = std::max(error.max, e);
    }
    return error;
}

/// The fastest of 25 passes [s per look-up]: other work on the machine only adds to a pass.
template <class Field>
double look_up_time(const Field& field, const Points& points) {
    std::vector<double> times;
    double sum = 0.0;
    for (int pass = 0; pass < 25; ++pass) {
        const auto start = std::chrono::steady_clock::now();
        for (const Vec2& x : points.x) {
            const SdfSample s = interpolate(field, x[0], x[1]);
            sum += s.distance + s.d_dr + s.d_dz;
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        times.push_back(taken.count() / static_cast<double>(points.x.size()));
    }
    return sum == 0.5
               ? 0.0
               : *std::min_element(times.begin(),
                                   times.end());  // the sum keeps the loop from being dropped
}

template <class Field>
void print_row(const std::string& name, const char* kind, std::size_t bytes, const Field& field,
               double l, const std::vector<Points>& zones) {
    std::printf("%-10s %-12s %6.1f", name.c_str(), kind, 1e-3 * static_cast<double>(bytes));
    for (const Points& zone : zones) {
        const Error error = error_of(field, zone);
        std::printf("  %.2e %.2e", error.mean / l, error.max / l);
    }
    std::printf("  %5.1f\n", 1e9 * look_up_time(field, zones.front()));
}

void compare(const std::string& name, const Profile& profile) {
    const double l = profile.major_axis_length();
    const std::vector<Points> zones{points_between(profile, -l / 200.0, l / 200.0),
                                    points_between(profile, -0.057 * l, -l / 200.0)};
    const SdfQuadtree tree = signed_distance_field(profile, {});
    const UniformGrid grid = uniform_grid(profile, tree, l / 200.0);
    print_row(name, "two-level", 8 * (tree.cells.size() + tree.values.size()), tree, l, zones);
    print_row(name, "l/200", 8 * grid.values.size(), grid, l, zones);
}

}  // namespace
}  // namespace dem::shapegen

int main() {
    std::printf(
        "shape      field            KB  surface mean, max [l]  to 0.057 l mean, max [l]     ns\n");
    for (const auto& [name, profile] : dem::test::all_profiles())
        dem::shapegen::compare(name, profile);
}
