// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace dem {

/// A table of numbers that grows by a row at a time (history.csv). Every row reaches the system as
/// soon as it is written: a run that is killed keeps all of them, and others may read along.
class HistoryWriter {
  public:
    /// Replaces the file by a header row. Throws Error when it cannot be written.
    HistoryWriter(const std::filesystem::path& path, std::span<const std::string> columns);

    /// One value per column; every number reads back as the same double. Throws Error, e.g. on a
    /// full disk.
    void append(std::span<const double> values);

  private:
    void write(const std::string& line);
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::ofstream out_;
    std::size_t columns_;
};

}  // namespace dem
