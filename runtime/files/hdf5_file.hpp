// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/journaled_file.hpp"
#include "runtime/files/plain_values.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <hdf5.h>

namespace dem::runtime {

/// An HDF5 file open for writing. What is written becomes a part of the file with `close`, as a
/// whole or not at all, and a disk that fills up leaves the file as it was (journaled_file.hpp).
/// - No lock is taken: somebody who looks at the file does not stop the run.
/// - The layout is that of HDF5 1.8, which MATLAB and older ParaView read and which has no mark for
///   "not closed properly".
///
/// Every member throws Error with the file's name and the reason of the system or of HDF5.
class Hdf5File {
  public:
    /// Adds to a file, or begins one that is empty.
    explicit Hdf5File(JournaledFile& disk);

    /// Without `close` what was written is dropped.
    ~Hdf5File();
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    void close();

    const std::filesystem::path& path() const { return disk_.path(); }

    /// Makes a group in one that exists.
    void make_group(const std::string& name);

    /// A table of values.size() / columns rows, a plain list for one column. Large ones are stored
    /// in compressed chunks.
    void write(const std::string& name, std::span<const double> values, std::size_t columns = 1);
    void write(const std::string& name, std::span<const float> values, std::size_t columns = 1);
    void write(const std::string& name, std::span<const std::uint32_t> values,
               std::size_t columns = 1);
    void write(const std::string& name, std::span<const std::uint64_t> values,
               std::size_t columns = 1);
    void write(const std::string& name, std::span<const std::string> values);

    /// A list of values as they lie in memory (Hdf5Reader::plain), not compressed.
    void write_plain(const std::string& name, const PlainValues& values);

    /// Removes a table or a group with everything in it. Its room is used again, or given back
    /// where it was the end of the file.
    void erase(const std::string& name);

    /// An attribute of a group or a table ("/" is the file).
    void describe(const std::string& object, const std::string& name, double value);
    void describe(const std::string& object, const std::string& name, std::uint64_t value);
    void describe(const std::string& object, const std::string& name, std::string_view value);

  private:
    struct Types {
        hid_t in_memory, in_file;
    };
    void write_table(const std::string& name, const void* values, std::size_t rows,
                     std::size_t columns, Types types);
    void write_attribute(const std::string& object, const std::string& name, const void* value,
                         Types types);
    [[noreturn]] void fail(const std::string& action) const;

    JournaledFile& disk_;
    hid_t file_ = H5I_INVALID_HID;
};

}  // namespace dem::runtime
