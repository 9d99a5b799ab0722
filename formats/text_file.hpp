// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace dem {

/// The bytes of a text file. Throws Error(path, ...) for a missing file, a folder, one that cannot
/// be read and more than 64 MB; `kind` names what was expected ("profile").
std::string read_text_file(const std::string& path, const std::string& kind);

}  // namespace dem
