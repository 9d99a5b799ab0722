// SPDX-License-Identifier: BSD-3-Clause
// Why the journal is enough. It holds, for every addition since the last time that all was on the
// disk, the pages of the old part before and after, and a hash of what came behind the old end.
// - After a kill the system still has every write that was made: the journal is complete but for
//   its last record, whose addition has then not begun to change pages. Putting all pages back and
//   redoing the recorded additions gives the file after the last one.
// - After a power cut writes may be missing in any order. Pages that were on the disk were changed
//   only when the disk had their old content in the journal, so they can be put back. An addition
//   is redone only as far as its new part is there, which the hash says.
#include "runtime/files/journaled_file.hpp"

#include "common/boot_id.hpp"
#include "common/error.hpp"
#include "common/parts_hash.hpp"
#include "common/progress.hpp"
#include "common/stopwatch.hpp"
#include "runtime/files/whole_io.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dem::runtime {

namespace {

/// Waiting for the disk takes at most this part of the time.
constexpr double sync_share = 0.05;
/// From here on the journal is begun anew when everything is on the disk [bytes].
constexpr std::uint64_t largest_journal = std::uint64_t{1} << 20;

constexpr mode_t everybody = S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;

std::uint64_t whole_pages(std::uint64_t bytes) {
    return (bytes + page_bytes - 1) / page_bytes;
}

std::filesystem::path journal_path(const std::filesystem::path& path) {
    return path.string() + ".journal";
}

/// The hash of the whole pages that an addition put behind the old end; what a disk lost reads as
/// zero.
std::uint64_t hash_of_new_part(int descriptor, std::uint64_t size_before,
                               std::uint64_t size_after) {
    PartsHash hash;
    std::vector<std::byte> block(std::size_t{1} << 18);
    for (std::uint64_t at = whole_pages(size_before) * page_bytes; at < size_after;
         at += block.size()) {
        const auto part =
            std::span(block).first(std::min<std::uint64_t>(block.size(), size_after - at));
        if (read_whole(descriptor, at, part) != 0) return 0;
        hash.add(part);
    }
    return hash.value();
}

/// The part of a page that lies in a file of `size` bytes.
std::span<const std::byte> inside(const Page& page, std::uint64_t number, std::uint64_t size) {
    const std::uint64_t begin = number * page_bytes;
    return std::span(page).first(size > begin ? std::min(page_bytes, size - begin) : 0);
}

FileIdentity identity(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0) return {};
    return {boot_id(), status.st_dev, status.st_ino};
}

}  // namespace

JournaledFile::JournaledFile(const PendingFile& file)
    : path_(file.final_path()), journal_({}), has_journal_(false) {
    descriptor_ =
        open(file.temporary_path().c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, everybody);
    if (descriptor_ < 0) {
        throw Error(path_.string(), "cannot create: " + std::generic_category().message(errno) +
                                        ", expected a folder in which files can be made");
    }
}

