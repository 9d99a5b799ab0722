// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/height_map.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

HeightMap::HeightMap(double radius, double spacing)
    : radius_(radius),
      spacing_(spacing),
      half_(static_cast<long>(radius / spacing)),
      height_(static_cast<std::size_t>((2 * half_ + 1) * (2 * half_ + 1)), 0.0) {}

template <class Use>
void HeightMap::for_lines(double x_min, double x_max, double y_min, double y_max,
                          const Use& use) const {
    const auto first = [&](double x) {
        return std::max(-half_, static_cast<long>(std::ceil(std::max(x, -radius_) / spacing_)));
    };
    const auto last = [&](double x) {
        return std::min(half_, static_cast<long>(std::floor(std::min(x, radius_) / spacing_)));
    };
    for (long i = first(x_min); i <= last(x_max); ++i) {
        for (long j = first(y_min); j <= last(y_max); ++j) {
            const double x = static_cast<double>(i) * spacing_;
            const double y = static_cast<double>(j) * spacing_;
            if (x * x + y * y > radius_ * radius_) continue;
            const auto line = static_cast<std::size_t>((i + half_) * (2 * half_ + 1) + j + half_);
            use(x, y, line);
        }
    }
}

void HeightMap::add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double twice_area = ab.x() * ac.y() - ab.y() * ac.x();
    if (!(twice_area > 0.0)) return;  // seen from below, or from the side
    const Vec3 low = a.cwiseMin(b).cwiseMin(c);
    const Vec3 high = a.cwiseMax(b).cwiseMax(c);
    for_lines(low.x(), high.x(), low.y(), high.y(), [&](double x, double y, std::size_t line) {
        const double px = x - a.x();
        const double py = y - a.y();
        const double v = (px * ac.y() - py * ac.x()) / twice_area;
        const double w = (ab.x() * py - ab.y() * px) / twice_area;
        if (v < 0.0 || w < 0.0 || v + w > 1.0) return;
        height_[line] = std::max(height_[line], a.z() + v * ab.z() + w * ac.z());
    });
}

void HeightMap::add_sphere(const Vec3& center, double radius) {
    for_lines(center.x() - radius, center.x() + radius, center.y() - radius, center.y() + radius,
              [&](double x, double y, std::size_t line) {
                  const double px = x - center.x();
                  const double py = y - center.y();
                  const double square = radius * radius - px * px - py * py;
                  if (square < 0.0) return;
                  height_[line] = std::max(height_[line], center.z() + std::sqrt(square));
              });
}

double HeightMap::volume() const {
    double sum = 0.0;
    for (const double height : height_) sum += height;
    return sum * spacing_ * spacing_;
}

double HeightMap::area() const {
    std::size_t lines = 0;
    for_lines(-radius_, radius_, -radius_, radius_, [&](double, double, std::size_t) { ++lines; });
    return static_cast<double>(lines) * spacing_ * spacing_;
}

}  // namespace dem::runtime
