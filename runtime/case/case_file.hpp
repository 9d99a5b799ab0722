// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The text of a case file, taken apart into sections and keys. What the keys mean is the business
/// of runtime/case. Boost.Program_options reads INI files too, but keeps no line numbers, and every
/// message about a case must name the line.
namespace dem::runtime {

/// One `key = value`.
struct CaseEntry {
    std::string key;
    std::string value;
    std::string where;  ///< "case.ini:12", or "--set run.seed" for an override; for messages
};

/// One `[name]` with the keys below it, in the order of the file.
struct CaseSection {
    std::string name;   ///< "run", "contact.coating.steel"
    std::string where;  ///< "case.ini:3"
    std::vector<CaseEntry> entries;

    const CaseEntry* find(std::string_view key) const;  ///< nullptr: not given
};

struct CaseFile {
    std::string path;  ///< as the user gave it
    std::vector<CaseSection> sections;

    const CaseSection* find(std::string_view name) const;  ///< nullptr: not given
};

/// Reads a case file. Blank lines and text after `#` or `;` (at the start of a line or after a
/// blank) are skipped. Throws Error with file and line: unreadable, empty, not text, neither a
/// section nor `key = value`, a section or a key given twice, a key without a value.
CaseFile read_case_file(const std::string& path);

/// Reads a case from text; `path` only for messages.
CaseFile parse_case(std::string_view text, const std::string& path);

/// Sets `section.key=value` over what the file says; adds the key or the section if it is not
/// there. The key is what follows the last dot before the `=`. Throws UsageError naming the option.
void override_value(CaseFile& file, std::string_view assignment);

}  // namespace dem::runtime
