// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/profile/profile.hpp"
#include "shapegen/revolution/rings.hpp"

#include <cstdint>
#include <vector>

namespace dem::shapegen {

/// Rings of exactly `count` surface nodes, bottom pole to top pole, evenly spread by area and
/// denser where the surface turns sharply. Every ring lies exactly on the profile; both poles are
/// nodes and a ring lies on every corner.
///
/// With the spacing h of the even part, rings are h apart along the profile, at most 20 degrees of
/// turning apart but not below h/4, and h/2 beside a corner; the spacing grows by at most h/2 per h
/// of the way. Around a ring the nodes are as far apart as the rings, but not below h/2.
///
/// Throws Error when `count` is too small for the corners of the profile.
std::vector<Ring> node_rings(const Profile& profile, std::uint32_t count);

}  // namespace dem::shapegen
