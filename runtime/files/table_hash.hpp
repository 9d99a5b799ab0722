// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/state_hash.hpp"
#include "runtime/files/file_journal.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace dem::runtime {

/// The hash of tables one after another, by which those that were damaged are found when a run is
/// resumed.
class TableHash {
  public:
    void add(std::span<const std::byte> table) {
        ContentHash hash;
        hash.add(table);
        const std::uint64_t value = hash.value();
        hash_.add(std::span(&value, 1));
    }
    void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
    std::uint64_t value() const { return hash_.value(); }

  private:
    StateHash hash_;
};

}  // namespace dem::runtime
