// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/file_hash.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace dem {

/// The hash of parts one after another, each by file_hash(): for what does not lie in memory as a
/// whole. Where the parts end counts.
class PartsHash {
  public:
    void add(std::span<const std::byte> part) {
        const std::array<std::uint64_t, 2> both = {value_, file_hash(part)};
        value_ = file_hash(std::as_bytes(std::span(both)));
    }
    void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0;
};

}  // namespace dem
