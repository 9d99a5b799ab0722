// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

/// Text that is taken apart, and text of messages.
namespace dem {

/// Without blanks, tabs and ends of lines before and behind it.
std::string_view trimmed(std::string_view text);

/// What was found, for a message: in quotes, readable, of more than 60 characters the first and the
/// last ones with "..." between them.
std::string in_quotes(std::string_view found);

/// Text that a person can read on one line of a terminal: control characters and bytes that are no
/// UTF-8 become \n, \r, \t or \x1b; all else stays.
std::string readable(std::string_view text);

/// "a, b, c"
std::string joined(std::span<const std::string> words);

/// The candidate nearest to `word` by edit distance (a change of case counts as half an edit), the
/// first of equals, or "" when none is near enough to suggest.
std::string nearest_word(std::string_view word, std::span<const std::string> candidates);

/// ", did you mean 'arc'?" or "" when no candidate is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

/// The suggestion, or when no candidate is near ", expected one of: a, b, c", cut when that gets
/// long, or ", there is none".
std::string suggestion_or_all(std::string_view word, std::span<const std::string> candidates);

}  // namespace dem
