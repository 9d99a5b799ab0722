// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace dem {

/// What is found where a file to read was named, for a message: "no such file", "is a folder", "is
/// a pipe", ...; "" for a file. Follows links, opens nothing: a pipe may block for ever.
std::string no_file_at(const std::filesystem::path& path);

}  // namespace dem
