// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_reader.hpp"

#include "common/error.hpp"
#include "common/shapes/mass_properties.hpp"
#include "common/shapes/support_bounds.hpp"
#include "formats/memory_map.hpp"
#include "formats/template_check.hpp"
#include "formats/template_header.hpp"
#include "formats/template_layout.hpp"

#include <algorithm>
#include <cstdint>

namespace dem {

namespace {

/// Turns verified tables into our structs, whose arrays point into the buffer.
class Decoder {
  public:
    /// `where` names the shape in messages.
    Decoder(std::shared_ptr<const void> owner, const std::string& where)
        : owner_(std::move(owner)), where_(where) {}

    ParticleTemplate decode(const schema::Shape& shape) const {
        ParticleTemplate result;
        result.name = shape.name()->str();
        result.mass_properties = decode(*shape.mass_properties());
        result.bounding_radius = shape.bounding_radius();
        result.mean_squared_surface_distance = shape.mean_squared_surface_distance();
        result.is_convex = shape.is_convex();
        if (const schema::DisplayMesh* mesh = shape.display_mesh()) {
            result.display_mesh = {array<Vec3>(mesh->vertices()),
                                   array<std::array<std::uint32_t, 3>>(mesh->triangles()),
                                   mesh->max_deviation()};
        }
        result.certificate = certificate(shape);
        result.input_unit = shape.input_unit();
        if (const schema::SphereShape* sphere = shape.data_as_SphereShape()) {
            result.shape = Sphere{sphere->radius()};
        } else if (const schema::SrShape* sr = shape.data_as_SrShape()) {
            result.shape = decode(*sr);
        } else if (const schema::ClumpShape* clump = shape.data_as_ClumpShape()) {
            const auto spheres = array<ClumpSphere>(clump->spheres());
            result.shape =
                Clump{spheres, array<Clump::Ball>(clump->balls()), largest_radius(spheres.span())};
        } else if (const schema::ConvexShape* convex = shape.data_as_ConvexShape()) {
            ConvexShape core = decode(*convex);
            core.bounding_radius = result.bounding_radius;
            core.equivalent_diameter = equivalent_diameter(result.mass_properties.volume);
            result.shape = std::move(core);
        } else if (shape.data_as_WallMesh() != nullptr) {
            throw Error(where_,
                        "is a wall made by shapegen --wall, expected a particle; walls go into "
                        "[wall.NAME] with shape = mesh");
        } else {
            throw Error(where_,
                        "is of a kind that this program does not know, expected sphere, sr, clump "
                        "or convex; make the template again or update the program");
        }
        return result;
    }

    WallTemplate decode_wall(const schema::Shape& shape) const {
        const schema::WallMesh* mesh = shape.data_as_WallMesh();
        if (mesh == nullptr) {
            throw Error(where_, "is a particle, expected a wall made by shapegen --wall");
        }
        WallTemplate result{shape.name()->str(), shape.input_unit(), certificate(shape), {}};
        WallMesh& wall = result.mesh;
        wall.vertices = array<Vec3>(mesh->vertices());
        wall.triangles = array<WallMesh::Triangle>(mesh->triangles());
        wall.twins = array<std::uint32_t>(mesh->twins());
        wall.bends = array<double>(mesh->bends());
        wall.patches = array<std::uint32_t>(mesh->patches());
        wall.blends = array<double>(mesh->blends());
        wall.boxes = array<WallMesh::Box>(mesh->boxes());
        wall.crease_angle = mesh->crease_angle();
        return result;
    }

  private:
    template <class Used, class Stored>
    SharedArray<Used> array(const flatbuffers::Vector<Stored>* values) const {
        using Element = std::remove_const_t<std::remove_pointer_t<Stored>>;
        static_assert(layout::agree<Element, Used>);
        if (values->size() == 0) return {};
        // The verifier aligns the length of a vector, not its elements.
        if (reinterpret_cast<std::uintptr_t>(values->Data()) % alignof(Used) != 0) {
            throw Error(where_,
                        "is damaged: an array lies at an odd place; make the template again");
        }
        return {owner_, std::span(reinterpret_cast<const Used*>(values->Data()), values->size())};
    }

