// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "runtime/contact/law/pair_law.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "tests/physics/two_bodies.hpp"
#include "tests/runtime/contact/sr_fixture.hpp"

#include <algorithm>
#include <vector>

#include <benchmark/benchmark.h>

/// Cost per pair of contacts by nodes: candies of N nodes at random attitudes, one behind the other
/// in memory as a time loop meets them. `gap` < 0: the deepest node is that far inside.
namespace dem::runtime {
namespace {

const SrShape& candy(std::int64_t nodes) {
    static const SrShape small = test::candy(500);
    static const SrShape medium = test::candy(2000);
    static const SrShape large = test::candy(8000);
    return nodes < 1000 ? small : nodes < 4000 ? medium : large;
}

SrField field_of(const SrShape& slave, const PairState& pair) {
    const Quat to_body = pair.i.orientation.conjugate();
    return {slave, to_body * pair.displacement, to_body * (pair.j.orientation * Vec3::UnitZ())};
}

double nearest_node(const SrShape& master, const SrField& field) {
    double nearest = 1.0;
    for (std::uint32_t k = 0; k < master.nodes.count; ++k) {
        const SurfaceNodes::Node& n = master.nodes.nodes[k];
        nearest = std::min(nearest, field.sample({n.x, n.y, n.z}).distance);
    }
    return nearest;
}

struct Pair {
    PairState state;
    PatchHistory history{};
    NearCache cache{};
};

std::vector<Pair> pairs_at(double gap, const SrShape& shape, int count = 500) {
    Random random(31, 0);
    const InverseInertia inverse = test::solid_sphere(1377.0, 5e-3);
    std::vector<Pair> pairs(static_cast<std::size_t>(count));
    for (Pair& p : pairs) {
        p.state.i = {random.orientation(), Vec3::Zero(), Vec3::Zero(), inverse};
        p.state.j = {random.orientation(), Vec3::Zero(), Vec3::Zero(), inverse};
        const Vec3 towards = random.direction();
        double distance = 2.1 * shape.bounding_radius;
        for (int k = 0; k < 100; ++k) {
            p.state.displacement = distance * towards;
            const double error = nearest_node(shape, field_of(shape, p.state)) - gap;
            if (std::abs(error) < 1e-8) break;
            distance -= error;
        }
    }
    return pairs;
}

ContactLaw law() {
    ContactLaw options;
    options.friction = 0.3;
    return pair_law({5e7, 0.29}, {5e7, 0.29}, 0.5, options);
}

enum class Known { nothing, list };

/// The whole kernel, law included.
void kernel(benchmark::State& state, double gap, Known known) {
    const SrShape& shape = candy(state.range(0));
    std::vector<Pair> pairs = pairs_at(gap, shape);
    ContactScratch scratch(shape.nodes.count);
    const ContactLaw contact_law = law();
    std::size_t touching = 0;
    std::size_t listed = 0;
    for (Pair& p : pairs) {
        const PairContact c =
            collide(shape, shape,
                    PatchCall{p.state, contact_law, 1e-7, {p.history, p.cache}, 1.0, {&scratch}});
        touching += c.points;
        listed += p.cache.count;
    }
    std::size_t k = 0;
    for (auto _ : state) {
        Pair& p = pairs[k];
        k = k + 1 == pairs.size() ? 0 : k + 1;
        if (known == Known::nothing) p.cache.listed_until = 0.0;
        benchmark::DoNotOptimize(
            collide(shape, shape,
                    PatchCall{p.state, contact_law, 1e-7, {p.history, p.cache}, 1.0, {&scratch}}));
    }
    state.counters["touching"] = static_cast<double>(touching) / 500.0;
    state.counters["listed"] = static_cast<double>(listed) / 500.0;
}
BENCHMARK_CAPTURE(kernel, touching_listed, -3e-5, Known::list)->Arg(500)->Arg(2000)->Arg(8000);
BENCHMARK_CAPTURE(kernel, touching_search, -3e-5, Known::nothing)->Arg(500)->Arg(2000)->Arg(8000);
BENCHMARK_CAPTURE(kernel, near_listed, 1.5e-5, Known::list)->Arg(2000);
BENCHMARK_CAPTURE(kernel, near_search, 1.5e-5, Known::nothing)->Arg(2000);
BENCHMARK_CAPTURE(kernel, apart, 1e-3, Known::nothing)->Arg(2000);

/// The walk over all nodes that the search replaces.
void all_nodes(benchmark::State& state) {
    const SrShape& shape = candy(state.range(0));
    const std::vector<Pair> pairs = pairs_at(-3e-5, shape, 50);
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(nearest_node(shape, field_of(shape, pairs[k].state)));
        k = k + 1 == pairs.size() ? 0 : k + 1;
    }
}
BENCHMARK(all_nodes)->Arg(500)->Arg(2000)->Arg(8000);

/// Search alone against list alone, margins in 1/1000 of the length.
void search(benchmark::State& state, Known known) {
    const SrShape& shape = candy(2000);
    std::vector<Pair> pairs = pairs_at(-3e-5, shape);
    std::vector<SrField> fields;
    for (const Pair& p : pairs) fields.push_back(field_of(shape, p.state));
    const double margin = 1e-3 * static_cast<double>(state.range(0)) * shape.major_axis_length / 10;
    std::size_t k = 0;
    double listed = 0.0;
    for (std::size_t n = 0; n < pairs.size(); ++n) {
        visit_touching_nodes(shape.nodes, fields[n], margin, 1.0, pairs[n].cache,
                             [](std::uint32_t, const auto&) {});
        listed += pairs[n].cache.count / 500.0;
    }
    for (auto _ : state) {
        Pair& p = pairs[k];
        if (known == Known::nothing) p.cache.listed_until = 0.0;
        double deepest = 0.0;
        visit_touching_nodes(shape.nodes, fields[k], margin, 1.0, p.cache,
                             [&](std::uint32_t, const auto& s) { deepest += s.distance; });
        benchmark::DoNotOptimize(deepest);
        k = k + 1 == pairs.size() ? 0 : k + 1;
    }
    state.counters["listed"] = listed;
}
BENCHMARK_CAPTURE(search, list, Known::list)->Arg(10)->Arg(25)->Arg(50);
BENCHMARK_CAPTURE(search, search, Known::nothing)->Arg(10)->Arg(25)->Arg(50);

/// 16 nearest nodes of each node, as a template stores them.
std::vector<std::uint32_t> stencils(const SurfaceNodes& nodes) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t k = 0; k < nodes.count; ++k) {
        std::vector<std::pair<double, std::uint32_t>> others;
        const auto& a = nodes.nodes[k];
        for (std::uint32_t m = 0; m < nodes.count; ++m) {
            const auto& b = nodes.nodes[m];
            if (m != k)
                others.emplace_back(square(a.x - b.x) + square(a.y - b.y) + square(a.z - b.z), m);
        }
        std::partial_sort(others.begin(), others.begin() + 16, others.end());
        for (int n = 0; n < 16; ++n) result.push_back(others[static_cast<std::size_t>(n)].second);
    }
    return result;
}

