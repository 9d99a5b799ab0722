// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/plain_values.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace dem::runtime {

/// The state of a run as named arrays. What they mean is the business of the runtime.
using Checkpoint = std::map<std::string, PlainValues>;

/// Writes a checkpoint, whole or not at all: an HDF5 file of opaque tables, with a checksum behind
/// it. Throws Error, on a full disk before an earlier checkpoint is touched.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Reads it back. Throws Error for a file that is missing, not a checkpoint, cut short, changed by
/// a single byte or of another layout.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace dem::runtime
