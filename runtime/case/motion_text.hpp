// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <string>

namespace dem::runtime {

/// What moves and how: one line per motion, and one per wall whose surface moves.
std::string motion_text(const Scene& scene);

}  // namespace dem::runtime
