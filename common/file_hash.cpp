// SPDX-License-Identifier: BSD-3-Clause
#include "common/file_hash.hpp"

// Compiled in: no program has to find a library for one function.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace dem {

std::uint64_t file_hash(std::span<const std::byte> content) {
    return XXH3_64bits(content.data(), content.size());
}

std::uint64_t file_hash(std::string_view content) {
    return file_hash(std::as_bytes(std::span(content)));
}

}  // namespace dem
