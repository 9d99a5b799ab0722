// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parts_hash.hpp"
#include "runtime/files/hdf5_file.hpp"
#include "runtime/files/xdmf_series.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace dem::runtime {

/// The tables of one frame as they are written: each goes into a group of an HDF5 file and into the
/// hash of the frame, and is told to the index.
class FrameTables {
  public:
    /// `group`: "/frames/00000012/", made here.
    FrameTables(Hdf5File& file, std::string group)
        : file_(file),
          group_(std::move(group)),
          place_(file.path().filename().string() + ":" + group_) {
        file_.make_group(group_);
    }

    const std::string& group() const { return group_; }

    /// The hash of all tables so far and the entry in the index.
    std::uint64_t hash(const std::string& entry) {
        hash_.add(entry);
        return hash_.value();
    }

    XdmfTable add(const std::string& name, std::span<const double> values, std::size_t columns,
                  std::string_view units) {
        XdmfTable table = written(name, values, columns, "Float");
        file_.describe(group_ + name, "units", units);
        return table;
    }
    XdmfTable add(const std::string& name, std::span<const float> values, std::size_t columns,
                  std::string_view units) {
        XdmfTable table = written(name, values, columns, "Float");
        file_.describe(group_ + name, "units", units);
        return table;
    }
    XdmfTable add(const std::string& name, std::span<const std::uint32_t> values,
                  std::size_t columns = 1) {
        return written(name, values, columns, "UInt");
    }

  private:
    template <class Number>
    XdmfTable written(const std::string& name, std::span<const Number> values, std::size_t columns,
                      const char* type) {
        hash_.add(std::as_bytes(values));
        file_.write(group_ + name, values, columns);
        return {place_ + name, values.size() / columns, columns, type, sizeof(Number)};
    }

    Hdf5File& file_;
    std::string group_;
    std::string place_;
    PartsHash hash_;
};

}  // namespace dem::runtime
