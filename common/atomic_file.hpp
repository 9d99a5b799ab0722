// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

/// Files that appear whole or not at all: written beside under a temporary name, then renamed.
namespace dem {

/// The temporary name of a file that another library writes (HDF5, for one). Removed by the
/// destructor unless committed.
class PendingFile {
  public:
    explicit PendingFile(std::filesystem::path final_path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where to write: in the folder of the final path, so that the rename stays on one disk.
    const std::filesystem::path& temporary_path() const { return temporary_; }
    const std::filesystem::path& final_path() const { return final_; }

    /// Writes the closed temporary file through to the disk and gives it its final name, replacing
    /// what was there. Throws Error.
    void commit();

  private:
    std::filesystem::path final_;
    std::filesystem::path temporary_;
    bool is_committed_ = false;
};

/// Removes all that this process has begun to write and not committed. For the way out of a program
/// that is told to end: nothing may be written afterwards.
void remove_pending_files();

/// A buffered output file, every write of which is checked. Throws Error naming the file and the
/// system's reason (no such folder, permission denied, no space left on device, ...).
class AtomicFile {
  public:
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);

    /// Flushes, closes and renames; nothing may be written afterwards.
    void commit();

  private:
    void flush();

    PendingFile pending_;
    int descriptor_ = -1;
    std::string buffer_;
};

/// The whole content at once.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace dem
