// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace dem {

/// Whether a signal is to be heeded: not after nohup, nor Ctrl-C in what a script started in the
/// background.
bool is_heeded(int signal);

/// From now on a write beyond the limit on file sizes fails with its reason, as on a full disk,
/// instead of ending the program.
void survive_file_size_limit();

}  // namespace dem
