// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegen/command_line/option.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <boost/program_options.hpp>

namespace dem::shapegen {

/// What a command line says, read by the options of its command. All throw UsageError with one line
/// that says what was found and what was expected.
class OptionValues {
  public:
    /// Throws for an unknown option, a missing or a spare value, an option given twice.
    OptionValues(const CommandOptions& command, std::span<const std::string> words);

    /// Throws where an option is missing that is required, where one is given without another that
    /// it needs, with one that it excludes, or with an input that is no mesh. `implied`: an option
    /// that is as good as given, "" for none.
    void check(std::string_view implied, const std::filesystem::path& input) const;

    /// The one word that is no option; `expected` completes "expected ...".
    std::string input(const std::string& expected) const;

    /// True where the user gave the option, not where it has its default.
    bool given(std::string_view option) const;

    /// The value of an option, its default where it is not given; there must be one. Numbers are
    /// in the range of the option, quantities in SI.
    std::string text(std::string_view option) const;
    std::string choice(std::string_view option) const;
    std::int64_t count(std::string_view option) const;
    double number(std::string_view option) const;
    double fraction(std::string_view option) const;
    double quantity(std::string_view option) const;

    /// The value of an option that names a unit of length [m].
    double length_unit(std::string_view option) const;
    /// The file of --output, a template: its name ends in .tpl.
    std::filesystem::path template_output() const;

    /// Throws: the value of an option is none of those expected.
    [[noreturn]] void refuse(std::string_view option) const;

  private:
    const CommandOptions& command_;
    boost::program_options::variables_map values_;
};

}  // namespace dem::shapegen
