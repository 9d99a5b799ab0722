// SPDX-License-Identifier: BSD-3-Clause
#include "common/atomic_file.hpp"

#include "common/error.hpp"

#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace dem {

namespace {

constexpr std::size_t buffer_limit = std::size_t{1} << 18;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& action, int error) {
    throw Error(path.string(), "cannot " + action + ": " + std::generic_category().message(error));
}

/// Unique among processes and among the files of this one, so that two writers never share one.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
    static std::atomic<unsigned> next = 0;
    return path.string() + ".part-" + std::to_string(getpid()) + "-" + std::to_string(next++);
}

/// The temporary names of files that are neither committed nor removed.
class Pending {
  public:
    static Pending& files() {
        static Pending one;
        return one;
    }
    void add(const std::filesystem::path& path) {
        const std::scoped_lock lock(mutex_);
        paths_.insert(path);
    }
    /// Calls end(), which renames or removes the file.
    template <class End>
    auto finish(const std::filesystem::path& path, const End& end) {
        const std::scoped_lock lock(mutex_);
        paths_.erase(path);
        return end();
    }
    void remove_all() {
        const std::scoped_lock lock(mutex_);
        for (const std::filesystem::path& path : paths_) unlink(path.c_str());
    }

  private:
    std::mutex mutex_;
    std::set<std::filesystem::path> paths_;
};

}  // namespace

void remove_pending_files() {
    Pending::files().remove_all();
}

PendingFile::PendingFile(std::filesystem::path final_path)
    : final_(std::move(final_path)), temporary_(temporary_name(final_)) {
    std::error_code ignored;
    const auto there = std::filesystem::status(final_, ignored);
    if (std::filesystem::is_directory(there)) {
        throw Error(final_.string(), "is a folder, expected the name of a file to write");
    }
    // Renaming over it would put a file in the place of the device.
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) {
        throw Error(final_.string(), "is a device or pipe, expected the name of a file to write");
    }
    Pending::files().add(temporary_);
}

PendingFile::~PendingFile() {
    if (!is_committed_)
        Pending::files().finish(temporary_, [&] { return unlink(temporary_.c_str()); });
}

void PendingFile::commit() {
    // Without this a power cut could leave the final name on an empty file, and a network disk
    // could report that it is full only after we said "done".
    const int descriptor = open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail(final_, "write", errno);
    const int synced = fsync(descriptor);
    const int sync_error = errno;
    const int closed = close(descriptor);
    if (synced != 0) fail(final_, "write", sync_error);
    if (closed != 0) fail(final_, "write", errno);
    const int renamed = Pending::files().finish(
        temporary_, [&] { return rename(temporary_.c_str(), final_.c_str()); });
    if (renamed != 0) fail(final_, "write", errno);
    is_committed_ = true;
}

AtomicFile::AtomicFile(const std::filesystem::path& path) : pending_(path) {
    descriptor_ = open(pending_.temporary_path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                       S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
    if (descriptor_ < 0) {
        throw Error(path.string(), "cannot create: " + std::generic_category().message(errno) +
                                       ", expected a folder in which files can be made");
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) close(descriptor_);
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void AtomicFile::write(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= buffer_limit) flush();
}

void AtomicFile::flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(pending_.final_path(), "write", errno);
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
    buffer_.clear();
}

void AtomicFile::commit() {
    flush();
    if (close(std::exchange(descriptor_, -1)) != 0) fail(pending_.final_path(), "write", errno);
    pending_.commit();
}

void write_file(const std::filesystem::path& path, std::string_view content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

}  // namespace dem
