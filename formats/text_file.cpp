// SPDX-License-Identifier: BSD-3-Clause
#include "formats/text_file.hpp"

#include "common/error.hpp"
#include "formats/file_kind.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace dem {

namespace {

/// A file, pipe or device open for reading. Without waiting: a pipe that nobody writes to would
/// never open.
class Source {
  public:
    explicit Source(const std::string& path)
        : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
    ~Source() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    bool is_open() const { return descriptor_ >= 0; }

    /// Bytes read, once there are some; 0 at the end, negative for an error.
    ssize_t read_some(char* to, std::size_t most) const {
        for (;;) {
            const ssize_t size = ::read(descriptor_, to, most);
            if (size >= 0 || (errno != EAGAIN && errno != EINTR)) return size;
            pollfd writer{descriptor_, POLLIN, 0};
            poll(&writer, 1, -1);
        }
    }

  private:
    int descriptor_;
};

}  // namespace

std::string read_text_file(const std::string& path, const std::string& kind, std::size_t most_mb) {
    const std::string found = no_file_at(path);
    const bool may_flow = found == "is a pipe" || found == "is a device";
    if (!found.empty() && !may_flow) throw Error(path, found + ", expected a " + kind);
    const Source source(path);
    if (!source.is_open()) {
        throw Error(path, "cannot be read: " + std::generic_category().message(errno) +
                              ", expected a " + kind);
    }
    std::string bytes;
    bytes.resize(1U << 16U);
    std::size_t size = 0;
    ssize_t more = 0;
    while ((more = source.read_some(bytes.data() + size, bytes.size() - size)) > 0) {
        size += static_cast<std::size_t>(more);
        if (size > most_mb << 20U)
            throw Error(path,
                        "found more than " + std::to_string(most_mb) + " MB, expected a " + kind);
        if (size == bytes.size()) bytes.resize(2 * bytes.size());
    }
    if (more < 0) throw Error(path, "cannot be read to its end, expected a " + kind);
    if (size == 0 && may_flow)
        throw Error(path, found + " that nothing comes out of, expected a " + kind);
    bytes.resize(size);
    return bytes;
}

}  // namespace dem
