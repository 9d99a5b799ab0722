// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/frame_tables.hpp"
#include "runtime/files/journaled_file.hpp"
#include "runtime/files/xdmf_series.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace dem::runtime {

/// A film beside frames.h5: an HDF5 file with a group of tables for each frame, and its index. It
/// has as many frames as frames.h5, each complete on disk as soon as it is appended.
class FrameSeries {
  public:
    struct Film {
        std::string name;  ///< "contacts": contacts.h5, contacts.xdmf
        /// The tables of a frame in the order in which they are written.
        std::span<const char* const> tables;
        /// Writes what is the same in all frames.
        std::function<void(Hdf5File&)> write_beginning;
    };

    /// `frames` > 0: takes up the files of an earlier writer, if there are any, after that many
    /// frames and erases the later ones. Throws Error, also for a frame that was changed.
    FrameSeries(const std::filesystem::path& directory, const Film& film, std::uint64_t frames);

    /// `write_tables` writes all tables of the frame. Throws Error.
    void append(const std::string& frame_name,
                const std::function<XdmfGrid(FrameTables&)>& write_tables);

    /// Lets the disk take all of it.
    void secure() { disk_->secure(); }

  private:
    void begin(const Film& film);
    void take_up(const Film& film, std::uint64_t frames);

    std::filesystem::path path_;
    std::unique_ptr<JournaledFile> disk_;
    XdmfSeries index_;
};

}  // namespace dem::runtime
