// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/build_clump.hpp"

#include "common/error.hpp"
#include "common/shapes/clump.hpp"
#include "shapegen/clump/candidate_pool.hpp"
#include "shapegen/clump/fit.hpp"
#include "shapegen/clump/match_volume.hpp"
#include "shapegen/voxel/voxelize.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace dem::shapegen {
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
    BuiltClump finished(const CoverSearch& search);
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

/// The chosen candidates, fitted unless that is left out, and judged.
BuiltClump ClumpMaker::Impl::finished(const CoverSearch& search) {
    BuiltClump result;
    for (const std::uint32_t i : search.chosen()) result.balls.push_back(pool_.balls()[i]);
    result.ceiling = pool_.ceiling();
    if (!options_.is_inscribed) {
        say(0.7, "fitting");
        const std::size_t count = std::max<std::size_t>(20'000, 45 * result.balls.size());
        const auto samples = surface_samples(surface_.mesh(), count);
        const FitOptions fitting{options_.protrusion * d_eq_, options_.min_radius * d_eq_, 40};
        fit(surface_, samples, fitting, result.balls);
        match_volume(surface_, d_eq_, fitting, result.balls);
    }
    say(0.9, "judging");
    result.quality = judge(surface_, properties_.volume, result.balls);
    return result;
}

BuiltClump ClumpMaker::Impl::clump(const CoverGoal& goal) {
    const bool wants_coverage = goal.coverage < 1.0;
    say(0.0, "choosing spheres");
    while (wants_coverage && !pool_.has_room_for(goal.coverage) && pool_.extend()) {
    }
    CoverSearch search(cells_);
    CoverGoal inner = goal;
    for (;;) {
        if (wants_coverage && inner.coverage > pool_.ceiling()) {
            if (!pool_.extend()) refuse(goal.coverage);
            continue;
        }
        search.reach(pool_.balls(), inner, options_.sweeps);
        // Where the candidates are all but used up, more of them may do better.
        if (!wants_coverage && !pool_.has_room_for(search.coverage()) && pool_.extend()) continue;
        BuiltClump result = finished(search);
        const double missing = goal.coverage - result.quality.coverage;
        if (!wants_coverage || missing <= 0.0) return result;
        // Coverage was counted on other cells than the judge's.
        inner.coverage = std::max(inner.coverage, search.coverage()) + 1.03 * missing;
    }
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
    cover_greedily(pool_.balls(), CoverGoal{.count = Clump::most_spheres}, cover, all);
    const double ceiling = all.size() < Clump::most_spheres ? pool_.ceiling() : cover.coverage();
    fail(
        "found a coverage of %.12g asked for, expected at most %.4f: the best clump has %zu "
        "spheres; more voxels (--resolution) or smaller spheres may reach it",
        coverage, ceiling, all.size());
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

}  // namespace dem::shapegen