    static Vec3 vector(const schema::Vec3& v) { return {v.x(), v.y(), v.z()}; }

    static MassProperties decode(const schema::MassProperties& m) {
        const schema::Quat& q = m.principal_axes();
        return {m.volume(), vector(m.center_of_mass()), Quat(q.w(), q.x(), q.y(), q.z()),
                vector(m.principal_moments_per_density())};
    }

    Certificate certificate(const schema::Shape& shape) const {
        Certificate result;
        if (shape.certificate_names() == nullptr && shape.certificate_values() == nullptr) {
            return result;
        }
        if (shape.certificate_names() == nullptr || shape.certificate_values() == nullptr ||
            shape.certificate_names()->size() != shape.certificate_values()->size()) {
            throw Error(where_,
                        "the certificate's names and values differ in number; make the template "
                        "again");
        }
        const SharedArray<double> values = array<double>(shape.certificate_values());
        for (flatbuffers::uoffset_t i = 0; i < values.size(); ++i) {
            result.emplace_back(shape.certificate_names()->Get(i)->str(), values[i]);
        }
        return result;
    }

    SrShape decode(const schema::SrShape& sr) const {
        const schema::SrDimensions& d = *sr.dimensions();
        SrShape result;
        result.is_convex = sr.is_convex();
        result.bottom_z = d.bottom_z();
        result.top_z = d.top_z();
        result.max_radius = d.max_radius();
        result.bounding_radius = d.bounding_radius();
        result.equivalent_diameter = d.equivalent_diameter();
        result.major_axis_length = d.major_axis_length();
        if (const schema::SupportMap* map = sr.support()) {
            result.support = {array<SupportPiece>(map->pieces()),
                              array<double>(map->piece_end()),
                              array<std::uint32_t>(map->first_piece()),
                              {}};
            result.support.bounds = support_bounds(result.support);
        }
        result.sdf = decode(*sr.sdf());
        result.curvature = array<CurvatureSample>(sr.curvature());
        if (const schema::SurfaceNodes* nodes = sr.nodes()) {
            result.nodes.count = nodes->count();
            result.nodes.nodes = array<SurfaceNodes::Node>(nodes->nodes());
            result.nodes.blocks = array<SurfaceNodes::Ball>(nodes->blocks());
            result.nodes.super_blocks = array<SurfaceNodes::Ball>(nodes->super_blocks());
            result.nodes.stencil = array<std::uint32_t>(nodes->stencil());
        }
        return result;
    }

    ConvexShape decode(const schema::ConvexShape& convex) const {
        const schema::ConvexDimensions& d = *convex.dimensions();
        ConvexShape result;
        result.core = static_cast<ConvexShape::Core>(convex.core());
        result.rounding = d.rounding();
        result.size = Vec3(d.size_x(), d.size_y(), d.size_z());
        result.low = d.low();
        result.vertices = array<Vec3>(convex.vertices());
        result.face_begin = array<std::uint32_t>(convex.face_begin());
        result.face_vertices = array<std::uint32_t>(convex.face_vertices());
        check_convex_faces(result, where_);
        index_core(result);
        return result;
    }

    SdfQuadtree decode(const schema::SdfQuadtree& sdf) const {
        const schema::SdfGrid& grid = *sdf.grid();
        SdfQuadtree result;
        result.origin_r = grid.origin_r();
        result.origin_z = grid.origin_z();
        result.base_size = grid.base_size();
        result.margin = grid.margin();
        result.lipschitz_slack = grid.lipschitz_slack();
        result.surface_slack = grid.surface_slack();
        result.surface_band = grid.surface_band();
        result.cells_r = grid.cells_r();
        result.cells_z = grid.cells_z();
        result.cells = array<SdfCell>(sdf.cells());
        result.values = array<double>(sdf.values());
        return result;
    }

