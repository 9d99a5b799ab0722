// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/profile/profile.hpp"

#include <vector>

namespace dem::shapegen {

/// A ball about a point of the axis of revolution [m].
struct AxialBall {
    double z, radius;
};

/// Balls whose union is a body of revolution, in the order of the profile; empty where none are.
struct BallChain {
    std::vector<AxialBall> balls;
    double max_deviation = 0.0;  ///< of the profile from the surface of the union [m]
};

/// The balls that a body of revolution is the union of: a sphere is one, a profile of several arcs
/// about points of the axis is a chain of them. That is so when every segment is an arc of a circle
/// about a point of the axis and no ball reaches out of the body: every point of the body lies at
/// the height of a point of some arc and nearer to the axis, and so in the ball of that arc. Points
/// of a file have six digits or more: what differs by a millionth of a radius counts as equal.
BallChain ball_chain(const Profile& profile);

}  // namespace dem::shapegen
