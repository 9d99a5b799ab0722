// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/command_line.hpp"

#include <iosfwd>

namespace dem::shapegen {

/// Does what the command line asks for; what the user reads goes to `out`. Throws Error.
void run_command(const Command& command, std::ostream& out);

}  // namespace dem::shapegen
