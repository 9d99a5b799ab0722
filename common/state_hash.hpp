// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace dem {

/// FNV-1a over bytes, 64 bits. Any single changed byte changes the hash.
class StateHash {
  public:
    void add_bytes(std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) {
            value_ = (value_ ^ static_cast<std::uint64_t>(b)) * 0x100000001b3ULL;
        }
    }
    /// The bytes of a padding-free trivially copyable range.
    template <class T>
    void add(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        add_bytes(std::as_bytes(values));
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace dem
