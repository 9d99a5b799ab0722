// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/random.hpp"
#include "runtime/simulation.hpp"
#include "tests/runtime/simulation/scenes.hpp"

#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <string>
#include <vector>

#include <malloc.h>

// Cost of the time loop on settled beds with fixed counts:
//
//     time_loop_benchmark spheres|candies|candies_nodes|tablets|clumps|sand|cylinders|filling|drum
//                         [count [threads[,threads...] [steps [skin in mm]]]]
//
// A bed first settles with a large time step, then the loop is timed with the one of the scene,
// from the same state for each number of threads at most. The hash proves that a faster version
// still computes the same. The cost of one core is in cpu_us; the wall time says as much only on an
// idle machine. Virtual machines are given more or fewer of the cycles of their cores from second
// to second: `cycles` is cpu_us times the clock measured between the blocks, and can be compared
// from run to run. `lanes`: contacts computed at a time; `rare_percent`: of those given to kernels,
// how many were computed one by one after all, sampled after each block. `filling` is a vessel half
// way through being filled with candies and `drum` a drum of them that turns, both with the large
// step.

namespace dem::runtime {

using namespace shapegen;

namespace {

constexpr const char* scene_names =

    "spheres, candies, candies_nodes, tablets, clumps, sand, cylinders, filling, drum";

struct Settings {
    std::string scene;
    std::uint32_t count;
    std::vector<int> threads{1};
    int steps = 0;
    double skin = 0.0;  // [m]
};

struct Bed {
    Scene scene;
    double settling_dt;  // [s]
    int settling_steps;
    double dt;  // of the measurement [s]
};

// Spheres in a cube; a loose shaken lattice that falls together.
Bed sphere_bed(const Settings& s) {
    constexpr double radius = 2.5e-3;
    Scene scene = scenes::one_material({1e7, 2500.0, 0.5, 0.5});
    scenes::add_kind(scene, scenes::sphere(radius));
    const auto edge = static_cast<std::uint32_t>(std::ceil(std::cbrt(s.count)));
    const double cell = 2.1 * radius;
    std::vector<BodyPlacement> bodies;
    for (std::uint32_t n = 0; n < s.count; ++n) {
        Random random(1, n);
        const Vec3 site(n % edge, n / edge % edge, n / (edge * edge));
        BodyPlacement body;
        body.position = cell * (site + Vec3::Constant(0.5)) + 0.04 * radius * random.direction();
        body.velocity = 0.3 * random.direction();
        bodies.push_back(body);
    }
    scene.insertions.push_back(scenes::placed(bodies));
    const double width = cell * edge;
    scenes::add_box(scene, Vec3::Zero(), {width, width, 2.0 * width});
    return {std::move(scene), 1e-5, 6000, 1e-5};
}

// 250 bodies as in the packing of candies of [SR] Sec. 3.3, or any number in a vessel as deep.
Bed vessel_bed(const Settings& s, const ParticleTemplate& shape, ContactLaw::Method method) {
    ContactLaw options;
    options.geometry.method = method;
    Scene scene = scenes::one_material({5e7, 1377.0, 0.5, 0.3, options});
    scenes::add_kind(scene, shape);
    const double radius = 25.4e-3 * std::sqrt(s.count / 250.0);
    std::vector<BodyPlacement> bodies = scenes::column(s.count, 1, radius, 13.3e-3);
    for (BodyPlacement& body : bodies) body.velocity.z() = -1.0;
    scene.insertions.push_back(scenes::placed(bodies));
    scenes::add_vessel(scene, radius);
    scene.run.overlap_limit = 0.2;  // while they fall
    return {std::move(scene), 5e-6, 100000, 5e-7};
}

// That vessel half full.
Bed filling_bed(const Settings& s) {
    Bed bed = vessel_bed(s, scenes::candy(), ContactLaw::Method::continuous);
    bed.settling_steps = 35000;
    bed.dt = bed.settling_dt;
    return bed;
}

// Candies in a drum that turns about its axis once a second.
Bed drum_bed(const Settings& s) {
    Bed bed = filling_bed(s);
    const double radius = 40e-3 * std::cbrt(s.count / 250.0);
    std::vector<BodyPlacement> bodies = scenes::column(s.count, 1, radius, 13.3e-3);
    double length = 0.0;
    for (BodyPlacement& body : bodies) {
        length = std::max(length, body.position.z() + 7e-3);
        body.position = Vec3(body.position.x(), body.position.z(), body.position.y());
    }
    Wall drum;
    drum.name = "drum";
    drum.shape = CylinderWall{.radius = radius};
    drum.orientation = orientation_towards(Vec3::UnitY());
    drum.motion.pieces = {
        {.kind = MotionPiece::Kind::rotate, .axis = Vec3::UnitY(), .rate = 2.0 * pi}};
    bed.scene.insertions = {scenes::placed(std::move(bodies))};
    bed.scene.walls = {drum, scenes::plane(Vec3::Zero(), Vec3::UnitY()),
                       scenes::plane(length * Vec3::UnitY(), -Vec3::UnitY())};
    bed.settling_steps = 60000;
    return bed;
}

// The same packing of clumps of 60 spheres.
Bed clump_bed(const Settings& s) {
    Bed bed = vessel_bed(s, scenes::candy(), ContactLaw::Method::automatic);
    bed.scene.shapes[0] = scenes::candy_clump(60);
    return bed;
}

// Convex bodies of about 6 mm in a vessel, every one of `kinds` shapes in turn.
Bed convex_bed(const Settings& s, const std::vector<ParticleTemplate>& shapes) {
    Scene scene = scenes::one_material({5e7, 2500.0, 0.5, 0.4});
    for (const ParticleTemplate& shape : shapes) scenes::add_kind(scene, shape);
    const double radius = 20e-3 * std::sqrt(s.count / 250.0);
    const auto kinds = static_cast<std::uint32_t>(shapes.size());
    std::vector<BodyPlacement> bodies = scenes::column(s.count, kinds, radius, 7.8e-3);
    for (BodyPlacement& body : bodies) body.velocity.z() = -0.5;
    scene.insertions.push_back(scenes::placed(bodies));
    scenes::add_vessel(scene, radius);
    return {std::move(scene), 5e-6, 60000, 1e-6};
}

// Grains of 20 vertices, each of its own shape.
Bed sand_bed(const Settings& s) {
    std::vector<ParticleTemplate> grains;
    for (std::uint32_t k = 0; k < s.count; ++k) grains.push_back(scenes::sand_grain(6e-3, 20, k));
    return convex_bed(s, grains);
}

// Cylinders as long as wide.
Bed cylinder_bed(const Settings& s) {
    return convex_bed(s, {scenes::convex(make_cylinder(2.7e-3, 5.4e-3, 6e-5))});
}

Bed make_bed(const Settings& s) {
    if (s.scene == "spheres") return sphere_bed(s);
    if (s.scene == "candies") return vessel_bed(s, scenes::candy(), ContactLaw::Method::continuous);
    if (s.scene == "candies_nodes")
        return vessel_bed(s, scenes::candy(), ContactLaw::Method::nodes);
    if (s.scene == "tablets")
        return vessel_bed(s, scenes::tablet(), ContactLaw::Method::continuous);
    if (s.scene == "filling") return filling_bed(s);
    if (s.scene == "drum") return drum_bed(s);
    if (s.scene == "clumps") return clump_bed(s);
    if (s.scene == "sand") return sand_bed(s);
    if (s.scene == "cylinders") return cylinder_bed(s);
    throw UsageError("unknown scene '" + s.scene + "', expected one of: " + scene_names);
}

// The scene with its bodies where they are now.
Scene restarted(const Simulation& simulation) {
    Scene scene = simulation.scene();
    const Particles& p = simulation.particles();
    std::vector<BodyPlacement> bodies;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        bodies.push_back({.position = p.position[i],
                          .orientation = p.orientation[i],
                          .velocity = p.velocity[i],
                          .angular_velocity = p.angular_velocity[i],
                          .kind = p.kind[i]});
    }
    scene.insertions = {scenes::placed(std::move(bodies))};
    return scene;
}

// Per particle and step [us]: medians over blocks of steps, and the best block, which is the least
// disturbed by other work on the machine.
struct Cost {
    double wall, cpu, best_cpu;
    double cycles;  ///< per particle and step, median
    double clock;   ///< [GHz], median
    double rare;    ///< lanes in percent, mean over the blocks
};

// CPU time of this thread [s].
double thread_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Cycles per nanosecond of CPU time: a chain of multiplications and additions takes four cycles a
// link on every processor of the last fifteen years.
double effective_clock() {
    constexpr int links = 300'000;
    static volatile std::uint64_t odd = 6364136223846793005U;
    const std::uint64_t factor = odd;
    std::uint64_t x = factor;
    const double start = thread_time();
    for (int k = 0; k < links; ++k) x = x * factor + 1U;
    const double elapsed = thread_time() - start;
    odd = x | 1U;
    return 4e-9 * links / elapsed;
}

Cost cost_of(Simulation& simulation, int steps) {
    constexpr int blocks = 20;
    const int block_steps = std::max(1, steps / blocks);
    const double particle_steps = static_cast<double>(simulation.particles().size()) * block_steps;
    std::vector<double> wall, cpu, cycles, clock;
    double clock_before = effective_clock();
    LaneUse lanes;
    for (int block = 0; block < blocks; ++block) {
        const std::clock_t cpu_start = std::clock();
        const auto start = std::chrono::steady_clock::now();
        for (int n = 0; n < block_steps; ++n) simulation.step();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        wall.push_back(1e6 * elapsed.count() / particle_steps);
        cpu.push_back(1e6 * static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC /
                      particle_steps);
        const double clock_after = effective_clock();
        clock.push_back(0.5 * (clock_before + clock_after));
        cycles.push_back(1e3 * cpu.back() * clock.back());
        clock_before = clock_after;
        lanes.contacts += simulation.lanes().contacts;
        lanes.rare += simulation.lanes().rare;
    }
    for (std::vector<double>* values : {&wall, &cpu, &cycles, &clock})
        std::sort(values->begin(), values->end());
    const double rare = 100.0 * static_cast<double>(lanes.rare) /
                        std::max(1.0, static_cast<double>(lanes.contacts));
    return {wall[blocks / 2], cpu[blocks / 2], cpu[0], cycles[blocks / 2], clock[blocks / 2], rare};
}

void measure(const Settings& s, const Bed& bed, const Simulation& settling, int threads) {
    Scene scene = restarted(settling);
    scene.run.threads = threads;
    const std::size_t heap_before = mallinfo2().uordblks;
    Simulation simulation(std::move(scene), bed.dt);
    const int steps = s.steps > 0 ? s.steps : std::max(200, static_cast<int>(8e6 / s.count));
    for (int n = 0; n < steps / 4; ++n) simulation.step();

    const std::uint64_t rebuilds = simulation.lists().rebuilds;
    const Cost cost = cost_of(simulation, steps);
    const std::size_t heap = mallinfo2().uordblks - heap_before;
    const auto& touching = simulation.lists().touching;
    const double count = simulation.particles().size();
    const auto contacts =
        static_cast<double>(std::count(touching.begin(), touching.end(), std::uint8_t{1}));
    std::printf("%s,%u,%d,%.2f,%d,%.4f,%.4f,%.4f,%.0f,%.2f,%.2f,%.2f,%" PRIu64
                ",%.0f,%d,%.1f,%016" PRIx64 "\n",
                s.scene.c_str(), simulation.particles().size(), threads,
                simulation.team().mean_size(), steps, cost.wall, cost.cpu, cost.best_cpu,
                cost.cycles, cost.clock, static_cast<double>(touching.size()) / count,
                contacts / count, simulation.lists().rebuilds - rebuilds,
                static_cast<double>(heap) / count, simulation.lanes().width, cost.rare,
                simulation.state_hash());
    std::fflush(stdout);
}

void measure(const Settings& s) {
    Bed bed = make_bed(s);
    bed.scene.run.threads = *std::max_element(s.threads.begin(), s.threads.end());
    if (s.skin > 0.0) bed.scene.run.skin = s.skin;
    Simulation settling(bed.scene, bed.settling_dt);
    for (int n = 0; n < bed.settling_steps; ++n) settling.step();
    std::printf(
        "scene,particles,threads,threads_used,steps,us_per_particle_step,cpu_us,best_cpu_us,cycles,"
        "clock_ghz,"
        "candidates,contacts,rebuilds,bytes_per_particle,lanes,rare_percent,state_hash\n");
    for (const int threads : s.threads) measure(s, bed, settling, threads);
}

Settings settings(int argc, char** argv) {
    if (argc < 2) throw UsageError(std::string("no scene given, expected one of: ") + scene_names);
    const std::string scene = argv[1];
    Settings s{scene, scene == "spheres" ? 32000U : scene == "cylinders" ? 1000U : 250U};
    if (argc > 2) s.count = static_cast<std::uint32_t>(std::atoi(argv[2]));
    if (argc > 3) {
        s.threads.clear();
        std::istringstream list(argv[3]);
        for (std::string threads; std::getline(list, threads, ',');)
            s.threads.push_back(std::max(1, std::atoi(threads.c_str())));
    }
    if (argc > 4) s.steps = std::atoi(argv[4]);
    if (argc > 5) s.skin = 1e-3 * std::atof(argv[5]);
    return s;
}

}  // namespace
}  // namespace dem::runtime

int main(int argc, char** argv) {
    try {
        dem::runtime::measure(dem::runtime::settings(argc, argv));
    } catch (const dem::UsageError& error) {
        std::fprintf(stderr, "time_loop_benchmark: error: %s\n", error.what());
        return 2;
    } catch (const dem::Error& error) {
        std::fprintf(stderr, "time_loop_benchmark: error: %s\n", error.what());
        return 1;
    }
    return 0;
}
