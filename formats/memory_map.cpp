// SPDX-License-Identifier: BSD-3-Clause
#include "formats/memory_map.hpp"

#include "common/error.hpp"
#include "formats/file_kind.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dem {

MemoryMap::MemoryMap(const std::filesystem::path& path, const std::string& kind) {
    const auto fail = [&](const std::string& found) {
        throw Error(path.string(), found + ", expected a " + kind);
    };
    if (const std::string found = no_file_at(path); !found.empty()) fail(found);
    const auto fail_to_read = [&](int error) {
        fail("cannot be read: " + std::generic_category().message(error));
    };
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) fail_to_read(errno);
    struct stat status {};
    const bool is_regular = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    const auto size = static_cast<std::size_t>(status.st_size);
    // mmap refuses a length of zero; an empty file is an empty span.
    void* start = nullptr;
    int map_error = 0;
    if (is_regular && size > 0) {
        start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
        if (start == MAP_FAILED) map_error = errno;
    }
    close(descriptor);
    if (!is_regular) fail("is no file any more");
    if (map_error != 0) fail_to_read(map_error);
    bytes_ = {static_cast<const std::byte*>(start), size};
}

MemoryMap::~MemoryMap() {
    if (!bytes_.empty()) {
        munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());  // NOLINT: unmaps, no write
    }
}

}  // namespace dem
