// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/folder_lock.hpp"

#include "common/error.hpp"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dem::runtime {

namespace {

/// Whether it was missing.
bool make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    const auto there = std::filesystem::status(folder, error);
    if (std::filesystem::exists(there) && !std::filesystem::is_directory(there)) {
        throw Error(folder.string(),
                    "is no folder, expected one for the results or a new name (--out)");
    }
    const bool made = std::filesystem::create_directories(folder, error);
    if (error) {
        throw Error(folder.string(), "cannot make the output folder: " + error.message() +
                                         ", expected another one (--out)");
    }
    return made;
}

bool holds_only(const std::filesystem::path& folder, const std::filesystem::path& file) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().filename() != file) return false;
    }
    return !error;
}

constexpr const char* lock_name = ".demrun.lock";

/// " (process 1234)" from the lock file, "" when it says nothing.
std::string owner(int descriptor) {
    std::array<char, 16> text{};
    const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
    return size > 0 ? " (process " + std::string(text.data(), static_cast<std::size_t>(size)) + ")"
                    : "";
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(folder), is_new_(make_folder(folder)) {
    const std::filesystem::path file = folder / lock_name;
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC,
                       S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
    if (descriptor_ < 0) {
        if (errno == EISDIR)
            throw Error(file.string(), "is a folder, expected the mark of a run or nothing");
        throw Error(folder.string(), "cannot write: " + std::generic_category().message(errno) +
                                         ", expected another folder (--out)");
    }
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        const std::string other = owner(descriptor_);
        close(descriptor_);
        throw Error(folder.string(), "another demrun" + other +
                                         " is writing here, expected a folder of its own (--out)");
    }
    // For the message above only: a run does not fail because its number cannot be noted.
    const std::string number = std::to_string(getpid());
    if (ftruncate(descriptor_, 0) == 0) {
        [[maybe_unused]] const ssize_t written =
            pwrite(descriptor_, number.data(), number.size(), 0);
    }
}

FolderLock::~FolderLock() {
    if (is_new_ && holds_only(folder_, lock_name)) {
        std::error_code ignored;
        std::filesystem::remove(folder_ / lock_name, ignored);
        std::filesystem::remove(folder_, ignored);
    }
    // Equal runs leave equal files, the number of their process among them.
    [[maybe_unused]] const int emptied = ftruncate(descriptor_, 0);
    close(descriptor_);
}

}  // namespace dem::runtime
