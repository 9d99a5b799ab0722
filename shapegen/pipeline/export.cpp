// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/export.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/text.hpp"
#include "shapegen/export/clump_export.hpp"
#include "shapegen/export/mesh_export.hpp"
#include "shapegen/picture/clump_picture.hpp"
#include "shapegen/picture/clump_surface.hpp"
#include "shapegen/picture/contact_sheet.hpp"
#include "shapegen/picture/shape_picture.hpp"

#include <array>
#include <charconv>
#include <vector>

namespace dem::shapegen {

namespace {

const SrShape& sr_shape(const ParticleTemplate& shape, const std::string& format) {
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) return *sr;
    throw Error(shape.name, "found a shape of kind " + in_quotes(kind_name(shape)) +
                                ", expected 'sr' for " + format);
}

/// Surfaces to look at: of a clump the body's and that of the spheres, else the body's.
std::vector<ColoredMesh> surfaces(const ParticleTemplate& shape, const InputFrame& frame) {
    constexpr std::size_t most_triangles = 200'000;
    std::vector<ColoredMesh> parts;
    if (std::holds_alternative<Clump>(shape.shape)) {
        parts = {body_surface(shape), clump_surface(shape, most_triangles)};
    } else {
        const DisplayMesh& mesh = shape.display_mesh;
        parts.push_back({{mesh.vertices.begin(), mesh.vertices.end()},
                         {mesh.triangles.begin(), mesh.triangles.end()},
                         {}});
    }
    for (ColoredMesh& mesh : parts) {
        for (Vec3& p : mesh.vertices) p = frame.point(p);
        for (double& value : mesh.values) value = frame.length(value);
    }
    return parts;
}

std::string picture(const ParticleTemplate& shape) {
    if (std::holds_alternative<Clump>(shape.shape)) return clump_picture(shape);
    if (std::holds_alternative<ConvexShape>(shape.shape)) return contact_sheet({&shape, 1});
    return shape_picture(shape, sr_shape(shape, "a picture"));
}

}  // namespace

const ParticleTemplate& find_shape(const TemplateFile& file, const std::string& where,
                                   const std::string& wanted) {
    if (wanted.empty() && file.shapes.size() == 1) return file.shapes.front();
    if (wanted.empty()) {
        throw UsageError(where, "found " + std::to_string(file.shapes.size()) +
                                    " shapes, expected --shape NAME or --shape INDEX (0 to " +
                                    std::to_string(file.shapes.size() - 1) + ")");
    }
    for (const ParticleTemplate& shape : file.shapes) {
        if (shape.name == wanted) return shape;
    }
    std::size_t index = 0;
    const char* end = wanted.data() + wanted.size();
    const auto [stop, problem] = std::from_chars(wanted.data(), end, index);
    if (problem == std::errc() && stop == end && index < file.shapes.size()) {
        return file.shapes[index];
    }
    throw Error(where, "found no shape " + in_quotes(wanted) +
                           ", expected a name from 'shapegen inspect' or " + "an index below " +
                           std::to_string(file.shapes.size()));
}

void export_shape(const ParticleTemplate& shape, const std::filesystem::path& path, double unit) {
    const InputFrame frame(shape, unit);
    const bool is_clump = std::holds_alternative<Clump>(shape.shape);
    const std::string extension = path.extension().string();
    if (extension == ".svg") {
        write_file(path, picture(shape));
    } else if (extension == ".csv" && is_clump) {
        write_clump_csv(path, shape, frame);
    } else if (extension == ".csv") {
        write_nodes_csv(path, sr_shape(shape, "surface nodes").nodes, frame);
    } else if (extension == ".stl") {
        write_stl(path, surfaces(shape, frame).back(), shape.name, frame.unit_name());
    } else if (extension == ".vtu") {
        write_vtu(path, surfaces(shape, frame), is_clump ? "deviation" : "");
    } else if (extension == ".obj") {
        const std::array<std::string, 2> names{"body", "clump"};
        write_obj(path, surfaces(shape, frame), names, frame.unit_name());
    } else {
        throw UsageError(path.string(),
                         "found the extension " + in_quotes(extension) +
                             ", expected .svg, .stl, .obj, .vtu or .csv, or --format for a clump "
                             "in the format of another code");
    }
}

}  // namespace dem::shapegen
