// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/sdf.hpp"

#include "common/error.hpp"

#include <bit>
#include <cmath>
#include <string>
#include <vector>

namespace dem::shapegen {

namespace {

constexpr double band_depth = 0.058;   // of interface cells inwards, in l: the largest overlap
constexpr double corner_reach = 0.01;  // of corner cells, in l

/// Level of `cells` below `base`, both per l.
std::uint32_t level_of(std::uint32_t cells, std::uint32_t base) {
    return static_cast<std::uint32_t>(std::countr_zero(cells / base));
}

/// Distance from a point to the square cell with the given lower corner.
double distance_to_cell(const Vec2& x, const Vec2& lower, double size) {
    const Vec2 nearest = x.cwiseMax(lower).cwiseMin(lower + Vec2::Constant(size));
    return (x - nearest).norm();
}

class Builder {
  public:
    Builder(const Profile& profile, const SdfResolution& resolution, double least_margin)
        : profile_(profile),
          length_(profile.major_axis_length()),
          interface_level_(level_of(resolution.interface, resolution.base)),
          corner_level_(level_of(resolution.corner, resolution.base)) {
        const double interface_size = length_ / resolution.interface;
        const double size = length_ / resolution.base;
        outer_reach_ = 2.0 * interface_size;
        inner_reach_ = band_depth * length_ + interface_size;
        // One base cell, and more when the base cells are as fine as the interface cells.
        const double margin = std::max({size, outer_reach_, least_margin});
        const double height = profile.max_z() - profile.min_z();
        sdf_.base_size = size;
        sdf_.margin = margin;
        sdf_.origin_r = -0.5 * interface_size;
        sdf_.cells_r = cell_count(profile.max_radius() + margin - sdf_.origin_r);
        sdf_.cells_z = cell_count(height + 2.0 * margin);
        sdf_.origin_z = 0.5 * (profile.min_z() + profile.max_z() - sdf_.cells_z * size);
    }

    SdfQuadtree build() {
        choose_levels();
        for (std::uint32_t k = 0; k < sdf_.cells_z; ++k) {
            for (std::uint32_t i = 0; i < sdf_.cells_r; ++i) fill(i, k);
        }
        for (std::uint32_t k = 0; k < sdf_.cells_z; ++k) {
            for (std::uint32_t i = 0; i < sdf_.cells_r; ++i) join_coarser_neighbors(i, k);
        }
        sdf_.cells = std::move(cells_);
        sdf_.values = std::move(values_);
        return std::move(sdf_);
    }

  private:
    std::uint32_t cell_count(double extent) const {
        return static_cast<std::uint32_t>(std::ceil(extent / sdf_.base_size));
    }
    SdfCell& cell(std::uint32_t i, std::uint32_t k) { return cells_[k * sdf_.cells_r + i]; }

    /// Grid point a / n of the way through base column i and b / n through base row k. A
    /// point gets the same bits from every cell that touches it.
    Vec2 point(double i, double k) const {
        return {sdf_.origin_r + sdf_.base_size * i, sdf_.origin_z + sdf_.base_size * k};
    }

    void choose_levels() {
        const double half_diagonal = sdf_.base_size * std::sqrt(0.5);
        const auto corners = profile_.corners();
        cells_.resize(static_cast<std::size_t>(sdf_.cells_r) * sdf_.cells_z);
        for (std::uint32_t k = 0; k < sdf_.cells_z; ++k) {
            for (std::uint32_t i = 0; i < sdf_.cells_r; ++i) {
                const double d = exact(point(i + 0.5, k + 0.5));
                const bool in_band =
                    d - half_diagonal < outer_reach_ && d + half_diagonal > -inner_reach_;
                std::uint32_t level = in_band ? interface_level_ : 0;
                for (const Profile::Corner& corner : corners) {
                    if (distance_to_cell(corner.point, point(i, k), sdf_.base_size) <
                        corner_reach * length_) {
                        level = corner_level_;
                    }
                }
                cell(i, k).level = level;
            }
        }
    }

    double exact(const Vec2& x) const { return profile_.signed_distance({std::abs(x[0]), x[1]}); }

    void fill(std::uint32_t i, std::uint32_t k) {
        SdfCell& c = cell(i, k);
        c.first_value = static_cast<std::uint32_t>(values_.size());
        const std::uint32_t n = 1U << c.level;
        for (std::uint32_t b = 0; b <= n; ++b) {
            for (std::uint32_t a = 0; a <= n; ++a) {
                values_.push_back(
                    exact(point(i + static_cast<double>(a) / n, k + static_cast<double>(b) / n)));
            }
        }
    }

    /// A run of values along one side of a cell.
    struct Side {
        std::uint32_t first, stride, level;
    };
    enum class At { left, right, bottom, top };
    Side side(std::uint32_t i, std::uint32_t k, At at) {
        const SdfCell& c = cell(i, k);
        const std::uint32_t n = 1U << c.level;
        switch (at) {
            case At::left:
                return {c.first_value, n + 1, c.level};
            case At::right:
                return {c.first_value + n, n + 1, c.level};
            case At::bottom:
                return {c.first_value, 1, c.level};
            case At::top:
                break;
        }
        return {c.first_value + n * (n + 1), 1, c.level};
    }

    void join_coarser_neighbors(std::uint32_t i, std::uint32_t k) {
        if (i > 0) join(side(i, k, At::left), side(i - 1, k, At::right));
        if (i + 1 < sdf_.cells_r) join(side(i, k, At::right), side(i + 1, k, At::left));
        if (k > 0) join(side(i, k, At::bottom), side(i, k - 1, At::top));
        if (k + 1 < sdf_.cells_z) join(side(i, k, At::top), side(i, k + 1, At::bottom));
    }

    /// Replaces the hanging values of the finer side by what the coarser one interpolates.
    void join(const Side& fine, const Side& coarse) {
        if (fine.level <= coarse.level) return;
        const std::uint32_t ratio = 1U << (fine.level - coarse.level);
        const std::uint32_t n = 1U << fine.level;
        for (std::uint32_t a = 0; a < n; ++a) {
            const double t = static_cast<double>(a % ratio) / ratio;
            const std::size_t place = a / ratio;
            const double* v = values_.data() + coarse.first + place * coarse.stride;
            if (a % ratio != 0) {
                values_[fine.first + a * fine.stride] = v[0] + t * (v[coarse.stride] - v[0]);
            }
        }
    }

    const Profile& profile_;
    double length_;
    double outer_reach_, inner_reach_;
    std::uint32_t interface_level_, corner_level_;
    SdfQuadtree sdf_;
    std::vector<SdfCell> cells_;
    std::vector<double> values_;
};

void check_ratio(const std::string& option, std::uint32_t fine, std::uint32_t coarse,
                 const std::string& coarse_option) {
    if (coarse == 0 || fine < coarse || fine % coarse != 0 || !std::has_single_bit(fine / coarse)) {
        throw UsageError(option, "found " + std::to_string(fine) + ", expected " + coarse_option +
                                     " (" + std::to_string(coarse) + ") times a power of two");
    }
}

}  // namespace

void check_resolution(const SdfResolution& resolution) {
    check_ratio("--interface-cells", resolution.interface, resolution.base, "--base-cells");
    check_ratio("--corner-cells", resolution.corner, resolution.interface, "--interface-cells");
}

SdfQuadtree signed_distance_field(const Profile& profile, const SdfResolution& resolution,
                                  double least_margin) {
    return Builder(profile, resolution, least_margin).build();
}

}  // namespace dem::shapegen