JournaledFile::JournaledFile(const std::filesystem::path& path)
    : path_(path), journal_(journal_path(path)), has_journal_(true) {
    descriptor_ = open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor_ < 0) {
        throw Error(path_.string(), "cannot open: " + std::generic_category().message(errno));
    }
    try {
        recover();
        struct stat status {};
        if (fstat(descriptor_, &status) != 0) fail(errno);
        size_ = committed_ = secured_ = static_cast<std::uint64_t>(status.st_size);
        journal_.append(beginning());
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

JournaledFile::~JournaledFile() {
    discard();
    try {
        if (has_journal_ && !is_stuck_) {
            secure();
            journal_.remove();
        }
    } catch (const Error&) {  // the journal stays and the next one that opens the file heeds it
    }
    close(descriptor_);
}

void JournaledFile::forget(const std::filesystem::path& path) {
    FileJournal(journal_path(path)).remove();
}

void JournaledFile::fail(int error) const {
    throw Error(path_.string(), "cannot write: " + std::generic_category().message(error));
}

void JournaledFile::read(std::uint64_t offset, std::span<std::byte> bytes) {
    const int error = read_whole(descriptor_, offset, bytes);
    if (error_ == 0) error_ = error;
    const std::uint64_t end = offset + bytes.size();
    for (auto page = pages_.lower_bound(offset / page_bytes);
         page != pages_.end() && page->first * page_bytes < end; ++page) {
        const std::uint64_t begin = page->first * page_bytes;
        const std::uint64_t from = std::max(begin, offset);
        const std::uint64_t to = std::min(begin + page_bytes, end);
        std::copy_n(page->second.data() + (from - begin), to - from,
                    bytes.data() + (from - offset));
    }
}

void JournaledFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    const std::uint64_t new_part = whole_pages(committed_) * page_bytes;
    if (offset < new_part) {
        const auto old = bytes.first(std::min<std::uint64_t>(bytes.size(), new_part - offset));
        hold(offset, old);
        offset += old.size();
        bytes = bytes.subspan(old.size());
    }
    if (error_ == 0) error_ = write_whole(descriptor_, offset, bytes);
    // The writer reads back what it wrote and must not be confused before it hears of the error.
    if (error_ != 0) hold(offset, bytes);
}

void JournaledFile::hold(std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const std::uint64_t number = offset / page_bytes;
        const std::uint64_t begin = number * page_bytes;
        const auto [page, is_new] = pages_.try_emplace(number);
        if (is_new) {
            const int error = read_whole(descriptor_, begin, page->second);
            if (error_ == 0) error_ = error;
        }
        const std::size_t count =
            std::min<std::uint64_t>(bytes.size(), begin + page_bytes - offset);
        std::copy_n(bytes.data(), count, page->second.data() + (offset - begin));
        offset += count;
        bytes = bytes.subspan(count);
    }
}

// No change, but a page that others which may be put in the place of this file have not.
FileChange JournaledFile::beginning() const {
    PageChange first{0, {}, {}};
    if (const int error = read_whole(descriptor_, 0, first.before); error != 0) fail(error);
    first.after = first.before;
    return {true, identity(descriptor_), committed_, committed_, PartsHash().value(), {first}};
}

FileChange JournaledFile::change() const {
    FileChange change{
        false, {}, committed_, size_, hash_of_new_part(descriptor_, committed_, size_), {}};
    for (const auto& [number, page] : pages_) {
        const auto wanted = inside(page, number, size_);
        if (wanted.empty()) continue;
        PageChange both{number, {}, {}};
        const int error = read_whole(descriptor_, number * page_bytes, both.before);
        if (error != 0) fail(error);
        std::copy(wanted.begin(), wanted.end(), both.after.begin());
        if (both.before != both.after) change.pages.push_back(both);
    }
    return change;
}

void JournaledFile::record(const FileChange& change) {
    journal_.append(change);
    bool is_safe = true;
    for (const PageChange& page : change.pages) {
        if (page.number * page_bytes >= secured_) continue;
        is_safe = !safe_pages_.insert(page.number).second && is_safe;
    }
    if (is_safe) return;
    const Stopwatch watch(sync_time_);
    journal_.sync();
}

void JournaledFile::apply(const FileChange& change) {
    for (const PageChange& page : change.pages) {
        const int error = write_whole(descriptor_, page.number * page_bytes,
                                      inside(page.after, page.number, change.size_after));
        if (error == 0) continue;
        for (const PageChange& back : change.pages) {
            if (write_whole(descriptor_, back.number * page_bytes,
                            inside(back.before, back.number, change.size_before)) != 0) {
                is_stuck_ = true;
            }
        }
        fail(error);
    }
}

