// SPDX-License-Identifier: BSD-3-Clause
#include "common/text.hpp"

#include "common/format.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace dem {

namespace {

unsigned char byte_at(std::string_view text, std::size_t k) {
    return static_cast<unsigned char>(text[k]);
}

bool continues(std::string_view text, std::size_t k) {
    return (byte_at(text, k) & 0xc0U) == 0x80U;
}

/// Bytes of the UTF-8 character that starts at k; 0 where none does.
std::size_t character_size(std::string_view text, std::size_t k) {
    const unsigned char first = byte_at(text, k);
    const std::size_t size = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
    if (k + size > text.size()) return 0;
    for (std::size_t i = k + 1; i < k + size; ++i)
        if (!continues(text, i)) return 0;
    return size;
}

/// Escapes of characters that move the cursor or ring the bell: C0, DEL and, in UTF-8, C1.
bool is_control(std::string_view text, std::size_t k) {
    const unsigned char first = byte_at(text, k);
    return first < 32 || first == 127 || (first == 0xc2 && byte_at(text, k + 1) < 0xa0);
}

std::string escaped(unsigned char byte) {
    switch (byte) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return format("\\x%02x", static_cast<unsigned>(byte));
    }
}

bool equal_but_for_case(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

/// Twice the Damerau-Levenshtein distance (insert, delete, replace, swap of neighbors), a change of
/// case costing half.
std::size_t doubled_edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> before(width);
    std::vector<std::size_t> above(width);
    std::vector<std::size_t> row(width);
    for (std::size_t j = 0; j < width; ++j) above[j] = 2 * j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = 2 * i;
        for (std::size_t j = 1; j < width; ++j) {
            const char x = a[i - 1];
            const char y = b[j - 1];
            const std::size_t replace = x == y ? 0 : equal_but_for_case(x, y) ? 1 : 2;
            row[j] = std::min({above[j] + 2, row[j - 1] + 2, above[j - 1] + replace});
            if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y) {
                row[j] = std::min(row[j], before[j - 2] + 2);
            }
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above.back();
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string readable(std::string_view text) {
    std::string result;
    for (std::size_t k = 0; k < text.size();) {
        const std::size_t size = character_size(text, k);
        if (size > 0 && !is_control(text, k)) {
            result.append(text.substr(k, size));
        } else {
            for (std::size_t i = k; i < k + std::max<std::size_t>(1, size); ++i)
                result += escaped(byte_at(text, i));
        }
        k += std::max<std::size_t>(1, size);
    }
    return result;
}

std::string in_quotes(std::string_view found) {
    constexpr std::size_t longest = 60;
    constexpr std::size_t at_end = 17;
    if (found.size() <= longest) return "'" + readable(found) + "'";
    // Characters are kept whole: a cut goes before one.
    std::size_t head = longest - at_end - 3;
    std::size_t tail = found.size() - at_end;
    while (head > 0 && continues(found, head)) --head;
    while (tail < found.size() && continues(found, tail)) ++tail;
    return "'" + readable(found.substr(0, head)) + "..." + readable(found.substr(tail)) + "'";
}

std::string joined(std::span<const std::string> words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

std::string nearest_word(std::string_view word, std::span<const std::string> candidates) {
    // A third of the letters may be wrong: "restitutoin" is helped, "scale" is not told "shape".
    const std::size_t most = std::max<std::size_t>(2, 2 * word.size() / 3);
    std::size_t best = most + 1;
    std::string nearest;
    for (const std::string& candidate : candidates) {
        // Every letter more or less is an edit.
        const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
        if (2 * (longer - shorter) >= best) continue;
        const std::size_t distance = doubled_edit_distance(word, candidate);
        // Everything replaced is no resemblance ("x" for "m").
        if (distance >= 2 * shorter && distance > 1) continue;
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
    const std::string nearest = nearest_word(word, candidates);
    return nearest.empty() ? "" : ", did you mean " + in_quotes(nearest) + "?";
}

std::string suggestion_or_all(std::string_view word, std::span<const std::string> candidates) {
    const std::string near = suggestion(word, candidates);
    if (!near.empty()) return near;
    if (candidates.empty()) return ", there is none";
    constexpr std::size_t longest = 500;  // three lines of a terminal hold the keys of any section
    std::string text;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const std::string quotes = in_quotes(candidates[k]);
        const std::string next = (k == 0 ? "" : ", ") + quotes.substr(1, quotes.size() - 2);
        if (text.size() + next.size() > longest)
            return ", expected one of: " + text + ", ... (" + std::to_string(candidates.size()) +
                   " in all)";
        text += next;
    }
    return ", expected one of: " + text;
}

}  // namespace dem
