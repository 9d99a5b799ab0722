// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/atomic_file.hpp"
#include "runtime/files/file_journal.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>

namespace dem::runtime {

/// A file that grows by additions, each of which is in it as a whole or not at all, whatever ends
/// the process or the machine in between.
///
/// - What an addition writes behind the old end goes to the file at once. What it changes of the
///   old part is held back in memory until `commit`, which writes both the old and the new bytes
///   into a journal beside the file (PATH.journal), and then the new ones in place.
/// - A process that is killed leaves the old file with bytes behind its end, or the new one, or,
/// for
///   the microseconds in which a handful of pages is replaced, a mixture that the journal makes
///   whole when the file is opened again.
/// - Against a power cut the disk must have the journal before anything in place is changed, and
///   the additions before the journal forgets them. The latter can take longer than an addition, so
///   that it may be delayed: it never costs more than a twentieth of the time. A power cut takes
///   the file back to an addition that the disk has.
/// - The journal goes when the file is closed.
class JournaledFile {
  public:
    /// A new file, which is nobody's before its PendingFile is committed: without a journal.
    explicit JournaledFile(const PendingFile& file);

    /// Opens a file, after putting right what an earlier process left unfinished. Throws Error.
    explicit JournaledFile(const std::filesystem::path& path);

    ~JournaledFile();
    JournaledFile(const JournaledFile&) = delete;
    JournaledFile& operator=(const JournaledFile&) = delete;

    /// Removes the journal of a file that is about to be replaced. Throws Error.
    static void forget(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return path_; }

    // The file together with the present addition. What fails is told by `commit`.
    std::uint64_t size() const { return size_; }
    void read(std::uint64_t offset, std::span<std::byte> bytes);
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    void resize(std::uint64_t size) { size_ = size; }

    /// Makes the present addition a part of the file. Throws Error, and the file is then as before.
    void commit();

    /// Drops the present addition.
    void discard();

    /// Lets the disk take all that was committed. Throws Error.
    void secure();

  private:
    void recover();
    bool belongs_here(const std::vector<FileChange>& changes) const;
    void hold(std::uint64_t offset, std::span<const std::byte> bytes);
    FileChange beginning() const;
    FileChange change() const;
    void record(const FileChange& change);
    void apply(const FileChange& change);
    void cut(std::uint64_t size);
    void check_place();
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;  ///< for messages the final one
    FileJournal journal_;
    bool has_journal_;
    int descriptor_ = -1;
    std::uint64_t committed_ = 0;          ///< size after the last addition [bytes]
    std::uint64_t secured_ = 0;            ///< that much of it the disk certainly has [bytes]
    std::uint64_t size_ = 0;               ///< with the present addition [bytes]
    int error_ = 0;                        ///< the first of the present addition
    bool is_stuck_ = false;                ///< changed in part, which only the journal can mend
    std::map<std::uint64_t, Page> pages_;  ///< of the old part, as the addition wants them
    /// Pages of the secured part whose old content the disk has in the journal.
    std::set<std::uint64_t> safe_pages_;
    double sync_time_ = 0.0;      ///< spent on waiting for the disk since `secure` [s]
    double affordable_at_ = 0.0;  ///< when `secure` may be called again [s]
};

}  // namespace dem::runtime
