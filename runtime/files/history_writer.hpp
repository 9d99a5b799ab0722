// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/state_hash.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>

namespace dem::runtime {

/// A table of numbers that grows by a row at a time (history.csv). Every row reaches the system as
/// soon as it is written: a run that is killed keeps all of them, and others may read along.
class HistoryWriter {
  public:
    /// Replaces the file by a header row. Throws Error when it cannot be written.
    HistoryWriter(const std::filesystem::path& path, std::span<const std::string> columns);

    /// Goes on after the first `rows` rows of an existing file and drops the later ones. Throws
    /// Error when it has other columns, fewer rows or, by their hash, others than were written.
    HistoryWriter(const std::filesystem::path& path, std::span<const std::string> columns,
                  std::uint64_t rows, std::uint64_t hash);

    /// One value per column, nothing where a field stays empty; every number reads back as the same
    /// double. Throws Error, e.g. on a full disk.
    void append(std::span<const std::optional<double>> values);

    std::uint64_t rows() const { return rows_; }
    std::uint64_t hash() const { return hash_.value(); }  ///< of all rows so far

  private:
    void open(std::ios::openmode mode);
    void write(const std::string& line);
    void add_to_hash(const std::string& line);
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::ofstream out_;
    std::size_t columns_;
    std::uint64_t rows_ = 0;
    StateHash hash_;
    std::uintmax_t end_ = 0;  ///< of the last complete row [bytes]
};

}  // namespace dem::runtime
