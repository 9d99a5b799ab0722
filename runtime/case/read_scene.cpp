// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/read_scene.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/case/case_lines.hpp"
#include "runtime/case/region.hpp"
#include "runtime/case/scene_sections.hpp"
#include "runtime/contact/pairs/pair_table.hpp"
#include "runtime/outlets/outlets.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace dem::runtime {

namespace {

/// What stands before the first dot of a section's name or pattern.
std::string_view first_word(std::string_view section) {
    return split(section, '.').front();
}

void check_section_names(const CaseFile& file) {
    for (const CaseSection& section : file.sections) {
        if (section_kind(section.name) != nullptr) continue;
        std::vector<std::string> words;
        std::string forms;
        for (const SectionKind& kind : section_kinds()) {
            if (words.empty() || words.back() != first_word(kind.pattern)) {
                words.emplace_back(first_word(kind.pattern));
            }
            if (first_word(kind.pattern) == first_word(section.name)) {
                forms += (forms.empty() ? "[" : " or [") + std::string(kind.pattern) + "]";
            }
        }
        throw Error(section.where,
                    "unknown section [" + section.name + "]" +
                        (forms.empty() ? suggestion_or_all(first_word(section.name), words)
                                       : ", expected " + forms));
    }
}

/// Calls `use` with the checked values of every section of a kind, in the order of the file.
template <class Use>
void for_each(const CaseFile& file, std::string_view pattern, const Use& use) {
    for (const CaseSection& section : file.sections) {
        const SectionKind* kind = section_kind(section.name);
        if (kind->pattern == pattern) use(Values(section, *kind));
    }
}

void require_section(const CaseFile& file, std::string_view pattern) {
    for (const CaseSection& section : file.sections) {
        if (section_kind(section.name)->pattern == pattern) return;
    }
    throw Error(file.path, "no section [" + std::string(pattern) + "], it is required");
}

/// Below this share of a coordinate a radius is too small: contacts would see rounding, and cells
/// of grids would be as small as the steps between doubles.
constexpr double smallest_radius_share = 1e-10;

void check_digits(const Scene& scene, const InsertionGroup& group) {
    Aabb places;
    if (group.mode != InsertionGroup::Mode::file) places = bounds(group.region);
    for (const BodyPlacement& body : group.placements) places.extend(body.position);
    const double farthest =
        std::max(places.lower.cwiseAbs().maxCoeff(), places.upper.cwiseAbs().maxCoeff());
    for (const std::uint32_t kind : group.kinds) {
        const double radius = scene.shapes[scene.kinds[kind].shape].bounding_radius;
        if (radius >= smallest_radius_share * farthest) continue;
        std::ostringstream message;
        message << "bodies of radius " << radius << " m at " << farthest
                << " m from the origin, expected them within 1e10 radii: positions lose the digits "
                   "that contacts need";
        throw Error(group.where, message.str());
    }
}

bool is_fixed(const Scene& scene, std::uint32_t kind) {
    return scene.kinds[kind].inverse_inertia.mass == 0.0;
}

/// Two columns of one name would hide each other from whoever reads the history.
void check_outlet_names(const Scene& scene) {
    std::vector<std::string> columns = outlet_columns(scene);
    std::sort(columns.begin(), columns.end());
    const auto twice = std::adjacent_find(columns.begin(), columns.end());
    if (twice == columns.end()) return;
    const auto last =
        std::find_if(scene.outlets.rbegin(), scene.outlets.rend(),
                     [&](const Outlet& outlet) { return twice->starts_with(outlet.name + "_"); });
    throw Error(last->where, "the columns of [outlet." + last->name +
                                 "] in the history would have " + in_quotes(*twice) +
                                 " twice, expected names of outlets and groups that differ");
}

/// Bodies that go out as they come in are a mistake, and so is a place that nobody can reach.
void check_outlet(const Outlet& outlet, const Scene& scene) {
    if (scene.run.domain && !may_hold(outlet, BoxRegion{*scene.run.domain})) {
        throw Error(outlet.where, "[outlet." + outlet.name +
                                      "] lies outside of the domain, expected it where bodies get");
    }
    if (outlet.kind == Outlet::Kind::flow) return;
    for (const InsertionGroup& group : scene.insertions) {
        const bool takes_new =
            group.mode == InsertionGroup::Mode::file
                ? std::any_of(group.placements.begin(), group.placements.end(),
                              [&](const BodyPlacement& body) {
                                  return holds(outlet, body.position) &&
                                         !is_fixed(scene, body.kind);
                              })
                : !is_fixed(scene, group.kinds.front()) && may_hold(outlet, group.region);
        if (!takes_new) continue;
        throw Error(outlet.where, "[outlet." + outlet.name +
                                      "] takes out bodies where [particles." + group.name +
                                      "] puts them in, expected them apart");
    }
}

/// A row outside of a domain that lets bodies go would come in for nothing.
void check_rows(const InsertionGroup& group, const RunSettings& run) {
    if (!run.domain || run.domain_exit == DomainExit::error) return;
    for (const BodyPlacement& body : group.placements) {
        if (run.domain->contains(body.position)) continue;
        throw Error(group.file + ":" + std::to_string(body.line),
                    "the body is outside of the domain, expected it inside");
    }
}

/// Where a wall in triangles is this much larger or smaller than a body, a unit is wrong.
constexpr double largest_ratio = 1e6;

/// Whether contacts of a kind with walls of triangles are computed.
bool meets_meshes(const ParticleTemplate& shape, const ContactLaw& law) {
    if (std::holds_alternative<SrShape>(shape.shape))
        return contact_method(shape.is_convex, law) == ContactLaw::Method::continuous;
    return !std::holds_alternative<ConvexShape>(shape.shape);
}

void check_mesh_wall(const Scene& scene, const InsertionGroup& group, const Wall& wall) {
    const auto* mesh = std::get_if<MeshWall>(&wall.shape);
    if (mesh == nullptr) return;
    const double size = (mesh->mesh->bounds.upper - mesh->mesh->bounds.lower).norm();
    for (const std::uint32_t kind : group.kinds) {
        if (scene.kinds[kind].inverse_inertia.mass == 0.0) continue;
        const ParticleTemplate& shape = scene.shapes[scene.kinds[kind].shape];
        if (!meets_meshes(shape, scene.laws.at(scene.kinds[kind].material, wall.material))) {
            throw Error(group.where, "bodies of kind '" + kind_name(shape) + "' with wall '" +
                                         wall.name +
                                         "' of shape mesh are not in this version, expected "
                                         "spheres, clumps or convex surfaces of revolution "
                                         "without 'contact = nodes'");
        }
        const double radius = shape.bounding_radius;
        if (size <= largest_ratio * radius && radius <= largest_ratio * size) continue;
        std::ostringstream message;
        message << "wall '" << wall.name << "' is " << size
                << " m large and bodies have a radius of " << radius
                << " m, expected a ratio of at most 1e6; see 'scale' of the wall";
        throw Error(group.where, message.str());
    }
}

void check_wall_contacts(const Values& values, const Scene& scene) {
    if (!scene.output.wall_contacts) return;
    for (const Wall& wall : scene.walls)
        if (std::holds_alternative<MeshWall>(wall.shape)) return;
    throw Error(values.where("wall_contacts"),
                "found yes and no wall of triangles, expected one of 'shape = mesh'");
}

}  // namespace

