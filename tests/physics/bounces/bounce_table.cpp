// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/bounces/bounce_table.hpp"

#include "common/threads/thread_team.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

namespace dem::test {

using namespace runtime;

namespace {

void add(const Bounce& b, BounceSummary& summary) {
    if (!b.touched) return;
    if (b.overlap > deepest_bounce) {
        ++summary.too_deep;
        return;
    }
    if (b.cores_met) {
        ++summary.cores_met;
        summary.worst_with_cores = std::max(summary.worst_with_cores, b.jump);
        return;
    }
    ++summary.count;
    summary.mean_change += b.change;
    summary.worst_change = std::max(summary.worst_change, b.change);
    summary.worst_jump = std::max(summary.worst_jump, b.jump);
    if (b.jump > 1e-3) ++summary.large;
    if (b.jump <= summary.worst.back().jump) return;
    summary.worst.back() = b;
    std::stable_sort(summary.worst.begin(), summary.worst.end(),
                     [](const Bounce& x, const Bounce& y) { return x.jump > y.jump; });
}

}  // namespace

BounceSummary bounces(const BounceSettings& settings, std::uint64_t first, std::uint64_t count) {
    std::vector<Bounce> all(count);
    share_each(count, 1, [&](std::size_t k) { all[k] = bounce(settings, first + k); });
    BounceSummary summary;
    for (const Bounce& b : all) add(b, summary);
    if (summary.count > 0) summary.mean_change /= static_cast<double>(summary.count);
    return summary;
}

void print_header() {
    std::printf(
        "i,j,model,divisor,bounces,too_deep,cores_met,worst_with_cores,mean_change,worst_change,"
        "worst_jump,"
        "jumps_above_1e-3,worst_seeds\n");
}

void print_row(const BounceSettings& settings, const BounceSummary& s) {
    std::printf("%s,%s,%s,%g,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%.2e,%.2e,%.2e,%.2e,%" PRIu64
                ",%" PRIu64 " %" PRIu64 " %" PRIu64 "\n",
                name(settings.i), name(settings.j),
                settings.model == ContactLaw::Model::linear ? "linear" : "hertz",
                settings.divisor.value_or(0.0), s.count, s.too_deep, s.cores_met,
                s.worst_with_cores, s.mean_change, s.worst_change, s.worst_jump, s.large,
                s.worst[0].seed, s.worst[1].seed, s.worst[2].seed);
    std::fflush(stdout);
}

}  // namespace dem::test
