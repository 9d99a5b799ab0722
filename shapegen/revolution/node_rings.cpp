// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/node_rings.hpp"

#include "common/error.hpp"
#include "shapegen/revolution/profile_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace dem::shapegen {

namespace {

constexpr double largest_turning = 20.0 * pi / 180.0;  // between rings [rad]
constexpr double smallest_spacing = 0.25;              // where the profile turns, in h
constexpr double corner_spacing = 0.5;                 // beside a corner, and around any ring, in h
constexpr double growth = 0.5;  // of the spacing per length along the profile
constexpr double fewest_around = 3.0;

using Samples = std::vector<ProfileSample>;

/// The profile between two corners (or poles): samples [first, last].
struct Run {
    std::size_t first, last;
};

std::vector<Run> runs_between_corners(const Profile& profile, const Samples& samples) {
    std::vector<bool> ends_at_corner(profile.segments().size(), false);
    for (const Profile::Corner& corner : profile.corners()) {
        if (corner.segment < ends_at_corner.size()) ends_at_corner[corner.segment] = true;
    }
    std::vector<Run> runs;
    std::size_t first = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const bool at_end = i + 1 == samples.size() || samples[i + 1].segment != samples[i].segment;
        if (at_end && (i + 1 == samples.size() || ends_at_corner[samples[i].segment])) {
            runs.push_back({first, i});
            first = i + 1;
        }
    }
    return runs;
}

/// Distance between rings along the profile at every sample, for the even spacing h.
std::vector<double> ring_spacing(const Samples& samples, const std::vector<Run>& runs, double h) {
    std::vector<double> spacing(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double turning = samples[i].meridional_turning * h;
        spacing[i] = turning > largest_turning
                         ? std::max(h * largest_turning / turning, smallest_spacing * h)
                         : h;
    }
    for (std::size_t i = 1; i < runs.size(); ++i) {  // the poles at the outer ends are no corners
        spacing[runs[i - 1].last] = std::min(spacing[runs[i - 1].last], corner_spacing * h);
        spacing[runs[i].first] = std::min(spacing[runs[i].first], corner_spacing * h);
    }
    const auto limit = [&](std::size_t i, std::size_t from) {
        const double way = std::abs(samples[i].arc_length - samples[from].arc_length);
        spacing[i] = std::min(spacing[i], spacing[from] + growth * way);
    };
    for (std::size_t i = 1; i < samples.size(); ++i) limit(i, i - 1);
    for (std::size_t i = samples.size() - 1; i > 0; --i) limit(i - 1, i);
    return spacing;
}

/// A ring with the number of nodes it would have if numbers could be broken.
struct IdealRing {
    Ring ring;
    double count;
};

IdealRing ideal_ring(const Profile& profile, const ProfileSample& at, double spacing, double h) {
    const Vec2 p = evaluate(profile.segments()[at.segment], at.t).point;
    const double around = std::max(spacing, corner_spacing * h);
    return {{p[0], p[1], at.segment, at.t, 0, 0.0},
            std::max(2.0 * pi * p[0] / around, fewest_around)};
}

/// The rings strictly inside a run: evenly spaced in the integral of ds / spacing.
void append_inner_rings(const Profile& profile, const Samples& samples,
                        const std::vector<double>& spacing, const Run& run, double h,
                        std::vector<IdealRing>& rings) {
    std::vector<double> steps(run.last - run.first + 1, 0.0);
    for (std::size_t i = run.first + 1; i <= run.last; ++i) {
        const double ds = samples[i].arc_length - samples[i - 1].arc_length;
        steps[i - run.first] = steps[i - run.first - 1] + 2.0 * ds / (spacing[i] + spacing[i - 1]);
    }
    const double intervals = std::max(1.0, std::round(steps.back()));
    for (int k = 1; k < static_cast<int>(intervals); ++k) {
        const double target = steps.back() * k / intervals;
        const auto above = std::lower_bound(steps.begin() + 1, steps.end() - 1, target);
        const std::size_t i = run.first + static_cast<std::size_t>(above - steps.begin());
        const double fraction = (target - *(above - 1)) / (*above - *(above - 1));
        ProfileSample at = samples[i];
        // A joint is a step of length zero between two segments: then the sample itself serves.
        if (samples[i - 1].segment == at.segment) {
            at.t = samples[i - 1].t + fraction * (at.t - samples[i - 1].t);
        }
        rings.push_back(
            ideal_ring(profile, at, spacing[i - 1] + fraction * (spacing[i] - spacing[i - 1]), h));
    }
}

std::vector<IdealRing> ideal_rings(const Profile& profile, const Samples& samples,
                                   const std::vector<Run>& runs, double h) {
    const std::vector<double> spacing = ring_spacing(samples, runs, h);
    std::vector<IdealRing> rings;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        append_inner_rings(profile, samples, spacing, runs[i], h, rings);
        if (i + 1 < runs.size()) {
            rings.push_back(ideal_ring(profile, samples[runs[i].last], corner_spacing * h, h));
        }
    }
    return rings;
}

double total(const std::vector<IdealRing>& rings) {
    return std::accumulate(rings.begin(), rings.end(), 0.0,
                           [](double sum, const IdealRing& ring) { return sum + ring.count; });
}

/// Whole numbers that sum to `nodes`, by the largest remainder. The ideal ones sum to at most that.
void share_out(std::vector<IdealRing>& rings, std::uint32_t nodes) {
    const double scale = nodes / total(rings);
    std::uint32_t left = nodes;
    for (IdealRing& ring : rings) {
        ring.count *= scale;
        ring.ring.count = static_cast<std::uint32_t>(ring.count);
        left -= ring.ring.count;
    }
    std::vector<std::size_t> order(rings.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rings[a].count - rings[a].ring.count > rings[b].count - rings[b].ring.count;
    });
    for (std::uint32_t i = 0; i < left; ++i) ++rings[order[i % order.size()]].ring.count;
}

/// The smallest spacing h whose rings need no more than `nodes` nodes.
std::vector<IdealRing> fitting_rings(const Profile& profile, std::uint32_t nodes) {
    const double l = profile.major_axis_length();
    const Samples samples =
        sample_profile(profile, std::min(l / 1000.0, 0.1 * l / std::sqrt(nodes)));
    const std::vector<Run> runs = runs_between_corners(profile, samples);
    double too_small = 0.1 * l / std::sqrt(nodes);
    double enough = 2.0 * l;
    if (total(ideal_rings(profile, samples, runs, enough)) > nodes) {
        throw Error(profile.label(0), "found " + std::to_string(runs.size() - 1) +
                                          " sharp edges, expected fewer than " +
                                          std::to_string(nodes + 2) +
                                          " nodes can follow: raise --nodes");
    }
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (too_small + enough);
        const bool fits = total(ideal_rings(profile, samples, runs, middle)) <= nodes;
        (fits ? enough : too_small) = middle;
    }
    return ideal_rings(profile, samples, runs, enough);
}

}  // namespace

std::vector<Ring> node_rings(const Profile& profile, std::uint32_t count) {
    std::vector<IdealRing> ideal = fitting_rings(profile, count - 2);
    share_out(ideal, count - 2);
    const std::size_t last = profile.segments().size() - 1;
    std::vector<Ring> rings{{0.0, profile.bottom_z(), 0, 0.0, 1, 0.0}};
    for (const IdealRing& ring : ideal) rings.push_back(ring.ring);
    rings.push_back({0.0, profile.top_z(), last, 1.0, 1, 0.0});
    stagger(rings);
    return rings;
}

}  // namespace dem::shapegen
