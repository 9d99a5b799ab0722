// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_writer.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "formats/template_check.hpp"
#include "formats/template_header.hpp"
#include "formats/template_layout.hpp"

#include <span>
#include <string>

namespace dem {

namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

schema::Vec3 stored(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Our arrays as vectors of the schema's structs of the same layout (formats/template_layout.hpp).
template <class Stored, class Used>
auto structs(FlatBufferBuilder& fbb, const SharedArray<Used>& values) {
    static_assert(layout::agree<Stored, Used>);
    return fbb.CreateVectorOfStructs(reinterpret_cast<const Stored*>(values.data()), values.size());
}
template <class T>
auto scalars(FlatBufferBuilder& fbb, const SharedArray<T>& values) {
    return fbb.CreateVector(values.data(), values.size());
}

Offset<schema::SupportMap> encode(FlatBufferBuilder& fbb, const SupportMap& map) {
    if (map.pieces.empty()) return 0;
    const auto pieces = structs<schema::SupportPiece>(fbb, map.pieces);
    const auto ends = scalars(fbb, map.piece_end);
    const auto first = scalars(fbb, map.first_piece);
    return schema::CreateSupportMap(fbb, pieces, ends, first);
}

Offset<schema::SdfQuadtree> encode(FlatBufferBuilder& fbb, const SdfQuadtree& sdf) {
    const schema::SdfGrid grid(sdf.origin_r, sdf.origin_z, sdf.base_size, sdf.margin,
                               sdf.lipschitz_slack, sdf.surface_slack, sdf.surface_band,
                               sdf.cells_r, sdf.cells_z);
    const auto cells = structs<schema::SdfCell>(fbb, sdf.cells);
    const auto values = scalars(fbb, sdf.values);
    return schema::CreateSdfQuadtree(fbb, &grid, cells, values);
}

Offset<schema::SurfaceNodes> encode(FlatBufferBuilder& fbb, const SurfaceNodes& nodes) {
    if (nodes.count == 0) return 0;
    const auto points = structs<schema::Node>(fbb, nodes.nodes);
    const auto blocks = structs<schema::Ball>(fbb, nodes.blocks);
    const auto super_blocks = structs<schema::Ball>(fbb, nodes.super_blocks);
    const auto stencil = scalars(fbb, nodes.stencil);
    return schema::CreateSurfaceNodes(fbb, nodes.count, points, blocks, super_blocks, stencil);
}

Offset<schema::DisplayMesh> encode(FlatBufferBuilder& fbb, const DisplayMesh& mesh) {
    if (mesh.triangles.empty()) return 0;
    const auto vertices = structs<schema::Vec3>(fbb, mesh.vertices);
    const auto triangles = structs<schema::Triangle>(fbb, mesh.triangles);
    return schema::CreateDisplayMesh(fbb, vertices, triangles, mesh.max_deviation);
}

struct EncodedKind {
    schema::ShapeData type;
    Offset<void> data;
};

struct EncodeKind {
    FlatBufferBuilder& fbb;

    EncodedKind operator()(const Sphere& sphere) const {
        return {schema::ShapeData_SphereShape,
                schema::CreateSphereShape(fbb, sphere.radius).Union()};
    }
    EncodedKind operator()(const SrShape& sr) const {
        const schema::SrDimensions dimensions(sr.bottom_z, sr.top_z, sr.max_radius,
                                              sr.bounding_radius, sr.equivalent_diameter,
                                              sr.major_axis_length);
        const auto support = encode(fbb, sr.support);
        const auto sdf = encode(fbb, sr.sdf);
        const auto curvature = structs<schema::CurvatureSample>(fbb, sr.curvature);
        const auto nodes = encode(fbb, sr.nodes);
        return {schema::ShapeData_SrShape, schema::CreateSrShape(fbb, sr.is_convex, &dimensions,
                                                                 support, sdf, curvature, nodes)
                                               .Union()};
    }
    EncodedKind operator()(const Clump& clump) const {
        const auto spheres = structs<schema::ClumpSphere>(fbb, clump.spheres);
        const auto balls = structs<schema::Ball>(fbb, clump.balls);
        return {schema::ShapeData_ClumpShape,
                schema::CreateClumpShape(fbb, spheres, balls).Union()};
    }
    EncodedKind operator()(const ConvexShape& convex) const {
        const StoredVec3& s = convex.size;
        const schema::ConvexDimensions dimensions(s.x, s.y, s.z, convex.low, convex.rounding);
        const auto vertices = structs<schema::Vec3>(fbb, convex.vertices);
        const auto begin = scalars(fbb, convex.face_begin);
        const auto corners = scalars(fbb, convex.face_vertices);
        return {schema::ShapeData_ConvexShape,
                schema::CreateConvexShape(fbb, static_cast<std::uint32_t>(convex.core), &dimensions,
                                          vertices, begin, corners)
                    .Union()};
    }
};

struct EncodedCertificate {
    Offset<flatbuffers::Vector<Offset<flatbuffers::String>>> names;
    Offset<flatbuffers::Vector<double>> values;
};

EncodedCertificate encode(FlatBufferBuilder& fbb, const Certificate& certificate) {
    std::vector<Offset<flatbuffers::String>> names;
    std::vector<double> values;
    for (const auto& [name, value] : certificate) {
        names.push_back(fbb.CreateSharedString(name));  // a library repeats them in every shape
        values.push_back(value);
    }
    const auto stored_names = fbb.CreateVector(names);
    return {stored_names, fbb.CreateVector(values)};
}

schema::MassProperties stored(const MassProperties& m) {
    const Quat& q = m.principal_axes;
    return {m.volume,
            stored(m.center_of_mass),
            {q.w(), q.x(), q.y(), q.z()},
            stored(m.principal_moments_per_density)};
}

Offset<schema::Shape> encode(FlatBufferBuilder& fbb, const ParticleTemplate& shape) {
    const schema::MassProperties mass = stored(shape.mass_properties);
    const EncodedCertificate certificate = encode(fbb, shape.certificate);
    const auto name = fbb.CreateString(shape.name);
    const auto mesh = encode(fbb, shape.display_mesh);
    const EncodedKind kind = std::visit(EncodeKind{fbb}, shape.shape);
    return schema::CreateShape(fbb, name, &mass, shape.bounding_radius,
                               shape.mean_squared_surface_distance, shape.is_convex, mesh,
                               certificate.names, certificate.values, kind.type, kind.data,
                               shape.input_unit);
}

Offset<schema::Shape> encode(FlatBufferBuilder& fbb, const WallTemplate& wall) {
    const schema::MassProperties none = stored(MassProperties{});
    const EncodedCertificate certificate = encode(fbb, wall.certificate);
    const auto name = fbb.CreateString(wall.name);
    const WallMesh& mesh = wall.mesh;
    const auto vertices = structs<schema::Vec3>(fbb, mesh.vertices);
    const auto triangles = structs<schema::Triangle>(fbb, mesh.triangles);
    const auto twins = scalars(fbb, mesh.twins);
    const auto bends = scalars(fbb, mesh.bends);
    const auto patches = scalars(fbb, mesh.patches);
    const auto blends = scalars(fbb, mesh.blends);
    const auto boxes = structs<schema::WallBox>(fbb, mesh.boxes);
    const auto data = schema::CreateWallMesh(fbb, vertices, triangles, twins, bends, patches,
                                             blends, boxes, mesh.crease_angle);
    return schema::CreateShape(fbb, name, &none, 0.0, 0.0, false, 0, certificate.names,
                               certificate.values, schema::ShapeData_WallMesh, data.Union(),
                               wall.input_unit);
}

template <class T>
std::uint64_t byte_size(const SharedArray<T>& values) {
    return values.size() * sizeof(T);
}

/// An upper bound of what one shape adds to the payload [bytes].
std::uint64_t largest_size(const ParticleTemplate& shape) {
    std::uint64_t size = 2048 + shape.name.size();  // tables, alignment, places in vectors
    for (const auto& entry : shape.certificate) size += 64 + entry.first.size();
    size += byte_size(shape.display_mesh.vertices) + byte_size(shape.display_mesh.triangles);
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) {
        size += byte_size(sr->support.pieces) + byte_size(sr->support.piece_end) +
                byte_size(sr->support.first_piece) + byte_size(sr->sdf.cells) +
                byte_size(sr->sdf.values) + byte_size(sr->curvature) + byte_size(sr->nodes.nodes) +
                byte_size(sr->nodes.blocks) + byte_size(sr->nodes.super_blocks) +
                byte_size(sr->nodes.stencil);
    }
    if (const auto* convex = std::get_if<ConvexShape>(&shape.shape)) {
        size += byte_size(convex->vertices) + byte_size(convex->face_begin) +
                byte_size(convex->face_vertices);
    }
    if (const auto* clump = std::get_if<Clump>(&shape.shape))
        size += byte_size(clump->spheres) + byte_size(clump->balls);
    return size;
}

std::uint64_t largest_size(const WallTemplate& wall) {
    std::uint64_t size = 2048 + wall.name.size();
    for (const auto& entry : wall.certificate) size += 64 + entry.first.size();
    const WallMesh& mesh = wall.mesh;
    return size + byte_size(mesh.vertices) + byte_size(mesh.triangles) + byte_size(mesh.twins) +
           byte_size(mesh.bends) + byte_size(mesh.patches) + byte_size(mesh.blends) +
           byte_size(mesh.boxes);
}

/// What the file's own tables add to the payload, at most [bytes].
std::uint64_t frame_size(std::size_t shapes) {
    constexpr std::uint64_t texts = 1 << 16;  // command line and version
    return texts + shapes * sizeof(flatbuffers::uoffset_t);
}

}  // namespace

