// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/export.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "formats/clump_export.hpp"
#include "formats/mesh_export.hpp"
#include "formats/number_text.hpp"
#include "shapegen/picture/clump_picture.hpp"
#include "shapegen/picture/clump_surface.hpp"
#include "shapegen/picture/contact_sheet.hpp"
#include "shapegen/picture/shape_picture.hpp"

#include <array>
#include <charconv>

namespace dem {

namespace {

const SrShape& sr_shape(const ParticleTemplate& shape, const std::string& format) {
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) return *sr;
    throw Error(shape.name,
                "found a shape of kind '" + kind_name(shape) + "', expected 'sr' for " + format);
}

/// Everything in the frame and the unit of the input, so that it lies on it.
void export_clump(const ParticleTemplate& shape, const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    constexpr std::size_t most_triangles = 200'000;
    const auto surfaces = [&shape] {
        return std::array{in_input_frame(body_surface(shape), shape),
                          in_input_frame(clump_surface(shape, most_triangles), shape)};
    };
    if (extension == ".csv") {
        write_clump_csv(path, shape);
    } else if (extension == ".svg") {
        write_file(path, clump_picture(shape));
    } else if (extension == ".stl") {
        write_stl(path, surfaces()[1], shape.name, number_text(shape.input_unit) + " m");
    } else if (extension == ".vtu") {
        write_vtu(path, surfaces(), "deviation");
    } else if (extension == ".obj") {
        const std::array<std::string, 2> names{"body", "clump"};
        write_obj(path, surfaces(), names);
    } else {
        throw UsageError(path.string(),
                         "found the extension '" + extension +
                             "', expected .csv, .vtu, .stl, .obj or .svg, or --format for another "
                             "code");
    }
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
    throw Error(where, "found no shape '" + wanted +
                           "', expected a name from 'shapegen inspect' or " + "an index below " +
                           std::to_string(file.shapes.size()));
}

void export_shape(const ParticleTemplate& shape, const std::filesystem::path& path) {
    if (std::holds_alternative<Clump>(shape.shape)) return export_clump(shape, path);
    const std::string extension = path.extension().string();
    if (extension == ".svg") {
        write_file(path, std::holds_alternative<ConvexShape>(shape.shape)
                             ? contact_sheet({&shape, 1})
                             : shape_picture(shape, sr_shape(shape, "a picture")));
    } else if (extension == ".stl") {
        write_stl(path, shape.display_mesh, shape.name);
    } else if (extension == ".vtu") {
        write_vtu(path, shape.display_mesh);
    } else if (extension == ".csv") {
        write_nodes_csv(path, sr_shape(shape, "surface nodes").nodes);
    } else {
        throw UsageError(path.string(), "found the extension '" + extension +
                                            "', expected .svg, .stl, .vtu or .csv");
    }
}

}  // namespace dem
