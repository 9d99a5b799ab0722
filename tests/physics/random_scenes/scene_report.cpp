// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/random_scenes/scene_report.hpp"

#include "common/error.hpp"
#include "runtime/measure/energy.hpp"
#include "runtime/simulation.hpp"
#include "runtime/time_step.hpp"
#include "tests/physics/random_scenes/random_scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace dem::test {

using namespace runtime;

namespace {

double kinetic_energy(const Energies& e) {
    return e.translational + e.rotational;
}

double fastest_speed(const Simulation& simulation) {
    double speed = 0.0;
    for (const Vec3& v : simulation.particles().velocity) speed = std::max(speed, v.norm());
    return speed;
}

double speed_without_spin(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    const Scene& scene = simulation.scene();
    double speed = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double radius = scene.shapes[scene.kinds[p.kind[i]].shape].bounding_radius;
        const double by_spin = std::abs(p.angular_velocity[i].z()) * radius;
        speed = std::max({speed, p.velocity[i].norm() - by_spin, std::abs(p.velocity[i].z())});
    }
    return speed;
}

/// Looks at a scene now and then.
class Watch {
  public:
    explicit Watch(const Scene& scene) {
        for (const BodyKind& kind : scene.kinds)
            fall_ += bodies_per_kind * kind.mass * scene.run.gravity.norm() * largest_radius(scene);
    }

    void look(const Simulation& simulation) {
        const Energies e = energies(simulation);
        if (start_ < 0.0) start_ = kinetic_energy(e);
        // Kinetic at the start, that of a fall by the largest radius, and the work of walls.
        const double scale = start_ + fall_ + std::abs(e.wall_work);
        const double share = e.residual() / scale;
        const double change = std::abs(share - share_);
        if (change > report.event) {
            report.event = change;
            report.moment = simulation.time();
        }
        share_ = share;
        report.residual = std::max(report.residual, std::abs(share));
        report.fastest = std::max(report.fastest, fastest_speed(simulation));
        report.moving = speed_without_spin(simulation);
        report.overlap = std::max(report.overlap, simulation.largest_overlap().relative);
        report.kinetic = kinetic_energy(e) / scale;
        report.cores_met = simulation.core_overlaps() > 0;
        report.touched = report.touched || e.dissipated > 0.0 || e.elastic > 0.0;
        report.bodies = simulation.particles().size();
    }

    SceneReport report;

  private:
    double fall_ = 0.0;
    double start_ = -1.0;
    double share_ = 0.0;
};

}  // namespace

SceneReport report_of(Scene scene, const SceneSteps& steps) {
    scene.run.time_step_divisor = steps.divisor;
    const double dt = time_step(scene).value;
    Watch watch(scene);
    try {
        Simulation simulation(std::move(scene), dt);
        for (int step = 0; step < steps.count; ++step) {
            simulation.step();
            if (step % 20 == 0) watch.look(simulation);
        }
    } catch (const Error& error) {
        if (std::string(error.what()).find(" overlap by ") == std::string::npos) throw;
        watch.report.crushed = true;
    }
    return watch.report;
}

}  // namespace dem::test