std::string own_name(const std::string& section) {
    return section.substr(section.find('.') + 1);
}

Scene read_scene(const CaseFile& file) {
    check_section_names(file);
    require_section(file, "run");
    require_section(file, "particles.NAME");
    require_section(file, "material.NAME");
    Scene scene;
    scene.case_path = file.path;
    for_each(file, "run", [&](const Values& v) { scene.run = read_run(v); });
    for_each(file, "material.NAME",
             [&](const Values& v) { scene.materials.push_back(read_material(v)); });
    const auto folder = std::filesystem::path(file.path).parent_path();
    ParticleGroupReader groups(folder);
    for_each(file, "particles.NAME", [&](const Values& v) { groups.read(v, scene); });
    MotionSections motions;
    for_each(file, "motion.NAME", [&](const Values& v) { motions.heads.push_back(v); });
    for_each(file, "motion.NAME.PIECE", [&](const Values& v) { motions.pieces.push_back(v); });
    read_motions(motions, folder, scene);
    for_each(file, "wall.NAME", [&](const Values& v) { read_wall(v, scene); });
    for_each(file, "outlet.NAME",
             [&](const Values& v) { scene.outlets.push_back(read_outlet(v)); });
    read_laws(file, scene);
    const CaseSection nothing{"output", file.path, {}};
    scene.output = read_output(Values(nothing, *section_kind("output")), scene.run);
    for_each(file, "output", [&](const Values& v) {
        scene.output = read_output(v, scene.run);
        check_wall_contacts(v, scene);
    });
    for_each(file, "measure.NAME",
             [&](const Values& v) { scene.measures.push_back(read_measure(v)); });
    for (const InsertionGroup& group : scene.insertions) {
        check_digits(scene, group);
        if (group.mode != InsertionGroup::Mode::file)
            check_region(group, scene.walls, scene.run.domain);
        for (const Wall& wall : scene.walls) check_mesh_wall(scene, group, wall);
    }
    check_outlet_names(scene);
    for (const Outlet& outlet : scene.outlets) check_outlet(outlet, scene);
    for (const InsertionGroup& group : scene.insertions) check_rows(group, scene.run);
    scene.case_lines = case_lines(file);
    return scene;
}

}  // namespace dem::runtime
