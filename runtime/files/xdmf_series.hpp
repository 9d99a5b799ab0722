// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dem::runtime {

/// A table in an HDF5 file beside the index, as XDMF names it.
struct XdmfTable {
    std::string path;  ///< "frames.h5:/frames/00000012/position"
    std::size_t rows = 0;
    std::size_t columns = 1;
    const char* type = "Float";  ///< Float or UInt
    std::size_t bytes = 8;       ///< of one number
};

struct XdmfAttribute {
    std::string name;
    const char* kind = "Scalar";  ///< Scalar, Vector or Matrix
    const char* center = "Node";  ///< Node or Cell
    XdmfTable table;
};

/// One moment: points, lines when `cells` has two columns, or triangles when it has three.
struct XdmfGrid {
    double time = 0.0;  ///< [s]
    XdmfTable cells;
    XdmfTable points;
    std::vector<XdmfAttribute> attributes;
};

/// The index that lets ParaView open HDF5 files as a film (XDMF, temporal collection). Appears with
/// the first grid, because readers crash on an index of none, and is always complete: replaced by a
/// longer one as frames arrive, at most once a second when there are many of them, so that a long
/// run does not spend its time on rewriting it; the last one comes with the destructor or write().
/// The entry of a grid is text that can be kept elsewhere, so that the series can be taken up
/// again.
class XdmfSeries {
  public:
    XdmfSeries(std::filesystem::path path, std::string name);
    ~XdmfSeries();
    XdmfSeries(const XdmfSeries&) = delete;
    XdmfSeries& operator=(const XdmfSeries&) = delete;

    /// The next entry of the index; "" for a grid without points, which readers choke on.
    std::string entry(const XdmfGrid& grid) const;

    void append(const std::string& entry);

    /// Replaces what an earlier series has left by those of its entries that still hold.
    void begin(const std::vector<std::string>& entries);

    /// Replaces the file now. Throws Error.
    void write();

  private:
    std::filesystem::path path_;
    std::string name_;
    std::string grids_;
    std::size_t count_ = 0;
    std::size_t count_written_ = 0;
    double last_written_;  ///< [s]
};

}  // namespace dem::runtime
