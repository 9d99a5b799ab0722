// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/shapes/particle_template.hpp"
#include "shapegen/profile/profile.hpp"
#include "shapegen/revolution/sdf.hpp"

#include <cstdint>
#include <string>

namespace dem::shapegen {

inline constexpr std::uint32_t fewest_nodes = 100;
inline constexpr std::uint32_t most_nodes = 1'000'000;

struct CookOptions {
    enum class Kind { sr, sphere };
    Kind kind = Kind::sr;
    std::uint32_t nodes = 2000;
    SdfResolution resolution;
};

/// Everything `demrun` needs to know about a profile revolved around its axis, with the error it
/// makes. Throws Error when it cannot be represented as asked.
ParticleTemplate cook(const Profile& profile, const std::string& name, const CookOptions& options);

}  // namespace dem::shapegen
