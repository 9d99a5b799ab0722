// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "runtime/files/journaled_file.hpp"
#include "runtime/files/xdmf_series.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dem::runtime {

struct Frame;

/// The surfaces of all particles as triangles in the world frame: surfaces.h5 and surfaces.xdmf,
/// colored by particle id and speed. In single precision, which is enough to look at.
class SurfaceWriter {
  public:
    /// Shapes without a display mesh stay invisible. `frames` > 0: takes up the files of an earlier
    /// writer, if there are any, after that many frames and erases the later ones.
    SurfaceWriter(const std::filesystem::path& directory, std::span<const ParticleTemplate> shapes,
                  std::uint64_t frames);

    /// Throws Error, also for a frame of more than 2^32 vertices.
    void append(const Frame& frame, const std::string& frame_name);

    /// Lets the disk take all of it.
    void secure() { disk_->secure(); }

  private:
    void begin();
    void take_up(std::uint64_t frames);
    void take_triangles(const Frame& frame);

    std::filesystem::path path_;
    std::unique_ptr<JournaledFile> disk_;
    XdmfSeries index_;
    std::vector<DisplayMesh> meshes_;  ///< by shape

    // Triangles and ids stay the same until particles come or go: stored once, used by many frames.
    std::vector<std::uint32_t> known_id_, known_shape_;
    std::uint64_t topologies_ = 0;
    std::uint64_t last_hash_ = 0;  ///< of the last topology
    std::uint64_t vertices_ = 0;   ///< of the current topology
    XdmfTable triangles_, triangle_id_;
};

}  // namespace dem::runtime
