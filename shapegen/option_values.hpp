// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <boost/program_options.hpp>

namespace dem {

/// An option with a text; `name` stands for it in the help.
boost::program_options::typed_value<std::string>* text(const char* name);

/// True where the user gave the option, not its default.
bool is_given(const boost::program_options::variables_map& values, const std::string& option);

/// The value of an option that is a fraction ("0.95" or "95%") in an open range. Throws UsageError
/// where it is none; `expected` completes "expected ...".
double fraction_option(const boost::program_options::variables_map& values,
                       const std::string& option, double above, double below,
                       const std::string& expected);

/// The value of a whole-number option (common/number.hpp) between limits that are not negative.
/// Throws UsageError where it is none or out of range.
std::int64_t whole_number(const boost::program_options::variables_map& values,
                          const std::string& option, std::int64_t least, std::int64_t most);

/// The value of an option that names a unit of length [m]. Throws UsageError for an unknown one.
double length_unit_option(const boost::program_options::variables_map& values,
                          const std::string& option);

/// The file of --output, a template. Throws UsageError where its name does not end in .tpl.
std::filesystem::path template_output(const boost::program_options::variables_map& values);

}  // namespace dem
