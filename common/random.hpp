// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/elementary.hpp"
#include "common/math/types.hpp"

#include <cmath>
#include <cstdint>

namespace dem {

/// Random numbers that depend only on (seed, stream, position), never on who asked before: particle
/// 17 of a group draws the same numbers however the work is split. SplitMix64 (Steele et al. 2014).
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t stream) : state_(mix(mix(seed) ^ (stream * golden))) {}

    /// Uniform in [0, 1) with 53 random bits.
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform on the unit sphere.
    Vec3 direction() {
        const double z = uniform(-1.0, 1.0);
        const double phi = uniform(0.0, 2.0 * pi);
        const double r = std::sqrt(1.0 - z * z);
        const auto [sine, cosine] = math::sin_cos(phi);
        return {r * cosine, r * sine, z};
    }

    /// Uniform over all rotations (Shoemake 1992).
    Quat orientation() {
        const double u = uniform();
        const double a = uniform(0.0, 2.0 * pi);
        const double b = uniform(0.0, 2.0 * pi);
        const double s = std::sqrt(1.0 - u);
        const double t = std::sqrt(u);
        const math::SineCosine of_a = math::sin_cos(a);
        const math::SineCosine of_b = math::sin_cos(b);
        return {t * of_b.cosine, s * of_a.sine, s * of_a.cosine, t * of_b.sine};
    }

    std::uint64_t next() {
        state_ += golden;
        return mix(state_);
    }

  private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
        return x ^ (x >> 31);
    }
    std::uint64_t state_;
};

}  // namespace dem
