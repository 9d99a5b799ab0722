// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace dem {

/// XXH3, 64 bits, of the content of a file: as fast as memory is read. Bytes that were changed by
/// accident have another hash with a probability of 1 - 2^-64.
std::uint64_t file_hash(std::span<const std::byte> content);
std::uint64_t file_hash(std::string_view content);

}  // namespace dem
