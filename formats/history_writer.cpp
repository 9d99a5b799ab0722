// SPDX-License-Identifier: BSD-3-Clause
#include "formats/history_writer.hpp"

#include "common/error.hpp"
#include "formats/csv_rows.hpp"
#include "formats/number_text.hpp"

#include <cerrno>
#include <system_error>

namespace dem {

HistoryWriter::HistoryWriter(const std::filesystem::path& path,
                             std::span<const std::string> columns)
    : path_(path), columns_(columns.size()) {
    errno = 0;
    out_.open(path, std::ios::binary | std::ios::trunc);
    if (!out_) fail();
    std::string line;
    for (const std::string& name : columns) line += (line.empty() ? "" : ",") + csv_field(name);
    write(line);
}

void HistoryWriter::append(std::span<const double> values) {
    DEM_ASSERT(values.size() == columns_);
    std::string line;
    for (const double value : values) line += (line.empty() ? "" : ",") + number_text(value);
    write(line);
}

void HistoryWriter::write(const std::string& line) {
    errno = 0;
    out_ << line << '\n';
    out_.flush();
    if (!out_) fail();
}

void HistoryWriter::fail() const {
    const int error = errno == 0 ? EIO : errno;
    throw Error(path_.string(), "cannot write: " + std::generic_category().message(error));
}

}  // namespace dem
