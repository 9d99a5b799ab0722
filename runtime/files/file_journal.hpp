// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

/// The journal of a file (journaled_file.hpp): what its additions change of what was there before,
/// written down before it is changed.
namespace dem::runtime {

inline constexpr std::uint64_t page_bytes = 512;
using Page = std::array<std::byte, page_bytes>;

/// A page of the old part of a file; bytes behind the end of the file are zero.
struct PageChange {
    std::uint64_t number = 0;  ///< the page begins at number * page_bytes
    Page before, after;
};

/// By what the file of a journal is known.
struct FileIdentity {
    std::uint64_t boot = 0;  ///< boot_id of the time
    std::uint64_t device = 0, inode = 0;
    bool operator==(const FileIdentity&) const = default;
};

/// One addition to a file, or nothing but the point from which additions are recorded.
struct FileChange {
    bool is_beginning = false;
    FileIdentity file;
    std::uint64_t size_before = 0;  ///< [bytes]
    std::uint64_t size_after = 0;   ///< [bytes]
    std::uint64_t new_hash = 0;     ///< of the whole pages behind size_before
    std::vector<PageChange> pages;
};

/// Changes one behind another in a file of its own, each with a checksum. Nothing that is in it is
/// ever written over, so that a power cut can only lose its end. Throws Error.
class FileJournal {
  public:
    explicit FileJournal(std::filesystem::path path) : path_(std::move(path)) {}
    ~FileJournal();
    FileJournal(const FileJournal&) = delete;
    FileJournal& operator=(const FileJournal&) = delete;

    /// The changes that are there as a whole, from the last beginning on; none when there is no
    /// file.
    std::vector<FileChange> read() const;

    /// Adds a change, or throws and leaves the file as it was. It survives the end of the process.
    void append(const FileChange& change);

    /// Lets the disk take what was appended, if it has not yet.
    void sync();

    std::uint64_t size() const { return size_; }  ///< [bytes]

    /// Forgets what was appended since the journal had this size.
    void cut_back(std::uint64_t size);

    /// Makes this beginning all that there is.
    void replace(const FileChange& beginning);

    /// Removes the file.
    void remove();

  private:
    void open(int flags);
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    bool is_synced_ = false;
};

}  // namespace dem::runtime
