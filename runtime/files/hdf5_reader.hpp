// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/hdf5_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dem::runtime {

/// An HDF5 file that this project wrote, open for reading. Every member throws Error with the
/// file's name and the reason.
class Hdf5Reader {
  public:
    explicit Hdf5Reader(const std::filesystem::path& path);
    ~Hdf5Reader();
    Hdf5Reader(const Hdf5Reader&) = delete;
    Hdf5Reader& operator=(const Hdf5Reader&) = delete;

    /// Names in a group, sorted.
    std::vector<std::string> members(const std::string& group) const;

    std::string text(const std::string& object, const std::string& attribute) const;
    std::uint64_t number(const std::string& object, const std::string& attribute) const;

    /// Entries of a plain list.
    std::uint64_t size(const std::string& table) const;

    /// The numbers of a table as they are in the file, one behind another.
    std::vector<std::byte> content(const std::string& table) const;

    /// A list of plain values as Hdf5File::write_plain stored it.
    PlainValues plain(const std::string& name) const;

  private:
    [[noreturn]] void fail(const std::string& what) const;

    std::filesystem::path path_;
    hid_t file_;
};

}  // namespace dem::runtime
