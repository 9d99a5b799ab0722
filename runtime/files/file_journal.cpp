// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/file_journal.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "runtime/files/whole_io.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dem::runtime {

namespace {

constexpr std::uint64_t record_mark = 0x324c4e524a4d4544ULL;  // "DEMJRNL2"

/// Before the body of a record; all numbers are in the byte order of the machine.
struct RecordHead {
    std::uint64_t mark, body_bytes, body_hash;
};
struct ChangeHead {
    std::uint64_t is_beginning;
    FileIdentity file;
    std::uint64_t size_before, size_after, new_hash, pages;
};

template <class T>
void put(std::vector<std::byte>& bytes, const T& value) {
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(T));
}

/// The next value of a range; the caller has checked that it is there.
template <class T>
T take(std::span<const std::byte>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    bytes = bytes.subspan(sizeof(T));
    return value;
}

std::vector<std::byte> encode(const FileChange& change) {
    std::vector<std::byte> body;
    body.reserve(sizeof(ChangeHead) + change.pages.size() * sizeof(PageChange));
    put(body, ChangeHead{change.is_beginning ? 1U : 0U, change.file, change.size_before,
                         change.size_after, change.new_hash, change.pages.size()});
    for (const PageChange& page : change.pages) {
        put(body, page.number);
        put(body, page.before);
        put(body, page.after);
    }
    std::vector<std::byte> record;
    put(record, RecordHead{record_mark, body.size(), file_hash(body)});
    record.insert(record.end(), body.begin(), body.end());
    return record;
}

FileChange decode(std::span<const std::byte> body) {
    const auto head = take<ChangeHead>(body);
    FileChange change{head.is_beginning != 0, head.file,     head.size_before,
                      head.size_after,        head.new_hash, {}};
    change.pages.resize(head.pages);
    for (PageChange& page : change.pages) {
        page.number = take<std::uint64_t>(body);
        page.before = take<Page>(body);
        page.after = take<Page>(body);
    }
    return change;
}

/// A file is found after a power cut only where the disk has its folder.
void sync_folder(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path().empty() ? "." : file.parent_path();
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    [[maybe_unused]] const int ignored = fsync(descriptor);  // some disks cannot
    close(descriptor);
}

}  // namespace

FileJournal::~FileJournal() {
    if (descriptor_ >= 0) close(descriptor_);
}

void FileJournal::fail(int error) const {
    throw Error(path_.string(), "cannot write: " + std::generic_category().message(error));
}

std::vector<FileChange> FileJournal::read() const {
    std::ifstream in(path_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::span<const std::byte> rest = std::as_bytes(std::span(text));
    std::vector<FileChange> changes;
    while (rest.size() >= sizeof(RecordHead)) {
        const auto head = take<RecordHead>(rest);
        if (head.mark != record_mark || head.body_bytes > rest.size()) break;
        const auto body = rest.first(head.body_bytes);
        if (file_hash(body) != head.body_hash) break;
        FileChange change = decode(body);
        if (change.is_beginning) changes.clear();
        changes.push_back(std::move(change));
        rest = rest.subspan(head.body_bytes);
    }
    return changes;
}

void FileJournal::open(int flags) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | flags,
                         S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
    if (descriptor_ < 0) fail(errno);
    sync_folder(path_);
}

void FileJournal::append(const FileChange& change) {
    if (descriptor_ < 0) open(O_CREAT | O_TRUNC);
    is_synced_ = false;
    const std::vector<std::byte> record = encode(change);
    if (const int error = write_whole(descriptor_, size_, record); error != 0) {
        cut_back(size_);
        fail(error);
    }
    size_ += record.size();
}

void FileJournal::replace(const FileChange& beginning) {
    const std::vector<std::byte> record = encode(beginning);
    AtomicFile file(path_);
    file.write(record);
    file.commit();
    close(std::exchange(descriptor_, -1));
    open(0);
    size_ = record.size();
}

void FileJournal::sync() {
    if (descriptor_ < 0 || is_synced_) return;
    if (fsync(descriptor_) != 0) fail(errno);
    is_synced_ = true;
}

void FileJournal::cut_back(std::uint64_t size) {
    // A record that is cut off in its middle is not read, so what cannot be cut off may stay.
    if (descriptor_ >= 0) {
        [[maybe_unused]] const int ignored = ftruncate(descriptor_, static_cast<off_t>(size));
    }
    size_ = size;
}

void FileJournal::remove() {
    if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
    std::error_code error;
    std::filesystem::remove(path_, error);
    if (error) throw Error(path_.string(), "cannot remove: " + error.message());
}

}  // namespace dem::runtime