void JournaledFile::cut(std::uint64_t size) {
    if (ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail(errno);
}

void JournaledFile::check_place() {
    struct stat here {};
    struct stat there {};
    if (fstat(descriptor_, &here) != 0 || stat(path_.c_str(), &there) != 0 ||
        here.st_ino != there.st_ino || here.st_dev != there.st_dev) {
        throw Error(path_.string(),
                    "was removed or replaced by another file while a run was writing it");
    }
}

void JournaledFile::commit() {
    if (is_stuck_) fail(EIO);
    const std::uint64_t journal_size = journal_.size();
    try {
        if (error_ != 0) fail(error_);
        if (has_journal_) {
            check_place();
            const FileChange addition = change();
            record(addition);
            apply(addition);
        }
        // The last bytes may be a hole that HDF5 has not written.
        if (size_ > committed_) cut(size_);
    } catch (...) {
        if (!is_stuck_) journal_.cut_back(journal_size);
        safe_pages_.clear();
        discard();
        throw;
    }
    const bool has_shrunk = size_ < committed_;
    committed_ = size_;
    pages_.clear();
    if (!has_journal_) return;
    if (has_shrunk || Progress::steady_seconds() >= affordable_at_) secure();
    if (has_shrunk) {
        // Before this the journal, as the disk has it, may need what lies behind the end.
        journal_.sync();
        cut(committed_);
    }
}

void JournaledFile::discard() {
    pages_.clear();
    error_ = 0;
    size_ = committed_;
    // What cannot be cut off stays behind the end, where it does no harm.
    if (!is_stuck_) {
        [[maybe_unused]] const int ignored = ftruncate(descriptor_, static_cast<off_t>(committed_));
    }
}

void JournaledFile::secure() {
    if (!has_journal_) return;
    {
        const Stopwatch watch(sync_time_);
        // The journal may outlive what it is about, and must then tell it to the end.
        journal_.sync();
        if (fsync(descriptor_) != 0) fail(errno);
    }
    affordable_at_ = Progress::steady_seconds() + sync_time_ * (1.0 / sync_share - 1.0);
    sync_time_ = 0.0;
    if (journal_.size() < largest_journal) {
        journal_.append(beginning());
    } else {
        journal_.replace(beginning());
    }
    secured_ = committed_;
    safe_pages_.clear();
}

// While the machine runs, nothing that was written is lost, and every page is as one of the changes
// says. After a power cut records may be missing, and the file must be the same one.
bool JournaledFile::belongs_here(const std::vector<FileChange>& changes) const {
    const FileIdentity now = identity(descriptor_);
    const FileIdentity then = changes.front().file;
    if (now.boot != then.boot) return now.device == then.device && now.inode == then.inode;
    std::map<std::uint64_t, std::vector<const Page*>> versions;
    for (const FileChange& change : changes) {
        for (const PageChange& page : change.pages) {
            versions[page.number].insert(versions[page.number].end(), {&page.before, &page.after});
        }
    }
    for (const auto& [number, pages] : versions) {
        Page found;
        if (read_whole(descriptor_, number * page_bytes, found) != 0) return false;
        for (std::size_t k = 0; k < page_bytes; ++k) {
            if (std::ranges::none_of(pages, [&](const Page* p) { return (*p)[k] == found[k]; })) {
                return false;
            }
        }
    }
    return true;
}

void JournaledFile::recover() {
    const std::vector<FileChange> changes = journal_.read();
    // A file that somebody has put in the place of the journal's is none of its business.
    if (!changes.empty() && belongs_here(changes)) {
        const auto write = [&](const PageChange& page, const Page& content) {
            const int error = write_whole(descriptor_, page.number * page_bytes, content);
            if (error != 0) fail(error);
        };
        for (std::size_t k = changes.size(); k-- > 0;) {
            for (const PageChange& page : changes[k].pages) write(page, page.before);
        }
        std::uint64_t size = changes.front().size_before;
        for (const FileChange& change : changes) {
            if (change.size_before != size ||
                hash_of_new_part(descriptor_, size, change.size_after) != change.new_hash) {
                break;
            }
            for (const PageChange& page : change.pages) write(page, page.after);
            size = change.size_after;
        }
        cut(size);
        if (fsync(descriptor_) != 0) fail(errno);
    }
    journal_.remove();
}

}  // namespace dem::runtime
