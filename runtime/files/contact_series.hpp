// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/frame_series.hpp"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace dem::runtime {

/// Where a contact has no such partner.
inline constexpr std::uint32_t no_partner = std::numeric_limits<std::uint32_t>::max();

/// All contacts at one moment, one entry each, world frame, SI.
struct ContactTable {
    double time = 0.0;             ///< [s]
    std::vector<std::uint32_t> i;  ///< id of a particle
    std::vector<std::uint32_t> j;  ///< id of the particle that it touches, or no_partner
    /// Index of the wall that it touches (names of the writer), or no_partner.
    std::vector<std::uint32_t> wall;
    std::vector<std::uint32_t> slips;    ///< flag
    std::vector<double> point;           ///< 3 each: where the load acts [m]
    std::vector<double> normal;          ///< 3 each: unit, from j or the wall towards i
    std::vector<double> force;           ///< 3 each: on i [N]
    std::vector<double> friction;        ///< 3 each: the part of the force that friction is [N]
    std::vector<double> velocity;        ///< 3 each: of i relative to j or the wall there [m/s]
    std::vector<double> normal_force;    ///< [N]
    std::vector<double> friction_limit;  ///< at which friction slips [N]
    std::vector<double> overlap;         ///< [m]
    /// 6 each: the line that shows it, from the center of i to that of j or to the point at the
    /// wall [m].
    std::vector<float> lines;

    std::size_t size() const { return i.size(); }
};

/// The contacts of every frame: contacts.h5, and contacts.xdmf that shows them as lines.
class ContactWriter {
  public:
    /// `walls`: names that ContactTable::wall refers to; `frames`: as of a FrameSeries. Throws
    /// Error.
    ContactWriter(const std::filesystem::path& directory, std::span<const std::string> walls,
                  std::uint64_t frames);

    /// Throws Error.
    void append(const ContactTable& contacts, const std::string& frame_name);

    /// Lets the disk take all of it.
    void secure() { series_.secure(); }

  private:
    FrameSeries series_;
};

}  // namespace dem::runtime
