// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/case/shape_library.hpp"
#include "runtime/case/values.hpp"
#include "runtime/scene.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// The parts of read_scene, one per sort of section; each adds to the scene what its section says.
/// Order: run, materials, particles, motions, walls, outlets, laws, output, measures.
namespace dem::runtime {

RunSettings read_run(const Values& values);
Material read_material(const Values& values);

/// Reads [particles.NAME] sections. Every template file is mapped once, of a library only the
/// shapes that bodies take are made, and groups that use the same shape of the same material share
/// a body kind.
class ParticleGroupReader {
  public:
    /// `folder`: of the case file, for relative paths.
    explicit ParticleGroupReader(std::filesystem::path folder) : folder_(std::move(folder)) {}
    void read(const Values& values, Scene& scene);

  private:
    ShapeLibrary& library(const Values& values, Scene& scene);
    std::uint32_t kind_of(const BodyKind& wanted, bool is_fixed, Scene& scene);

    std::filesystem::path folder_;
    std::map<std::string, ShapeLibrary> templates_;  ///< by path
    std::map<double, ShapeLibrary> spheres_;         ///< by radius
    std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, std::uint32_t> kinds_;
};

/// The sections of motions, in the order of the file.
struct MotionSections {
    std::vector<Values> heads;   ///< [motion.NAME]
    std::vector<Values> pieces;  ///< [motion.NAME.PIECE]
};
/// `folder`: of the case file, for relative paths.
void read_motions(const MotionSections& sections, const std::filesystem::path& folder,
                  Scene& scene);
/// Throws Error at `where`, with a suggestion, where no motion of the scene has the name.
const Motion& motion_of_name(const Scene& scene, const std::string& name, const std::string& where);

/// The faces of one [wall.NAME]: a box is up to six planes, a cylinder its side and its ends.
void read_wall(const Values& values, Scene& scene);

/// Laws of all pairs of materials, from [contact] and the [contact.A.B] that change it.
void read_laws(const CaseFile& file, Scene& scene);

Outlet read_outlet(const Values& values);
OutputSettings read_output(const Values& values, const RunSettings& run);
MeasureSettings read_measure(const Values& values);

/// Index of a material by name. Throws Error at `where` with a suggestion.
std::uint32_t material_index(const Scene& scene, const std::string& name, const std::string& where);

/// "vessel" of "wall.vessel".
std::string own_name(const std::string& section);

}  // namespace dem::runtime