struct TemplateBuilder::Encoder {
    FlatBufferBuilder fbb{1 << 16};
    std::vector<Offset<schema::Shape>> shapes;
    std::size_t count = 0;

    template <class Template>
    void add(const Template& shape) {
        // The builder itself only asserts that it stays within its limit.
        if (fbb.GetSize() + largest_size(shape) + frame_size(count) > largest_template_payload) {
            throw Error("shape " + std::to_string(shapes.size()) + " of " + std::to_string(count) +
                        ": the template exceeds the 2 GB that one file can hold, split the library "
                        "or lower the resolution");
        }
        shapes.push_back(encode(fbb, shape));
    }
};

TemplateBuilder::TemplateBuilder(std::size_t count) : encoder_(std::make_unique<Encoder>()) {
    encoder_->count = count;
    encoder_->shapes.reserve(count);
}

TemplateBuilder::~TemplateBuilder() = default;

std::uint64_t TemplateBuilder::byte_size() const {
    return encoder_->fbb.GetSize();
}

void TemplateBuilder::add(const ParticleTemplate& shape) {
    encoder_->add(shape);
}
void TemplateBuilder::add(const WallTemplate& wall) {
    encoder_->add(wall);
}

flatbuffers::DetachedBuffer TemplateBuilder::finish(const TemplateFile& content) {
    auto& [fbb, shapes, count] = *encoder_;
    const auto command = fbb.CreateString(content.command);
    const auto version = fbb.CreateString(content.shapegen_version);
    const auto all = fbb.CreateVector(shapes);
    fbb.Finish(schema::CreateTemplateFile(fbb, command, content.input_hash, version, all));
    return fbb.Release();
}

