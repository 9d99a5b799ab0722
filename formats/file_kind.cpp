// SPDX-License-Identifier: BSD-3-Clause
#include "formats/file_kind.hpp"

#include <system_error>

namespace dem {

std::string no_file_at(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::error_code ignored;
    switch (fs::status(path, error).type()) {
        case fs::file_type::regular:
            return "";
        case fs::file_type::directory:
            return "is a folder";
        case fs::file_type::fifo:
            return "is a pipe";
        case fs::file_type::socket:
            return "is a socket";
        case fs::file_type::character:
        case fs::file_type::block:
            return "is a device";
        case fs::file_type::not_found:
            return fs::is_symlink(fs::symlink_status(path, ignored)) ? "is a link to nothing"
                                                                     : "no such file";
        default:
            if (error == std::errc::too_many_symbolic_link_levels) return "is a link to itself";
            return "cannot be read: " + error.message();
    }
}

}  // namespace dem
