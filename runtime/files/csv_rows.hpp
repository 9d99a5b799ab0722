// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dem::runtime {

/// Splits comma-separated text into rows of fields (RFC 4180): quoted fields may hold commas, line
/// ends and doubled quotes; blanks around unquoted fields, blank lines, a byte order mark and both
/// kinds of line ends are accepted.
class CsvRows {
  public:
    /// `where` names the text in messages; `text` must outlive the object.
    CsvRows(std::string_view text, std::string where);

    /// The fields of the next row that is not blank; false at the end. Throws Error for a quote
    /// that is not closed or is followed by text, a field of more than 64 kB, more than 1000
    /// fields.
    bool next(std::vector<std::string>& fields);

    /// The line where the last row starts, from 1, and the same as "bodies.csv:12".
    std::size_t line() const { return row_line_; }
    std::string place() const;

  private:
    void skip_blank_lines();
    std::string quoted_field();
    std::string_view plain_field();

    std::string_view rest_;
    std::string where_;
    std::size_t line_ = 1;      ///< of rest_
    std::size_t row_line_ = 0;  ///< of the last row
};

/// A field as it is written: quoted where it must be.
std::string csv_field(std::string_view text);

}  // namespace dem::runtime
