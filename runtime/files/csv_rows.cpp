// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/csv_rows.hpp"

#include "common/error.hpp"
#include "common/text.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

constexpr std::string_view blanks = " \t\r";

// Beyond these the text is no table, be it a file of any size.
constexpr std::size_t longest_field = std::size_t{1} << 16;  // [bytes]
constexpr std::size_t most_fields = 1000;

}  // namespace

CsvRows::CsvRows(std::string_view text, std::string where) : rest_(text), where_(std::move(where)) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

std::string CsvRows::place() const {
    return where_ + ":" + std::to_string(row_line_);
}

std::string CsvRows::quoted_field() {
    std::string field;
    rest_.remove_prefix(1);
    while (true) {
        const std::size_t quote = rest_.substr(0, longest_field - field.size()).find('"');
        if (quote == std::string_view::npos)
            throw Error(place(), "a quote is not closed, expected a second one within 64 kB");
        field.append(rest_.substr(0, quote));
        line_ += static_cast<std::size_t>(
            std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(quote), '\n'));
        rest_.remove_prefix(quote + 1);
        if (!rest_.starts_with('"')) break;
        field += '"';
        rest_.remove_prefix(1);
    }
    const std::size_t after = std::min(rest_.find_first_not_of(blanks), rest_.size());
    rest_.remove_prefix(after);
    if (!rest_.empty() && rest_.front() != ',' && rest_.front() != '\n') {
        throw Error(place(), "text after a closing quote, expected a comma");
    }
    return field;
}

std::string_view CsvRows::plain_field() {
    const std::string_view ahead = rest_.substr(0, longest_field);
    const std::size_t end = std::min(ahead.find_first_of(",\n"), ahead.size());
    if (end == longest_field)
        throw Error(place(), "found a field of more than 64 kB, expected a comma-separated table");
    const std::string_view field = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return trimmed(field);
}

void CsvRows::skip_blank_lines() {
    std::size_t start = 0;  // of the line
    for (std::size_t k = 0; k < rest_.size(); ++k) {
        if (rest_[k] == '\n') {
            ++line_;
            start = k + 1;
        } else if (blanks.find(rest_[k]) == std::string_view::npos) {
            rest_.remove_prefix(start);
            return;
        }
    }
    rest_ = {};
}

bool CsvRows::next(std::vector<std::string>& fields) {
    fields.clear();
    skip_blank_lines();
    if (rest_.empty()) return false;
    row_line_ = line_;
    while (true) {
        if (fields.size() == most_fields)
            throw Error(place(), "found more than 1000 fields, expected a comma-separated table");
        const std::size_t start = std::min(rest_.find_first_not_of(" \t"), rest_.size());
        if (rest_.substr(start).starts_with('"')) {
            rest_.remove_prefix(start);
            fields.push_back(quoted_field());
        } else {
            fields.emplace_back(plain_field());
        }
        if (rest_.empty()) return true;
        const char separator = rest_.front();
        rest_.remove_prefix(1);
        if (separator == '\n') {
            ++line_;
            return true;
        }
    }
}

std::string csv_field(std::string_view text) {
    const bool is_plain = text.find_first_of(",\"\n\r") == std::string_view::npos &&
                          trimmed(text).size() == text.size();
    if (is_plain) return std::string(text);
    std::string field = "\"";
    for (const char c : text) {
        if (c == '"') field += '"';
        field += c;
    }
    return field + '"';
}

}  // namespace dem::runtime
