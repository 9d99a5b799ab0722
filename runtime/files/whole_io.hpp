// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Reading and writing at a place of an open file, however many calls of the system that takes.
namespace dem::runtime {

/// Writes all bytes. Returns 0 or the number of the error.
int write_whole(int descriptor, std::uint64_t offset, std::span<const std::byte> bytes);

/// Reads all bytes; those behind the end of the file are zero. Returns 0 or the number of the
/// error.
int read_whole(int descriptor, std::uint64_t offset, std::span<std::byte> bytes);

}  // namespace dem::runtime
