// SPDX-License-Identifier: BSD-3-Clause
#include "formats/text_file.hpp"

#include "common/error.hpp"
#include "formats/profile_text.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace dem {

namespace {
/// A million points of two numbers with 17 digits each take about 50 MB.
constexpr std::uintmax_t largest_file = 64U << 20U;
}  // namespace

std::string read_text_file(const std::string& path, const std::string& kind) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw Error(path, "no such file, expected a " + kind);
    if (std::filesystem::is_directory(status))
        throw Error(path, "is a folder, expected a " + kind + " file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw Error(path, "cannot be opened, expected a readable " + kind + " file");
    std::string bytes;
    bytes.resize(1U << 16U);
    std::size_t size = 0;
    while (stream.read(bytes.data() + size, static_cast<std::streamsize>(bytes.size() - size)) ||
           stream.gcount() > 0) {
        size += static_cast<std::size_t>(stream.gcount());
        if (size > largest_file)
            throw Error(path, "more than 64 MB found, expected a " + kind + " of at most " +
                                  std::to_string(most_profile_lines) + " points");
        if (size == bytes.size()) bytes.resize(2 * bytes.size());
    }
    if (stream.bad()) throw Error(path, "reading failed, expected a readable " + kind + " file");
    bytes.resize(size);
    return bytes;
}

}  // namespace dem
