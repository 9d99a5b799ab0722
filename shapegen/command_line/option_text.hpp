// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/option.hpp"

#include <string>

#include <boost/program_options.hpp>

namespace dem::shapegen {

/// The options of a group for Boost, which parses them and prints them for the help.
boost::program_options::options_description described(const OptionGroup& group);

/// All commands and options: `--help`.
std::string help_text();

/// The manual page for `man -l -`: `--man`.
std::string man_page();

}  // namespace dem::shapegen
