// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace dem::shapegen {

/// What the lines of a format may hold beside words.
struct TextStyle {
    bool has_comments = false;       ///< from # to the end of the line
    bool has_continuations = false;  ///< a backslash at the end joins a line with the next
};

/// A text as lines of words, for the readers of mesh files. Lines end with LF, CRLF or CR; blanks
/// separate words; empty lines are passed over. Looks at the bytes, copies nothing. Errors read
/// "NAME:LINE: found ..., expected ...".
class TextScanner {
  public:
    /// `first_line`: number of the line that the text begins with.
    TextScanner(std::string_view text, std::string name, TextStyle style,
                std::size_t first_line = 1);

    /// To the next line that holds a word; what is left of this one is passed over. False at the
    /// end of the text.
    bool next_line();
    /// The next word of the line, "" at its end.
    std::string_view word();
    /// The next word, on this line or a later one, "" at the end of the text.
    std::string_view word_of_any_line();

    /// The next word as a finite number. `expected` completes "expected ...".
    double number(std::string_view expected);
    std::int64_t whole_number(std::string_view expected);

    std::size_t line() const { return line_; }
    /// "cube.obj:12"
    std::string place() const;
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
    /// `found` is put in quotes; "" is the end of the line.
    [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

  private:
    bool is_at_line_end() const { return at_ == end_ || *at_ == '\n' || *at_ == '\r'; }
    void skip_blanks();
    void skip_line_end();

    const char* at_;
    const char* end_;
    std::string name_;
    TextStyle style_;
    std::size_t line_;
    bool is_in_line_ = false;
};

bool parse_whole_number(std::string_view word, std::int64_t& value);

/// Equal but for upper and lower case; `lower` is in lower case.
bool is_keyword(std::string_view word, std::string_view lower);

/// The bytes as characters, without the mark that some editors put in front of UTF-8.
std::string_view text_of(std::span<const std::byte> bytes);

}  // namespace dem::shapegen
