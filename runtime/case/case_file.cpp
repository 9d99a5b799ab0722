// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/case_file.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "formats/text_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace dem::runtime {

namespace {

/// Larger files are something else by mistake; the largest cases people write are a few kB.
constexpr std::size_t most_megabytes = 16;

bool separates(char c) {
    return c == ' ' || c == '\t';
}

std::string_view without_comment(std::string_view line) {
    for (std::size_t k = 0; k < line.size(); ++k) {
        const bool starts = line[k] == '#' || line[k] == ';';
        if (starts && (k == 0 || separates(line[k - 1]))) return line.substr(0, k);
    }
    return line;
}

/// Names stand in messages, in file names and in the header of history.csv.
constexpr std::size_t longest_name = 100;

/// A section or key: letters, digits, `_`, `-`; sections also dots between such words.
bool is_name(std::string_view text, bool dots) {
    if (text.empty() || text.size() > longest_name || text.front() == '.' || text.back() == '.')
        return false;
    if (text.find("..") != std::string_view::npos) return false;
    return std::all_of(text.begin(), text.end(), [dots](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' ||
               (dots && c == '.');
    });
}

/// Refuses control characters other than tab and the end of a line: no text file holds them. Bytes
/// from 128 up are left alone (UTF-8 in comments and file names).
void check_text(std::string_view text, const std::string& place, bool count_lines) {
    std::size_t line = 1;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n' && count_lines) ++line;
        const bool line_end = count_lines && (c == '\n' || c == '\r');
        if ((byte >= 32 && byte != 127) || c == '\t' || line_end) continue;
        char hex[8];
        std::snprintf(hex, sizeof hex, "0x%02x", byte);
        throw Error(count_lines ? place + ":" + std::to_string(line) : place,
                    "found " + std::string("byte ") + hex + ", expected text");
    }
}

class Parser {
  public:
    explicit Parser(const std::string& path) { file_.path = path; }

    void parse_line(std::string_view line) {
        ++line_;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        line = trimmed(without_comment(line));
        if (line.empty()) return;
        if (line.front() == '[') {
            parse_section(line);
        } else {
            parse_entry(line);
        }
    }

    CaseFile result() {
        if (file_.sections.empty()) {
            throw Error(file_.path, "found no section, expected a case file with [run] and others");
        }
        return std::move(file_);
    }

  private:
    std::string where() const { return file_.path + ":" + std::to_string(line_); }

    void parse_section(std::string_view line) {
        if (line.back() != ']') {
            throw Error(where(),
                        "no ']' at the end of " + in_quotes(line) + ", expected [section]");
        }
        const std::string_view name = trimmed(line.substr(1, line.size() - 2));
        if (!is_name(name, true)) {
            throw Error(where(),
                        "bad section name " + in_quotes(name) +
                            ", expected at most 100 letters, digits, '_', '-' and single dots");
        }
        if (const CaseSection* first = file_.find(name)) {
            throw Error(where(), "section [" + std::string(name) +
                                     "] given twice, expected it once (first at " + first->where +
                                     ")");
        }
        file_.sections.push_back({std::string(name), where(), {}});
    }

    void parse_entry(std::string_view line) {
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) {
            throw Error(where(),
                        "found " + in_quotes(line) + ", expected 'key = value' or '[section]'");
        }
        const std::string_view key = trimmed(line.substr(0, equals));
        const std::string_view value = trimmed(line.substr(equals + 1));
        if (!is_name(key, false)) {
            throw Error(where(), "bad key " + in_quotes(key) +
                                     ", expected at most 100 letters, digits, '_' and '-'");
        }
        if (file_.sections.empty()) {
            throw Error(where(), "key " + in_quotes(key) +
                                     " before any section, expected [run] or another above it");
        }
        if (value.empty()) {
            throw Error(where(), "no value for key " + in_quotes(key) + ", expected 'key = value'");
        }
        CaseSection& section = file_.sections.back();
        if (const CaseEntry* first = section.find(key)) {
            throw Error(where(), "key " + in_quotes(key) + " given twice in [" + section.name +
                                     "], expected it once (first at " + first->where + ")");
        }
        section.entries.push_back({std::string(key), std::string(value), where()});
    }

    CaseFile file_;
    std::size_t line_ = 0;
};

}  // namespace

const CaseEntry* CaseSection::find(std::string_view key) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [key](const CaseEntry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

const CaseSection* CaseFile::find(std::string_view name) const {
    const auto found =
        std::find_if(sections.begin(), sections.end(),
                     [name](const CaseSection& section) { return section.name == name; });
    return found == sections.end() ? nullptr : &*found;
}

CaseFile parse_case(std::string_view text, const std::string& path) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    check_text(text, path, true);
    Parser parser(path);
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        parser.parse_line(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return parser.result();
}

CaseFile read_case_file(const std::string& path) {
    return parse_case(read_text_file(path, "case file", most_megabytes), path);
}

void override_value(CaseFile& file, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    const std::string_view name = trimmed(assignment.substr(0, equals));
    const std::size_t dot = name.rfind('.');
    const bool split = equals != std::string_view::npos && dot != std::string_view::npos;
    const std::string_view section = split ? name.substr(0, dot) : std::string_view();
    const std::string_view key = split ? name.substr(dot + 1) : std::string_view();
    const std::string_view value = split ? trimmed(assignment.substr(equals + 1)) : key;
    if (!is_name(section, true) || !is_name(key, false) || value.empty()) {
        throw UsageError("--set",
                         "found " + in_quotes(assignment) + ", expected section.key=value");
    }
    const std::string where = "--set " + std::string(name);
    check_text(value, where, false);
    auto found = std::find_if(file.sections.begin(), file.sections.end(),
                              [section](const CaseSection& s) { return s.name == section; });
    if (found == file.sections.end()) {
        found = file.sections.insert(found, {std::string(section), where, {}});
    }
    const CaseEntry* old = found->find(key);
    CaseEntry entry{std::string(key), std::string(value), where};
    if (old == nullptr) {
        found->entries.push_back(std::move(entry));
    } else {
        found->entries[static_cast<std::size_t>(old - found->entries.data())] = std::move(entry);
    }
}

}  // namespace dem::runtime
