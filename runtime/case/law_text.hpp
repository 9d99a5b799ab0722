// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <string>

namespace dem::runtime {

/// The contact laws of a scene for a person: a line for every pair of materials that can meet.
std::string law_text(const Scene& scene);

}  // namespace dem::runtime