/// The deepest node by a walk over the stencils from last step's: a warm start, which finds
/// one node and proves nothing about the others.
void stencil_walk(benchmark::State& state) {
    const SrShape& shape = candy(2000);
    const std::vector<std::uint32_t> neighbors = stencils(shape.nodes);
    std::vector<Pair> pairs = pairs_at(-3e-5, shape);
    std::vector<SrField> fields;
    std::vector<std::uint32_t> start;
    for (const Pair& p : pairs) {
        fields.push_back(field_of(shape, p.state));
        double nearest = 1.0;
        std::uint32_t best = 0;
        for (std::uint32_t m = 0; m < shape.nodes.count; ++m) {
            const auto& n = shape.nodes.nodes[m];
            const double d = fields.back().sample({n.x, n.y, n.z}).distance;
            if (d < nearest) {
                nearest = d;
                best = m;
            }
        }
        start.push_back(best);
    }
    std::size_t k = 0;
    for (auto _ : state) {
        std::uint32_t node = start[k];
        const auto distance = [&](std::uint32_t m) {
            const auto& n = shape.nodes.nodes[m];
            return fields[k].sample({n.x, n.y, n.z}).distance;
        };
        double deepest = distance(node);
        for (bool moved = true; moved;) {
            moved = false;
            const std::uint32_t* around = neighbors.data() + std::size_t{16} * node;
            for (int n = 0; n < 16; ++n) {
                const double d = distance(around[n]);
                if (d < deepest) {
                    deepest = d;
                    node = around[n];
                    moved = true;
                }
            }
        }
        benchmark::DoNotOptimize(node);
        k = k + 1 == pairs.size() ? 0 : k + 1;
    }
}
BENCHMARK(stencil_walk);

}  // namespace
}  // namespace dem::runtime
