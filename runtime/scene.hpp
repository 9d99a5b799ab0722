// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/aabb.hpp"
#include "common/shapes/particle_template.hpp"
#include "runtime/contact/law/contact_law.hpp"
#include "runtime/outlets/outlet.hpp"
#include "runtime/region.hpp"
#include "runtime/walls/wall.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Everything a run needs, checked, in SI: what `runtime/case` makes of a case file and what
/// `Simulation` consumes. Plain data.
namespace dem::runtime {

struct Material {
    std::string name;
    double density = 0.0;         ///< [kg/m^3]; 0 where only walls use the material
    double youngs_modulus = 0.0;  ///< [Pa]
    double poissons_ratio = 0.0;
};

/// Contact law of every pair of materials.
class LawTable {
  public:
    LawTable() = default;
    explicit LawTable(std::size_t materials) : count_(materials), laws_(materials * materials) {}
    const ContactLaw& at(std::uint32_t a, std::uint32_t b) const { return laws_[a * count_ + b]; }
    const std::vector<ContactLaw>& all() const { return laws_; }
    void set(std::uint32_t a, std::uint32_t b, const ContactLaw& law) {
        laws_[a * count_ + b] = law;
        laws_[b * count_ + a] = law;
    }

  private:
    std::size_t count_ = 0;
    std::vector<ContactLaw> laws_;
};

/// A shape made of a material: what all particles of one sort share.
struct BodyKind {
    std::uint32_t shape = 0;         ///< index into Scene::shapes
    std::uint32_t material = 0;      ///< index into Scene::materials
    double mass = 0.0;               ///< [kg]
    Vec3 inertia = Vec3::Zero();     ///< principal moments [kg m^2]
    InverseInertia inverse_inertia;  ///< all zero for a fixed body
};

/// Where one body starts, world frame. `kind` and `line` belong to the rows of `insert = file`.
struct BodyPlacement {
    Vec3 position = Vec3::Zero();
    Quat orientation = Quat::Identity();
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_velocity = Vec3::Zero();
    std::uint32_t kind = 0;  ///< index into Scene::kinds
    std::uint64_t line = 0;  ///< of the file, for messages
};

/// One [particles.NAME] section.
struct InsertionGroup {
    enum class Mode : std::uint8_t { at_once, batches, lattice, file, fill };
    std::string name;
    std::string where;  ///< "case.ini:31", for messages
    Mode mode = Mode::at_once;
    /// Particle k of the group is of kind kinds[k % size]; with a table the rows say which.
    std::vector<std::uint32_t> kinds;
    std::uint64_t count = 0;
    Region region = BoxRegion{};
    std::uint64_t batch = 1;          ///< batches: how many at a time
    double every = 0.0;               ///< batches: seconds between batches
    double jitter = 0.0;              ///< lattice: largest random shift, in cells
    double start = 0.0;               ///< time of the first insertion [s]
    std::optional<Quat> orientation;  ///< none: random
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_velocity = Vec3::Zero();
    std::string file;                       ///< file: its path, for messages
    std::vector<BodyPlacement> placements;  ///< file: its rows, `count` of them
    bool allow_overlaps = false;            ///< file: rows of an earlier run's end touch each other
};

/// What happens to a body whose center of mass leaves the domain.
enum class DomainExit : std::uint8_t { error, remove };

struct RunSettings {
    double end_time = 0.0;            ///< [s]
    std::optional<double> time_step;  ///< none: automatic
    double time_step_divisor = 20.0;  ///< n of dt = min(T_R, T_H)/n
    bool time_step_force = false;
    Vec3 gravity = Vec3::Zero();  ///< [m/s^2]
    std::uint64_t seed = 1;
    int threads = 0;  ///< at most so many; 0: every core
    bool stop_at_rest = false;
    /// In radii of the smaller body: above it contact laws for small overlaps mean nothing, and the
    /// run ends.
    double overlap_limit = 0.1;
    std::optional<Aabb> domain;  ///< none: derived from walls and regions
    DomainExit domain_exit = DomainExit::error;
    std::optional<double> skin;  ///< neighbor-list skin [m]; none: chosen
    /// For tests: the threads of each step in turn, which share every loop however small. Empty: as
    /// many as make steps shortest (common/threads/step_team.hpp). Never changes a result.
    std::vector<int> forced_threads;
    /// Contacts computed at a time (contact/lanes/lane_kernels.hpp); 0: as many as the processor
    /// does best. Never changes a result.
    int lanes = 0;
};

/// Which walls have columns of forces in the history: none, each [wall.NAME], or each of its faces,
/// too.
enum class WallForceColumns : std::uint8_t { none, whole, faces };

struct OutputSettings {
    std::string directory;
    /// [s]; 0: none but the first and the last; none given: a hundredth of the end time.
    std::optional<double> frames_every = 0.0;
    std::optional<double> history_every = 0.0;  ///< [s]; none given: a thousandth of the end time
    double checkpoint_every = 600.0;            ///< wall time between checkpoints [s]
    WallForceColumns wall_forces = WallForceColumns::none;
    bool surfaces = false;
    bool contacts = false;       ///< every contact in every frame
    bool wall_contacts = false;  ///< what is done to triangles of walls, in every frame
    bool picture = true;
};

struct MeasureSettings {
    enum class Kind : std::uint8_t { fill_height, contacts, solid_fraction };
    std::string name;
    Kind kind = Kind::fill_height;
    std::optional<double> every = 0.0;  ///< [s]; none given: that of the history
    /// A solid fraction is that of the layer between these heights above the vessel's floor [m];
    /// without a top up to the mean surface.
    double bottom = 0.0;
    std::optional<double> top = std::nullopt;
};

struct Scene {
    std::string case_path;
    /// What a checkpoint must agree with: one line per value of the case that moves a body
    /// (case/case_lines.hpp). Empty for a scene made in code.
    std::vector<std::string> case_lines;
    RunSettings run;
    std::vector<Material> materials;
    std::vector<ParticleTemplate> shapes;
    std::vector<BodyKind> kinds;
    LawTable laws;
    std::vector<Wall> walls;
    std::vector<Motion> motions;  ///< those of [motion.NAME], for whoever checks the case
    std::vector<InsertionGroup> insertions;
    std::vector<Outlet> outlets;
    OutputSettings output;
    std::vector<MeasureSettings> measures;
    /// Template files as the case names them, hash of what each was made from.
    std::vector<std::pair<std::string, std::uint64_t>> inputs;
};

/// Unit vector against gravity; z without gravity.
inline Vec3 up_direction(const Scene& scene) {
    return scene.run.gravity.isZero() ? Vec3::UnitZ() : Vec3(-scene.run.gravity.normalized());
}

}  // namespace dem::runtime
