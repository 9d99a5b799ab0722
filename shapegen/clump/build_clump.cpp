// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/build_clump.hpp"

#include "common/error.hpp"
#include "common/shapes/clump.hpp"
#include "shapegen/clump/candidate_pool.hpp"
#include "shapegen/clump/fit.hpp"
#include "shapegen/voxel/voxelize.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace dem {
namespace {

template <class... Values>
[[noreturn]] void fail(const char* pattern, Values... values) {
    std::array<char, 300> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    throw Error("clump", text.data());
}

}  // namespace

class ClumpMaker::Impl {
  public:
    Impl(TriangleMesh mesh, const MassProperties& properties, const ClumpOptions& options)
        : options_(options),
          properties_(properties),
          d_eq_(equivalent_diameter(properties.volume)),
          surface_(std::move(mesh)),
          cells_(voxelize(surface_.mesh(),
                          voxel_spacing(properties.volume, options.cells_per_diameter))),
          pool_(surface_, properties.volume, cells_,
                {options.per_diameter, options.skeleton, options.min_radius * d_eq_}) {
        if (pool_.balls().empty()) pool_.extend();
        if (pool_.balls().empty())
            fail(
                "found no room for a sphere, expected a smaller --min-radius or a finer "
                "--resolution");
    }

    BuiltClump clump(const CoverGoal& goal);
    BuiltClump clump_within(double rms_deviation);

  private:
    std::vector<Ball> inscribed(const CoverGoal& goal);
    BuiltClump attempt(const CoverGoal& goal);
    [[noreturn]] void refuse(double coverage);
    void say(double done, std::string_view next) const {
        if (options_.progress) options_.progress(done, next);
    }

    ClumpOptions options_;
    MassProperties properties_;
    double d_eq_;
    SurfaceQuery surface_;
    VoxelImage cells_;
    CandidatePool pool_;
};

/// The chosen candidates; more candidates are made where these are all but used up.
std::vector<Ball> ClumpMaker::Impl::inscribed(const CoverGoal& goal) {
    while (true) {
        CellCover cover(cells_);
        const std::vector<std::uint32_t> chosen =
            choose_cover(pool_.balls(), goal, options_.sweeps, cover);
        if (goal.coverage >= 1.0 && !pool_.has_room_for(cover.coverage()) && pool_.extend())
            continue;
        std::vector<Ball> balls;
        for (const std::uint32_t i : chosen) balls.push_back(pool_.balls()[i]);
        return balls;
    }
}

BuiltClump ClumpMaker::Impl::attempt(const CoverGoal& goal) {
    BuiltClump result;
    say(0.0, "choosing spheres");
    result.balls = inscribed(goal);
    result.ceiling = pool_.ceiling();
    if (!options_.is_inscribed) {
        say(0.7, "fitting");
        const std::size_t count = std::max<std::size_t>(20'000, 60 * result.balls.size());
        const auto samples = surface_samples(surface_.mesh(), count);
        fit(surface_, samples, {options_.protrusion * d_eq_, options_.min_radius * d_eq_, 40},
            result.balls);
    }
    say(0.9, "judging");
    result.quality = judge(surface_, properties_.volume, result.balls);
    return result;
}

BuiltClump ClumpMaker::Impl::clump(const CoverGoal& goal) {
    if (goal.coverage >= 1.0) return attempt(goal);
    while (!pool_.has_room_for(goal.coverage) && pool_.extend()) {
    }
    if (pool_.ceiling() < goal.coverage) refuse(goal.coverage);
    // Coverage is counted on other cells than the judge's, so the first try may fall short.
    CoverGoal inner = goal;
    for (int tries = 0; tries < 4; ++tries) {
        BuiltClump result = attempt(inner);
        const double missing = goal.coverage - result.quality.coverage;
        if (missing <= 0.0) return result;
        inner.coverage += 1.1 * missing;
        if (inner.coverage > pool_.ceiling()) break;
    }
    refuse(goal.coverage);
}

BuiltClump ClumpMaker::Impl::clump_within(double rms_deviation) {
    std::size_t too_few = 0;
    CoverGoal goal;
    goal.count = 1;
    BuiltClump best = clump(goal);
    while (best.quality.rms_deviation > rms_deviation) {
        const bool is_spent = best.balls.size() < goal.count;
        if (is_spent || goal.count >= Clump::most_spheres)
            fail(
                "found an RMS deviation of %.4g %% of d_eq with %zu spheres and no better one, "
                "expected %.4g %%: more voxels (--resolution) or smaller spheres may reach it",
                100.0 * best.quality.rms_deviation, best.balls.size(), 100.0 * rms_deviation);
        too_few = goal.count;
        goal.count = std::min(2 * goal.count, Clump::most_spheres);
        best = clump(goal);
    }
    // The last percent is not worth the time.
    while (best.balls.size() - too_few > std::max<std::size_t>(best.balls.size() / 100, 1)) {
        const double product = static_cast<double>(std::max<std::size_t>(too_few, 1)) *
                               static_cast<double>(best.balls.size());
        goal.count = std::clamp(static_cast<std::size_t>(std::sqrt(product)), too_few + 1,
                                best.balls.size() - 1);
        BuiltClump next = clump(goal);
        if (next.quality.rms_deviation <= rms_deviation) {
            best = std::move(next);
        } else {
            too_few = goal.count;
        }
    }
    return best;
}

void ClumpMaker::Impl::refuse(double coverage) {
    CellCover cover(cells_);
    std::vector<std::uint32_t> all;
    cover_greedily(pool_.balls(), CoverGoal{}, cover, all);
    fail(
        "found a coverage of %.6g asked for, expected at most %.4f: the best clump has %zu "
        "spheres; more voxels (--resolution) or smaller spheres may reach it",
        coverage, pool_.ceiling(), all.size());
}

ClumpMaker::ClumpMaker(TriangleMesh mesh, const MassProperties& properties,
                       const ClumpOptions& options)
    : impl_(std::make_unique<Impl>(std::move(mesh), properties, options)) {}
ClumpMaker::~ClumpMaker() = default;
ClumpMaker::ClumpMaker(ClumpMaker&&) noexcept = default;
ClumpMaker& ClumpMaker::operator=(ClumpMaker&&) noexcept = default;

BuiltClump ClumpMaker::clump(const CoverGoal& goal) {
    return impl_->clump(goal);
}

BuiltClump ClumpMaker::clump_within(double rms_deviation) {
    return impl_->clump_within(rms_deviation);
}

}  // namespace dem
