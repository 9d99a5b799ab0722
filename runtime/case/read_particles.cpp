// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "formats/template_reader.hpp"
#include "runtime/case/body_rows.hpp"
#include "runtime/case/scene_sections.hpp"
#include "runtime/case/sphere_template.hpp"

namespace dem {

namespace {

std::vector<std::string> shape_names(const std::vector<std::uint32_t>& shapes, const Scene& scene) {
    std::vector<std::string> names;
    names.reserve(shapes.size());
    for (const std::uint32_t s : shapes) names.push_back(scene.shapes[s].name);
    return names;
}

/// A fixed body with a velocity would be a contradiction, not a moving wall.
void check_standing(const Values& values, const InsertionGroup& group) {
    const auto stands = [](const Vec3& velocity, const Vec3& spin) {
        return velocity == Vec3::Zero() && spin == Vec3::Zero();
    };
    for (const BodyPlacement& body : group.placements) {
        if (stands(body.velocity, body.angular_velocity)) continue;
        throw Error(group.file + ":" + std::to_string(body.line),
                    "a velocity found for a fixed body, expected none");
    }
    if (!stands(group.velocity, group.angular_velocity)) {
        throw Error(values.where("fixed"), "'yes' found with a velocity, expected one of them");
    }
}

}  // namespace

const ParticleGroupReader::Shapes& ParticleGroupReader::template_shapes(const Values& values,
                                                                        Scene& scene) {
    const std::string path = (folder_ / values.text("template")).lexically_normal().string();
    const auto [entry, is_new] = templates_.try_emplace(path);
    if (!is_new) return entry->second;
    TemplateFile file;
    try {
        file = read_template(path);
    } catch (const Error& error) {
        throw Error(values.where("template"), error.what());
    }
    scene.inputs.emplace_back(values.text("template"), file.input_hash);
    for (ParticleTemplate& shape : file.shapes) {
        entry->second.push_back(static_cast<std::uint32_t>(scene.shapes.size()));
        scene.shapes.push_back(std::move(shape));
    }
    return entry->second;
}

const ParticleGroupReader::Shapes& ParticleGroupReader::sphere(double radius, Scene& scene) {
    const auto [entry, is_new] = spheres_.try_emplace(radius);
    if (is_new) {
        entry->second.push_back(static_cast<std::uint32_t>(scene.shapes.size()));
        scene.shapes.push_back(sphere_template(radius));
    }
    return entry->second;
}

ParticleGroupReader::Shapes ParticleGroupReader::shapes_of(const Values& values, Scene& scene) {
    if (values.has("radius") == values.has("template")) {
        throw Error(values.has("radius") ? values.where("radius") : values.section_where(),
                    std::string(values.has("radius") ? "both template and radius"
                                                     : "neither template nor radius") +
                        " in [" + values.section_name() + "], expected one of them");
    }
    if (values.has("radius")) {
        if (values.has("shape")) {
            throw Error(values.where("shape"),
                        "found beside 'radius', expected it with 'template'");
        }
        return sphere(values.number("radius"), scene);
    }
    const Shapes& all = template_shapes(values, scene);
    if (!values.has("shape")) return all;
    const std::string wanted = values.text("shape");
    for (const std::uint32_t s : all) {
        if (scene.shapes[s].name == wanted) return {s};
    }
    throw Error(values.where("shape"), "no shape '" + wanted + "' in " + values.text("template") +
                                           suggestion(wanted, shape_names(all, scene)));
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
        throw Error(values.where("material"), "material '" + values.text("material") +
                                                  "' has no density, particles need one");
    }
    for (const std::uint32_t shape : shapes_of(values, scene)) {
        kind.shape = shape;
        group.kinds.push_back(kind_of(kind, values.yes_no("fixed"), scene));
    }
    group.start = values.number("start");
    if (group.mode == InsertionGroup::Mode::file) {
        read_body_rows(values, folder_, scene, group);
    } else {
        group.count = values.count("count");
        group.region = values.region("region");
        group.orientation = values.optional_orientation("orientation");
        group.velocity = values.vector("velocity");
        group.angular_velocity = values.vector("angular_velocity");
    }
    if (values.yes_no("fixed")) check_standing(values, group);
    if (group.mode == InsertionGroup::Mode::batches) {
        group.batch = values.count("batch");
        group.every = values.number("every");
    }
    scene.insertions.push_back(std::move(group));
}

}  // namespace dem