void TemplateBuilder::write(const std::filesystem::path& path, const TemplateFile& content) {
    const flatbuffers::DetachedBuffer payload = finish(content);
    const auto bytes = std::as_bytes(std::span(payload.data(), payload.size()));
    AtomicFile file(path);
    file.write(template_header(bytes));
    file.write(bytes);
    file.commit();
}

flatbuffers::DetachedBuffer encode_template(const TemplateFile& content) {
    TemplateBuilder builder(content.shapes.size());
    for (const ParticleTemplate& shape : content.shapes) builder.add(shape);
    return builder.finish(content);
}

void write_template(const std::filesystem::path& path, const TemplateFile& content) {
    if (content.shapes.empty()) throw Error(path.string(), "no shape to write");
    for (std::size_t i = 0; i < content.shapes.size(); ++i) {
        check_template(content.shapes[i], shape_place(path.string(), i, content.shapes[i].name));
    }
    TemplateBuilder builder(content.shapes.size());
    for (const ParticleTemplate& shape : content.shapes) builder.add(shape);
    builder.write(path, content);
}

void write_template(const std::filesystem::path& path, const TemplateFile& head,
                    const WallTemplate& wall) {
    check_wall(wall, shape_place(path.string(), 0, wall.name));
    TemplateBuilder builder(1);
    builder.add(wall);
    builder.write(path, head);
}

}  // namespace dem
