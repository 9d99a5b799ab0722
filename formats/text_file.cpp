// SPDX-License-Identifier: BSD-3-Clause
#include "formats/text_file.hpp"

#include "common/error.hpp"

#include <filesystem>
#include <fstream>

namespace dem {

std::string read_text_file(const std::string& path, const std::string& kind, std::size_t most_mb) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw Error(path, "no such file, expected a " + kind);
    if (std::filesystem::is_directory(status)) throw Error(path, "is a folder, expected a " + kind);
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw Error(path, "cannot be read, expected a " + kind);
    std::string bytes;
    bytes.resize(1U << 16U);
    std::size_t size = 0;
    while (stream.read(bytes.data() + size, static_cast<std::streamsize>(bytes.size() - size)) ||
           stream.gcount() > 0) {
        size += static_cast<std::size_t>(stream.gcount());
        if (size > most_mb << 20U)
            throw Error(path,
                        "more than " + std::to_string(most_mb) + " MB found, expected a " + kind);
        if (size == bytes.size()) bytes.resize(2 * bytes.size());
    }
    if (stream.bad()) throw Error(path, "cannot be read to its end, expected a " + kind);
    bytes.resize(size);
    return bytes;
}

}  // namespace dem