    std::shared_ptr<const void> owner_;
    const std::string& where_;
};

/// The root table, once every offset and length in the payload is known to stay inside it.
const schema::TemplateFile& verified_root(std::span<const std::byte> payload,
                                          const std::string& where) {
    constexpr flatbuffers::uoffset_t max_depth = 16;
    // A table takes at least four bytes; the default limit would refuse a library of a million.
    const auto max_tables = static_cast<flatbuffers::uoffset_t>(payload.size() / 4);
    const auto* data = reinterpret_cast<const std::uint8_t*>(payload.data());
    if (payload.size() <= largest_template_payload) {
        flatbuffers::Verifier verifier(data, payload.size(), max_depth, max_tables);
        if (schema::VerifyTemplateFileBuffer(verifier)) return *schema::GetTemplateFile(data);
    }
    throw Error(where, "is damaged: its content is not that of a template, make it again");
}

}  // namespace

TemplateLibrary::TemplateLibrary(std::shared_ptr<const void> owner,
                                 std::span<const std::byte> bytes, std::string where)
    : owner_(std::move(owner)),
      where_(std::move(where)),
      root_(&verified_root(template_payload(bytes, where_), where_)) {
    if (size() == 0) throw Error(where_, "holds no shape, expected at least one; make it again");
}

TemplateLibrary::TemplateLibrary(const std::filesystem::path& path)
    : TemplateLibrary(std::make_shared<const MemoryMap>(path, "template made by shapegen"),
                      path.string()) {}

TemplateLibrary::TemplateLibrary(const std::shared_ptr<const MemoryMap>& map, std::string where)
    : TemplateLibrary(map, map->bytes(), std::move(where)) {}

std::size_t TemplateLibrary::size() const {
    return root_->shapes()->size();
}

std::string TemplateLibrary::name(std::size_t index) const {
    return root_->shapes()->Get(static_cast<flatbuffers::uoffset_t>(index))->name()->str();
}

ParticleTemplate TemplateLibrary::shape(std::size_t index) const {
    const std::string place = shape_place(where_, index, name(index));
    const schema::Shape& shape = *root_->shapes()->Get(static_cast<flatbuffers::uoffset_t>(index));
    ParticleTemplate result = Decoder(owner_, place).decode(shape);
    check_template(result, place);
    return result;
}

bool TemplateLibrary::is_wall(std::size_t index) const {
    return root_->shapes()->Get(static_cast<flatbuffers::uoffset_t>(index))->data_type() ==
           schema::ShapeData_WallMesh;
}

WallTemplate TemplateLibrary::wall(std::size_t index) const {
    const std::string place = shape_place(where_, index, name(index));
    const schema::Shape& shape = *root_->shapes()->Get(static_cast<flatbuffers::uoffset_t>(index));
    WallTemplate result = Decoder(owner_, place).decode_wall(shape);
    check_wall(result, place);
    index_wall(result.mesh);
    return result;
}

TemplateFile TemplateLibrary::head() const {
    TemplateFile result;
    result.command = root_->command()->str();
    result.input_hash = root_->input_hash();
    result.shapegen_version = root_->shapegen_version()->str();
    return result;
}

namespace {

TemplateFile all_of(const TemplateLibrary& library) {
    TemplateFile result = library.head();
    result.shapes.reserve(library.size());
    for (std::size_t k = 0; k < library.size(); ++k) result.shapes.push_back(library.shape(k));
    return result;
}

}  // namespace

TemplateFile read_template(const std::shared_ptr<const void>& owner,
                           std::span<const std::byte> bytes, const std::string& where) {
    return all_of(TemplateLibrary(owner, bytes, where));
}

TemplateFile read_template(const std::filesystem::path& path) {
    return all_of(TemplateLibrary(path));
}

}  // namespace dem
