// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/case/body_rows.hpp"
#include "runtime/case/scene_sections.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace dem::runtime {

namespace {

constexpr double most_batches = 1e15;  // beyond, doubles no longer count one by one

/// A fixed body with a velocity would be a contradiction, not a moving wall.
void check_standing(const Values& values, const InsertionGroup& group) {
    const auto stands = [](const Vec3& velocity, const Vec3& spin) {
        return velocity == Vec3::Zero() && spin == Vec3::Zero();
    };
    for (const BodyPlacement& body : group.placements) {
        if (stands(body.velocity, body.angular_velocity)) continue;
        throw Error(group.file + ":" + std::to_string(body.line),
                    "found a velocity for a fixed body, expected none");
    }
    if (!stands(group.velocity, group.angular_velocity)) {
        throw Error(values.where("fixed"), "found 'yes' with a velocity, expected one of them");
    }
}

/// Which shapes of the library the bodies of a group take: body k the k-th of these, in turn. Rows
/// may name theirs.
std::vector<std::size_t> taken_shapes(const Values& values, const std::vector<BodyRow>& rows,
                                      const InsertionGroup& group, ShapeLibrary& library) {
    std::vector<std::size_t> all;
    if (values.has("shape")) {
        const std::string wanted = values.text("shape");
        const auto found = library.find(wanted);
        if (!found)
            throw Error(values.where("shape"), "no shape " + in_quotes(wanted) + " in " +
                                                   in_quotes(values.text("template")) +
                                                   library.suggestion_for(wanted));
        all = {*found};
    } else {
        all.resize(std::min<std::uint64_t>(group.count, library.size()));
        std::iota(all.begin(), all.end(), std::size_t{0});
    }
    const bool names_shapes = std::any_of(
        rows.begin(), rows.end(), [](const BodyRow& row) { return !row.template_name.empty(); });
    if (!names_shapes) return all;
    std::vector<std::size_t> of_rows;
    of_rows.reserve(rows.size());
    for (const BodyRow& row : rows) {
        std::size_t shape = all[of_rows.size() % all.size()];
        if (!row.template_name.empty()) {
            const auto found = library.find(row.template_name);
            const std::string place = group.file + ":" + std::to_string(row.line);
            const std::string words = "template " + in_quotes(row.template_name) +
                                      " is none of [particles." + group.name + "]";
            if (!found) throw Error(place, words + library.suggestion_for(row.template_name));
            if (values.has("shape") && *found != all.front())
                throw Error(
                    place, words + ", expected " + in_quotes(values.text("shape")) + ", its shape");
            shape = *found;
        }
        of_rows.push_back(shape);
    }
    return of_rows;
}

}  // namespace

ShapeLibrary& ParticleGroupReader::library(const Values& values, Scene& scene) {
    const std::optional<double> radius = values.radius();
    if (radius.has_value() == values.has("template")) {
        throw Error(
            radius ? values.where(values.has("radius") ? "radius" : "diameter")
                   : values.section_where(),
            std::string(radius ? "both template and radius" : "neither template nor radius") +
                " in [" + values.section_name() + "], expected one of them");
    }
    if (radius) {
        if (values.has("shape")) {
            throw Error(values.where("shape"),
                        "found beside 'radius', expected it with 'template'");
        }
        return spheres_.try_emplace(*radius, *radius).first->second;
    }
    const std::string path = (folder_ / values.text("template")).lexically_normal().string();
    if (const auto known = templates_.find(path); known != templates_.end()) return known->second;
    try {
        ShapeLibrary& library = templates_.try_emplace(path, path).first->second;
        scene.inputs.emplace_back(values.text("template"), library.input_hash());
        return library;
    } catch (const Error& error) {
        throw Error(values.where("template"), error.what());
    }
}

std::uint32_t ParticleGroupReader::kind_of(const BodyKind& wanted, bool is_fixed, Scene& scene) {
    const auto [entry, is_new] = kinds_.try_emplace({wanted.shape, wanted.material, is_fixed},
                                                    static_cast<std::uint32_t>(scene.kinds.size()));
    if (!is_new) return entry->second;
    BodyKind kind = wanted;
    const MassProperties& properties = scene.shapes[kind.shape].mass_properties;
    const double density = scene.materials[kind.material].density;
    kind.mass = density * properties.volume;
    kind.inertia = density * properties.principal_moments_per_density;
    if (!is_fixed) {
        const double surface = scene.shapes[kind.shape].mean_squared_surface_distance;
        kind.inverse_inertia = {1.0 / kind.mass, kind.inertia.cwiseInverse(),
                                surface / kind.inertia.mean()};
    }
    scene.kinds.push_back(kind);
    return entry->second;
}

void ParticleGroupReader::read(const Values& values, Scene& scene) {
    InsertionGroup group;
    group.name = own_name(values.section_name());
    group.where = values.section_where();
    group.mode = values.choice<InsertionGroup::Mode>("insert");
    BodyKind kind;
    kind.material = material_index(scene, values.text("material"), values.where("material"));
    if (!(scene.materials[kind.material].density > 0.0)) {
        throw Error(values.where("material"), "material " + in_quotes(values.text("material")) +
                                                  " has no density, particles need one");
    }
    group.start = values.number("start");
    ShapeLibrary& shapes = library(values, scene);
    std::vector<BodyRow> rows;
    if (group.mode == InsertionGroup::Mode::file) {
        rows = read_body_rows(values, folder_, group);
    } else {
        group.count = values.count("count");
        group.region = values.region("region");
        group.orientation = values.optional_orientation("orientation");
        group.velocity = values.vector("velocity");
        group.angular_velocity = values.vector("angular_velocity");
    }
    const std::vector<std::size_t> wanted = taken_shapes(values, rows, group, shapes);
    const bool is_fixed = values.yes_no("fixed");
    try {
        for (const std::uint32_t shape : shapes.take(wanted, scene)) {
            kind.shape = shape;
            group.kinds.push_back(kind_of(kind, is_fixed, scene));
        }
    } catch (const Error& error) {
        throw Error(values.where("template"), error.what());
    }
    if (group.mode == InsertionGroup::Mode::file) place_rows(rows, group);
    if (is_fixed) check_standing(values, group);
    if (group.mode == InsertionGroup::Mode::lattice) group.jitter = values.number("jitter");
    if (group.mode == InsertionGroup::Mode::batches) {
        group.batch = values.count("batch");
        group.every = values.number("every");
        if (scene.run.end_time > most_batches * group.every) {
            throw Error(values.where("every"),
                        "makes more than 1e15 batches until end_time, expected a longer interval");
        }
    }
    scene.insertions.push_back(std::move(group));
}

}  // namespace dem::runtime
