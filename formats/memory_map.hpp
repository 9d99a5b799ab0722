// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace dem {

/// A file mapped read-only into memory for as long as the object lives. Programs of this project
/// replace files by renaming, never in place, so a mapped file does not change underneath.
class MemoryMap {
  public:
    /// Throws Error naming the file: missing, a folder or pipe, not readable. `kind` names what was
    /// expected ("mesh").
    MemoryMap(const std::filesystem::path& path, const std::string& kind);
    ~MemoryMap();
    MemoryMap(const MemoryMap&) = delete;
    MemoryMap& operator=(const MemoryMap&) = delete;

    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::span<const std::byte> bytes_;
};

}  // namespace dem
