// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/measure/fill_height.hpp"

#include "runtime/contact/touch.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace dem {

namespace {

// Cells of nearly equal area about an axis: ring k holds 6k + 3 of them (the inner one 3).
class PolarGrid {
  public:
    PolarGrid(double radius, double cell)
        : rings_(static_cast<std::size_t>(std::max(1.0, std::round(radius / cell)))),
          width_(radius / static_cast<double>(rings_)),
          highest_(3 * rings_ * rings_, 0.0) {}

    void add(double x, double y, double height) {
        const auto ring = static_cast<std::size_t>(std::hypot(x, y) / width_);
        if (ring >= rings_) return;
        const double turn = std::atan2(y, x) / (2.0 * pi) + 0.5;
        const std::size_t cells = 6 * ring + 3;
        const auto cell =
            std::min(cells - 1, static_cast<std::size_t>(turn * static_cast<double>(cells)));
        double& highest = highest_[3 * ring * ring + cell];
        highest = std::max(highest, height);
    }

    // Ring k covers pi width^2 (2k + 1) with 3 (2k + 1) cells: all cells have the same area.
    double mean() const {
        double sum = 0.0;
        for (const double height : highest_) sum += height;
        return sum / static_cast<double>(highest_.size());
    }

  private:
    std::size_t rings_;
    double width_;
    std::vector<double> highest_;
};

Vessel vessel_or_extent(const Particles& particles, const Scene& scene) {
    if (const auto vessel = find_vessel(scene)) return *vessel;
    Vessel vessel;
    vessel.up = up_direction(scene);
    for (const Vec3& x : particles.position) vessel.center += x;
    vessel.center /= static_cast<double>(particles.size());
    for (const Vec3& x : particles.position) {
        vessel.radius = std::max(vessel.radius, (x - vessel.center).cross(vessel.up).norm());
    }
    return vessel;
}

double mean_diameter(const Particles& particles, const Scene& scene) {
    double sum = 0.0;
    for (const std::uint32_t kind : particles.kind) {
        sum += equivalent_diameter(scene.shapes[scene.kinds[kind].shape].mass_properties.volume);
    }
    return sum / static_cast<double>(particles.size());
}

double surface_height(const Particles& particles, const Scene& scene, const Vessel& vessel) {
    const Vec3 east = vessel.up.unitOrthogonal();
    const Vec3 north = vessel.up.cross(east);
    const double cell = mean_diameter(particles, scene);
    PolarGrid grid(std::max(vessel.radius, 0.5 * cell), cell);
    const auto add = [&](const Vec3& x) {
        const Vec3 d = x - vessel.center;
        grid.add(d.dot(east), d.dot(north), x.dot(vessel.up) - vessel.floor);
    };
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const ParticleTemplate& shape = scene.shapes[scene.kinds[particles.kind[i]].shape];
        const Vec3& x = particles.position[i];
        for (const Vec3& vertex : shape.display_mesh.vertices) {
            add(x + particles.orientation[i] * vertex);
        }
        if (const auto* sphere = std::get_if<Sphere>(&shape.shape)) {
            add(x + sphere->radius * vessel.up);
        }
    }
    return grid.mean();
}

}  // namespace

FillHeight fill_height(const Particles& particles, const Scene& scene) {
    FillHeight result;
    if (particles.size() == 0) return result;
    const Vessel vessel = vessel_or_extent(particles, scene);

    std::vector<double> tops;
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        const ParticleTemplate& shape = scene.shapes[scene.kinds[particles.kind[i]].shape];
        tops.push_back(particles.position[i].dot(vessel.up) +
                       extent(shape, particles.orientation[i], vessel.up) - vessel.floor);
    }
    const std::size_t ten = std::min<std::size_t>(10, tops.size());
    std::partial_sort(tops.begin(), tops.begin() + static_cast<std::ptrdiff_t>(ten), tops.end(),
                      std::greater<>());
    result.highest = tops.front();
    for (std::size_t k = 0; k < ten; ++k) result.top_ten += tops[k] / static_cast<double>(ten);
    result.surface = surface_height(particles, scene, vessel);
    return result;
}

}  // namespace dem
