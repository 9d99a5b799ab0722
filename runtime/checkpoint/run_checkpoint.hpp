// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/measure/at_rest.hpp"
#include "runtime/output/outputs.hpp"
#include "runtime/simulation.hpp"

#include <filesystem>

namespace dem::runtime {

/// Writes all that a run needs to go on as if it had never stopped. Throws Error.
void save_checkpoint(const std::filesystem::path& path, const Simulation& simulation,
                     const AtRest& at_rest, const OutputProgress& outputs);

/// Brings a simulation of the same scene, fresh from its constructor, to where the checkpoint was
/// made. Returns how far the outputs were. Throws Error for a file that is no sound checkpoint and
/// for one of another case, with the line that differs.
OutputProgress load_checkpoint(const std::filesystem::path& path, Simulation& simulation,
                               AtRest& at_rest);

}  // namespace dem::runtime
