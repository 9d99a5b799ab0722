// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/history_writer.hpp"

#include "common/error.hpp"
#include "formats/file_kind.hpp"
#include "formats/number_text.hpp"
#include "runtime/files/csv_rows.hpp"

#include <cerrno>
#include <system_error>

namespace dem::runtime {

namespace {

std::string header(std::span<const std::string> columns) {
    std::string line;
    for (const std::string& name : columns) line += (line.empty() ? "" : ",") + csv_field(name);
    return line;
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& path,
                             std::span<const std::string> columns)
    : path_(path), columns_(columns.size()) {
    open(std::ios::trunc);
    write(header(columns));
}

HistoryWriter::HistoryWriter(const std::filesystem::path& path,
                             std::span<const std::string> columns, std::uint64_t rows,
                             std::uint64_t hash)
    : path_(path), columns_(columns.size()), rows_(rows) {
    if (const std::string missing = no_file_at(path); !missing.empty()) {
        throw Error(path.string(), missing + ", expected the history of the run that is resumed");
    }
    std::ifstream in(path, std::ios::binary);
    std::string line;
    if (!in || !std::getline(in, line) || line != header(columns)) {
        throw Error(path.string(),
                    "found other columns than this case writes, expected the history of the run "
                    "that is resumed");
    }
    std::uint64_t found = 0;
    auto end = in.tellg();
    // A row that a killed run did not finish has no line end.
    while (found < rows && std::getline(in, line) && !in.eof()) {
        ++found;
        end = in.tellg();
        add_to_hash(line);
    }
    if (found < rows) {
        throw Error(path.string(), "found " + std::to_string(found) + " rows, expected the " +
                                       std::to_string(rows) + " written before the checkpoint");
    }
    if (hash_.value() != hash) {
        throw Error(path.string(),
                    "found rows changed since they were written, expected the history of the run "
                    "that is resumed");
    }
    in.close();
    std::error_code error;
    end_ = static_cast<std::uintmax_t>(end);
    std::filesystem::resize_file(path, end_, error);
    if (error) throw Error(path.string(), "cannot write: " + error.message());
    open(std::ios::app);
}

void HistoryWriter::open(std::ios::openmode mode) {
    errno = 0;
    out_.open(path_, std::ios::binary | std::ios::out | mode);
    if (!out_) fail();
}

void HistoryWriter::append(std::span<const std::optional<double>> values) {
    DEM_ASSERT(values.size() == columns_);
    std::string line;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (k > 0) line += ',';
        if (values[k]) line += number_text(*values[k]);
    }
    write(line);
    add_to_hash(line);
    ++rows_;
}

void HistoryWriter::add_to_hash(const std::string& line) {
    hash_.add(std::span<const char>(line));
    hash_.add(std::span<const char>("\n", 1));
}

void HistoryWriter::write(const std::string& line) {
    errno = 0;
    out_ << line << '\n';
    out_.flush();
    if (out_) {
        end_ += line.size() + 1;
        return;
    }
    const int error = errno;
    out_.close();             // tries once more, so first
    std::error_code ignored;  // a row that is cut off stays where that cannot be helped
    std::filesystem::resize_file(path_, end_, ignored);
    errno = error;
    fail();
}

void HistoryWriter::fail() const {
    const int error = errno == 0 ? EIO : errno;
    throw Error(path_.string(), "cannot write: " + std::generic_category().message(error));
}

}  // namespace dem::runtime
