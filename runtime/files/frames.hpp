// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "runtime/files/contact_series.hpp"
#include "runtime/files/journaled_file.hpp"
#include "runtime/files/surfaces.hpp"
#include "runtime/files/wall_contact_series.hpp"
#include "runtime/files/xdmf_series.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// The film of a run: frames.h5 with every frame's state and frames.xdmf that lets ParaView play it
/// (docs/output-files.md).
namespace dem::runtime {

class Hdf5File;

/// One moment, world frame, SI. All arrays have one entry per particle; `coordination` and `force`
/// may be left empty. Contacts and loads of walls must be there where FrameContext asks for them.
struct Frame {
    double time = 0.0;  ///< [s]
    std::uint64_t step = 0;
    std::span<const std::uint32_t> id;
    std::span<const Vec3> position;               ///< of the center of mass [m]
    std::span<const Quat> orientation;            ///< body -> world
    std::span<const Vec3> velocity;               ///< [m/s]
    std::span<const Vec3> angular_velocity;       ///< [rad/s]
    std::span<const std::uint32_t> shape;         ///< index into the shapes of the writer
    std::span<const std::uint32_t> group;         ///< index into the groups of the writer
    std::span<const std::uint32_t> coordination;  ///< contacts of the particle
    std::span<const Vec3> force;                  ///< [N]
    const ContactTable* contacts = nullptr;
    const WallContactTable* wall_contacts = nullptr;
};

/// What is the same in all frames.
struct FrameContext {
    std::string case_path;
    std::vector<std::string> groups;      ///< names of the particle groups
    bool surfaces = false;                ///< also write every particle's surface (surfaces.hpp)
    bool contacts = false;                ///< also write every contact (contact_series.hpp)
    std::vector<std::string> walls = {};  ///< names that contacts refer to
    /// Also write what is done to these triangles (wall_contact_series.hpp).
    const WallTriangles* wall_contacts = nullptr;
};

/// Appends frames to DIR/frames.h5. After each append the files are complete: whatever ends the
/// process, every frame is kept (journaled_file.hpp). Throws Error with the file and the reason (no
/// such folder, disk full, ...); what was written before stays readable.
class FrameWriter {
  public:
    /// Begins new files.
    FrameWriter(const std::filesystem::path& directory, const FrameContext& context,
                std::span<const ParticleTemplate> shapes);

    /// Takes up the files of an earlier writer of the same shapes and groups after `frames` frames
    /// and erases the later ones; begins new ones, with numbers that go on, when there is no
    /// frames.h5 any more. Throws Error when it cannot be read or has not that many frames.
    FrameWriter(const std::filesystem::path& directory, const FrameContext& context,
                std::span<const ParticleTemplate> shapes, std::uint64_t frames);

    /// The number of particles may change from frame to frame.
    void append(const Frame& frame);

    std::uint64_t count() const { return count_; }  ///< of frames

    /// Lets the disk take all frames.
    void secure();

  private:
    void begin(const FrameContext& context, std::span<const ParticleTemplate> shapes);
    void begin_others(const std::filesystem::path& directory, const FrameContext& context,
                      std::span<const ParticleTemplate> shapes);
    void take_up();
    XdmfTable points(Hdf5File& file, std::size_t count) const;

    std::filesystem::path path_;
    std::unique_ptr<JournaledFile> disk_;
    std::uint64_t count_ = 0;
    XdmfTable points_;  ///< 0, 1, 2, ..., shared by frames of as many particles
    XdmfSeries index_;
    std::unique_ptr<SurfaceWriter> surfaces_;
    std::unique_ptr<ContactWriter> contacts_;
    std::unique_ptr<WallContactWriter> wall_contacts_;
};

}  // namespace dem::runtime
