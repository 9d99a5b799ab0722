// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace dem {

/// The bytes of a text file, which may come through a pipe. Throws Error(path, ...) for a missing
/// file, a folder, a socket, a pipe that nobody writes to, one that cannot be read and more than
/// `most_mb` MB, be they of a device that never ends. `kind` names what was expected ("profile").
std::string read_text_file(const std::string& path, const std::string& kind, std::size_t most_mb);

}  // namespace dem
