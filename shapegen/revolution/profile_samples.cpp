// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/revolution/profile_samples.hpp"

#include <algorithm>
#include <cmath>

namespace dem::shapegen {

namespace {

constexpr int most_halvings = 30;

ProfileSample sample(const ProfileSegment& segment, std::size_t index, double t) {
    const CurveJet jet = evaluate(segment, t);
    const double speed = jet.first.norm();
    const double turning = jet.first[0] * jet.second[1] - jet.first[1] * jet.second[0];
    return {index, t, jet.point, 0.0, speed > 0.0 ? std::abs(turning) / cube(speed) : 0.0};
}

/// Appends the samples of (from, to], halving by the parameter until the chords are short: a free
/// curve may run through its parameter at any speed.
void append(std::vector<ProfileSample>& samples, const ProfileSegment& segment,
            const ProfileSample& from, const ProfileSample& to, double step, int halvings) {
    if ((to.point - from.point).norm() > step && halvings > 0) {
        const ProfileSample middle = sample(segment, from.segment, 0.5 * (from.t + to.t));
        append(samples, segment, from, middle, step, halvings - 1);
        append(samples, segment, middle, to, step, halvings - 1);
    } else {
        samples.push_back(to);
    }
}

/// Largest distance from the origin between two parameters a short chord apart: golden section.
double largest_norm(const ProfileSegment& segment, double low, double high) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    const auto norm = [&](double t) { return evaluate(segment, t).point.norm(); };
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double at_a = norm(a);
    double at_b = norm(b);
    for (int i = 0; i < 60; ++i) {
        if (at_a < at_b) {
            low = a;
            a = b;
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = norm(b);
        } else {
            high = b;
            b = a;
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = norm(a);
        }
    }
    return std::max(at_a, at_b);
}

}  // namespace

std::vector<ProfileSample> sample_profile(const Profile& profile, double step) {
    std::vector<ProfileSample> samples;
    const auto segments = profile.segments();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const int parts = std::holds_alternative<LineSegment>(segments[i]) ? 1 : 8;
        samples.push_back(sample(segments[i], i, 0.0));
        for (int part = 1; part <= parts; ++part) {
            const ProfileSample from = samples.back();
            const ProfileSample to = sample(segments[i], i, static_cast<double>(part) / parts);
            append(samples, segments[i], from, to, step, most_halvings);
        }
    }
    for (std::size_t i = 1; i < samples.size(); ++i) {
        samples[i].arc_length =
            samples[i - 1].arc_length + (samples[i].point - samples[i - 1].point).norm();
    }
    return samples;
}

double farthest_distance(const Profile& profile) {
    const auto samples = sample_profile(profile, profile.major_axis_length() / 1000.0);
    double farthest = 0.0;
    for (const ProfileSample& s : samples) farthest = std::max(farthest, s.point.norm());
    double refined = farthest;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const ProfileSample& from = samples[i - 1];
        const ProfileSample& to = samples[i];
        // A summit between two samples rises above them by less than half their distance.
        const double rise = 0.5 * (to.point - from.point).norm();
        if (from.segment == to.segment &&
            std::max(from.point.norm(), to.point.norm()) + rise >= farthest) {
            refined = std::max(refined, largest_norm(profile.segments()[to.segment], from.t, to.t));
        }
    }
    return refined;
}

}  // namespace dem::shapegen
