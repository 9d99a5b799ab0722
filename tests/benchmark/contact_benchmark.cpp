// SPDX-License-Identifier: BSD-3-Clause
/// Nanoseconds per call of the contact kernels on one core, over 1024 different pairs each, so that
/// branches are not learnt by heart.
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "tests/runtime/contact/convex_shapes.hpp"
#include "tests/runtime/contact/memory_of.hpp"

#include <vector>

#include <benchmark/benchmark.h>

namespace dem::test {

using namespace runtime;

namespace {

constexpr std::size_t pair_count = 1024;
constexpr double dt = 5e-7;

ContactLaw packing_law() {
    ContactLaw law = pair_law({5e7, 0.3}, {5e7, 0.3}, 0.5);
    law.friction = 0.3;
    return law;
}

/// Touching with a few micrometers, or apart by `gap`; slow motion as in a settling bed.
std::vector<PairState> pairs(const SolidBody& body, double overlap) {
    const ContactLaw law = packing_law();
    std::vector<PairState> result;
    Random random(5, 5);
    while (result.size() < pair_count) {
        PairState pair;
        for (BodyState* b : {&pair.i, &pair.j}) {
            b->orientation = random.orientation();
            b->velocity = 0.01 * random.direction();
            b->angular_velocity = random.direction();
            b->inverse_inertia = body.inverse(1377.0);
        }
        const Vec3 direction = random.direction();
        double low = 1e-3;
        double high = 14e-3;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (low + high);
            pair.displacement = middle * direction;
            PointHistory history;
            MissCache miss;
            const PairContact c =
                collide(body.shape, body.shape, Call{pair, law, 0.0, Memory{history, miss}});
            const bool too_near =
                c.touches() ? c.overlap > overlap : overlap < 0.0 && miss.gap < -overlap;
            (too_near ? low : high) = middle;
        }
        pair.displacement = high * direction;
        result.push_back(pair);
    }
    return result;
}

/// One step of every pair along its motion, back and forth.
void move(std::vector<PairState>& all, bool forth) {
    const double h = forth ? dt : -dt;
    for (PairState& p : all) {
        p.displacement += h * (p.j.velocity - p.i.velocity);
        for (BodyState* b : {&p.i, &p.j}) {
            const Vec3 half = 0.5 * h * b->angular_velocity;
            b->orientation =
                (Quat(1.0, half.x(), half.y(), half.z()) * b->orientation).normalized();
        }
    }
}

void report(benchmark::State& state) {
    state.counters["ns/pair"] = benchmark::Counter(
        static_cast<double>(pair_count),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

enum class Start { warm, cold };

void continuous(benchmark::State& state, const SolidBody& body, double overlap, Start start) {
    std::vector<PairState> all = pairs(body, overlap);
    const ContactLaw law = packing_law();
    std::vector<PointHistory> histories(pair_count);
    std::vector<MissCache> caches(pair_count);
    bool forth = true;
    for (auto _ : state) {
        state.PauseTiming();
        move(all, forth = !forth);
        if (start == Start::cold) {
            std::fill(histories.begin(), histories.end(), PointHistory{});
            std::fill(caches.begin(), caches.end(), MissCache{});
        }
        state.ResumeTiming();
        for (std::size_t k = 0; k < pair_count; ++k)
            benchmark::DoNotOptimize(collide(
                body.shape, body.shape, Call{all[k], law, dt, Memory{histories[k], caches[k]}}));
    }
    report(state);
}

void law_alone(benchmark::State& state, double friction) {
    const std::vector<PairState> all = pairs(candy(), 5e-6);
    ContactLaw law = packing_law();
    law.friction = friction;
    std::vector<PointHistory> histories(pair_count);
    std::vector<ContactPoint> points;
    for (const PairState& p : all) {
        const Vec3 n = -p.displacement.normalized();
        points.push_back({0.5 * p.displacement, n, 5e-6, 0});
    }
    for (auto _ : state)
        for (std::size_t k = 0; k < pair_count; ++k)
            benchmark::DoNotOptimize(contact_force(points[k], 2e-3, all[k], law, dt, histories[k]));
    report(state);
}

void patch_law(benchmark::State& state) {
    const std::vector<PairState> all = pairs(candy(), 5e-6);
    const ContactLaw law = packing_law();
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<PatchHistory> histories(pair_count);
    Random random(6, 6);
    std::vector<ContactPoint> points;
    for (std::size_t k = 0; k < count; ++k)
        points.push_back({Vec3(0.0, 1e-4 * static_cast<double>(k), 3e-3), -Vec3::UnitZ(),
                          random.uniform(1e-6, 5e-6), k});
    for (auto _ : state)
        for (std::size_t k = 0; k < pair_count; ++k)
            benchmark::DoNotOptimize(contact_force(points, 2e-3, all[k], law, dt, histories[k]));
    report(state);
}

void sphere_pairs(benchmark::State& state, double overlap) {
    std::vector<PairState> all = pairs(round_body(3e-3), overlap);
    const Sphere sphere{3e-3};
    const ContactLaw law = packing_law();
    std::vector<PointHistory> histories(pair_count);
    for (auto _ : state)
        for (std::size_t k = 0; k < pair_count; ++k)
            benchmark::DoNotOptimize(
                collide(sphere, sphere, Call{all[k], law, dt, memory_of(histories[k])}));
    report(state);
}

void inside_cylinder(benchmark::State& state, const SolidBody& body) {
    std::vector<PairState> all = pairs(body, 5e-6);
    const CylinderWall wall{25.3e-3};
    const ContactLaw law = packing_law();
    std::vector<PatchHistory> histories(pair_count);
    MissCache miss;
    for (PairState& p : all) {
        p.j = {};
        const double angle = p.displacement.x() * 1e5;
        double low = 0.0;
        double high = 25e-3;
        for (int k = 0; k < 40; ++k) {
            const double r = 0.5 * (low + high);
            p.displacement = -r * Vec3(std::cos(angle), std::sin(angle), 0.0);
            PatchHistory history;
            (collide(body.shape, wall, Call{p, law, dt, Memory{history, miss}}).overlap > 5e-6
                 ? high
                 : low) = r;
        }
    }
    for (auto _ : state)
        for (std::size_t k = 0; k < pair_count; ++k)
            benchmark::DoNotOptimize(
                collide(body.shape, wall, Call{all[k], law, dt, Memory{histories[k], miss}}));
    report(state);
}

BENCHMARK_CAPTURE(continuous, candy_warm, candy(), 5e-6, Start::warm);
BENCHMARK_CAPTURE(continuous, candy_cold, candy(), 5e-6, Start::cold);
BENCHMARK_CAPTURE(continuous, candy_near_miss, candy(), -1e-5, Start::warm);
BENCHMARK_CAPTURE(continuous, tablet_warm, tablet(), 5e-6, Start::warm);
BENCHMARK_CAPTURE(continuous, tablet_cold, tablet(), 5e-6, Start::cold);
BENCHMARK_CAPTURE(continuous, tablet_near_miss, tablet(), -1e-5, Start::warm);
BENCHMARK_CAPTURE(continuous, cylinder_warm, cylinder(4e-3, 6e-3), 5e-6, Start::warm);
BENCHMARK_CAPTURE(continuous, cylinder_cold, cylinder(4e-3, 6e-3), 5e-6, Start::cold);
BENCHMARK_CAPTURE(law_alone, friction, 0.3);
BENCHMARK_CAPTURE(law_alone, smooth, 0.0);
BENCHMARK(patch_law)->Arg(1)->Arg(2)->Arg(10)->Arg(40);
BENCHMARK_CAPTURE(sphere_pairs, touching, 5e-6);
BENCHMARK_CAPTURE(sphere_pairs, apart, -1e-5);
BENCHMARK_CAPTURE(inside_cylinder, candy, candy());
BENCHMARK_CAPTURE(inside_cylinder, tablet, tablet());

}  // namespace
}  // namespace dem::test

BENCHMARK_MAIN();
