// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

/// What earlier runs have left in the folder of a new one.
namespace dem::runtime {

/// What stands in the way of a run that begins anew: "" or a sentence that says what is there and
/// what may be done.
std::string earlier_results(const std::filesystem::path& folder);

/// Throws Error where a folder, a pipe or the like bears the name of a result: to write over it
/// would fail, or wait for ever.
void require_files(const std::filesystem::path& folder);

/// Makes the frames of a killed run whole by their journals. Throws Error where they cannot be.
void mend_frames(const std::filesystem::path& folder);

/// Removes what killed runs had begun to write beside their files (*.part-*).
void remove_remains(const std::filesystem::path& folder);

}  // namespace dem::runtime
