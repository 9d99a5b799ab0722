// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/text_scanner.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace dem::shapegen {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Without a plus sign, which from_chars does not know.
std::string_view unsigned_part(std::string_view word) {
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return has_plus ? word.substr(1) : word;
}

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string name, TextStyle style,
                         std::size_t first_line)
    : at_(text.data()),
      end_(text.data() + text.size()),
      name_(std::move(name)),
      style_(style),
      line_(first_line) {}

void TextScanner::skip_line_end() {
    if (at_ == end_) return;
    const bool is_cr = *at_++ == '\r';
    if (is_cr && at_ != end_ && *at_ == '\n') ++at_;
    ++line_;
}

void TextScanner::skip_blanks() {
    for (;;) {
        while (at_ != end_ && is_blank(*at_)) ++at_;
        const bool is_continued = style_.has_continuations && end_ - at_ >= 2 && *at_ == '\\' &&
                                  (at_[1] == '\n' || at_[1] == '\r');
        if (!is_continued) break;
        ++at_;
        skip_line_end();
    }
    if (style_.has_comments && at_ != end_ && *at_ == '#')
        while (!is_at_line_end()) ++at_;
}

bool TextScanner::next_line() {
    if (is_in_line_)
        while (!is_at_line_end()) ++at_;
    is_in_line_ = false;
    while (at_ != end_) {
        skip_blanks();
        if (!is_at_line_end()) return is_in_line_ = true;
        skip_line_end();
    }
    return false;
}

std::string_view TextScanner::word() {
    skip_blanks();
    const char* begin = at_;
    while (!is_at_line_end() && !is_blank(*at_)) {
        if (*at_ == '\\' && style_.has_continuations && end_ - at_ >= 2 &&
            (at_[1] == '\n' || at_[1] == '\r'))
            break;
        ++at_;
    }
    return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextScanner::word_of_any_line() {
    std::string_view next = is_in_line_ ? word() : std::string_view{};
    if (next.empty() && next_line()) next = word();
    return next;
}

double TextScanner::number(std::string_view expected) {
    const std::string_view digits = word();
    const auto value = finite_number(digits);
    if (!value) fail(digits, expected);
    return *value;
}

std::int64_t TextScanner::whole_number(std::string_view expected) {
    const std::string_view digits = word();
    std::int64_t value = 0;
    if (!parse_whole_number(digits, value)) fail(digits, expected);
    return value;
}

std::string TextScanner::place() const {
    return name_ + ":" + std::to_string(line_);
}

void TextScanner::fail(std::string_view found, std::string_view expected) const {
    std::string message = "found ";
    message += !found.empty() ? in_quotes(found) : at_ == end_ ? "the end" : "the end of the line";
    throw Error(place(), message.append(", expected ").append(expected));
}

bool parse_whole_number(std::string_view word, std::int64_t& value) {
    const std::string_view digits = unsigned_part(word);
    const char* end = digits.data() + digits.size();
    const auto [stop, problem] = std::from_chars(digits.data(), end, value);
    return problem == std::errc() && stop == end;
}

bool is_keyword(std::string_view word, std::string_view lower) {
    return word.size() == lower.size() &&
           std::equal(word.begin(), word.end(), lower.begin(),
                      [](char a, char b) { return lower_case(a) == b; });
}

std::string_view text_of(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return text;
}

}  // namespace dem::shapegen
