// SPDX-License-Identifier: BSD-3-Clause
#include "formats/csv_rows.hpp"

#include "common/error.hpp"

#include <algorithm>

namespace dem {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

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
        const std::size_t quote = rest_.find('"');
        if (quote == std::string_view::npos) throw Error(place(), "a quote is not closed");
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

bool CsvRows::next(std::vector<std::string>& fields) {
    fields.clear();
    while (!rest_.empty()) {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        if (!trimmed(rest_.substr(0, end)).empty()) break;
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++line_;
    }
    if (rest_.empty()) return false;
    row_line_ = line_;
    while (true) {
        const std::size_t start = std::min(rest_.find_first_not_of(" \t"), rest_.size());
        if (rest_.substr(start).starts_with('"')) {
            rest_.remove_prefix(start);
            fields.push_back(quoted_field());
        } else {
            const std::size_t end = std::min(rest_.find_first_of(",\n"), rest_.size());
            fields.emplace_back(trimmed(rest_.substr(0, end)));
            rest_.remove_prefix(end);
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

}  // namespace dem
