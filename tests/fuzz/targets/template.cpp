// SPDX-License-Identifier: BSD-3-Clause
// Templates: the bytes as they are, and once more under a header that fits what follows it, so that
// mutants get past the checksum.
#include "common/shapes/surface_distance.hpp"
#include "common/state_hash.hpp"
#include "formats/template_reader.hpp"
#include "shapegen/certificate/template_summary.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>

namespace dem::fuzz {

using namespace shapegen;

namespace {

template <class T>
void walk(const SharedArray<T>& array, StateHash& hash) {
    promise(reinterpret_cast<std::uintptr_t>(array.data()) % alignof(T) == 0,
            "arrays of a template are aligned");
    hash.add_bytes(std::as_bytes(array.span()));
}

/// Every byte of every array, so that the address sanitizer sees a view that leaves the file.
void walk(const ParticleTemplate& t) {
    StateHash hash;
    walk(t.display_mesh.vertices, hash);
    walk(t.display_mesh.triangles, hash);
    if (const auto* sr = std::get_if<SrShape>(&t.shape)) {
        walk(sr->support.pieces, hash);
        walk(sr->support.piece_end, hash);
        walk(sr->support.first_piece, hash);
        walk(sr->sdf.cells, hash);
        walk(sr->sdf.values, hash);
        walk(sr->curvature, hash);
        walk(sr->nodes.nodes, hash);
        walk(sr->nodes.blocks, hash);
        walk(sr->nodes.super_blocks, hash);
        walk(sr->nodes.stencil, hash);
    } else if (const auto* convex = std::get_if<ConvexShape>(&t.shape)) {
        walk(convex->vertices, hash);
        walk(convex->face_begin, hash);
        walk(convex->face_vertices, hash);
        walk(convex->neighbors, hash);
    } else if (const auto* clump = std::get_if<Clump>(&t.shape)) {
        walk(clump->spheres, hash);
        walk(clump->balls, hash);
    }
}

void look_at(const TemplateFile& file) {
    promise(!file.shapes.empty(), "a template holds shapes");
    for (const ParticleTemplate& t : file.shapes) {
        walk(t);
        promise_positive(t.bounding_radius, "a bounding radius");
        promise_positive(t.mass_properties.volume, "a volume");
        for (int i = 0; i < 3; ++i)
            promise_positive(t.mass_properties.principal_moments_per_density[i], "a moment");
        const double far = 2.0 * t.bounding_radius;
        for (const Vec3& x : {Vec3(0, 0, 0), Vec3(far, 0, 0), Vec3(0, 0, -0.3 * far)}) {
            const SurfaceDistance surface = surface_distance(t, x);
            promise_finite(surface.distance, "a distance");
            promise_finite(surface.normal, "a normal");
        }
    }
    promise(!template_json(file).empty(), "inspect --json prints");
    TemplateFile nameless = file;  // names and commands may hold any letters
    nameless.command.clear();
    nameless.shapegen_version.clear();
    for (ParticleTemplate& t : nameless.shapes) {
        t.name.clear();
        for (auto& [name, value] : t.certificate) name.clear();
    }
    promise(template_text(nameless).find("nan") == std::string::npos, "inspect prints numbers");
}

void look_at(const TemplateFile& head, const WallTemplate& wall) {
    const WallMesh& mesh = wall.mesh;
    StateHash hash;
    walk(mesh.vertices, hash);
    walk(mesh.triangles, hash);
    walk(mesh.twins, hash);
    walk(mesh.bends, hash);
    walk(mesh.patches, hash);
    walk(mesh.blends, hash);
    walk(mesh.boxes, hash);
    promise(!mesh.triangles.empty(), "a wall has triangles");
    const double size = (mesh.bounds.upper - mesh.bounds.lower).norm();
    promise_positive(size, "the size of a wall");
    const Vec3 middle = 0.5 * (mesh.bounds.lower + mesh.bounds.upper);
    for (const Vec3& x : {middle, mesh.bounds.lower, Vec3(middle + Vec3(0.0, 0.0, 2.0 * size))}) {
        promise_finite(distance_within(mesh, x, 4.0 * size), "a distance");
        promise(first_crossed(mesh, x, mesh.bounds.upper) <= mesh.triangles.size(),
                "a crossed triangle is one");
    }
    promise(!template_json(head, wall).empty(), "inspect --json prints");
}

}  // namespace

bool reads_template(Bytes bytes) {
    static const std::array<std::string, 1> places = {"x.tpl: "};
    sample::Bytes copy(bytes.size());
    if (!bytes.empty()) std::memcpy(copy.bytes.data(), bytes.data(), bytes.size());
    return accepts(places, [&] {
        const TemplateLibrary library(copy.memory, copy.bytes, "x.tpl");
        if (library.is_wall(0)) return look_at(library.head(), library.wall(0));
        look_at(read_template(copy.memory, copy.bytes, "x.tpl"));
    });
}

}  // namespace dem::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    using namespace dem;
    using namespace dem::shapegen;
    const fuzz::Bytes bytes(data, size);
    fuzz::reads_template(bytes);
    fuzz::reads_template(sample::sealed(bytes.subspan(std::min(size, template_header_size))).bytes);
    return 0;
}

/// The mutator of libFuzzer; nothing but a fuzzer has it.
extern "C" std::size_t LLVMFuzzerMutate(std::byte* data, std::size_t size, std::size_t most)
    __attribute__((weak));

/// Mutants of templates that this program writes, whatever the corpus holds: one in a thousand
/// begins anew. FlatBuffers read from the end, so that a mutant that grows in the middle is lost.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::byte* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    using namespace dem;
    using namespace dem::shapegen;
    if (size < template_header_size || seed % 1000 == 0) {
        TemplateFile file = sample::file();
        std::swap(file.shapes[0], file.shapes[seed / 1000 % file.shapes.size()]);
        file.shapes.resize(1);
        const sample::Bytes fresh = sample::unchecked(file);
        if (fresh.bytes.size() > most) return size;
        std::memcpy(data, fresh.bytes.data(), fresh.bytes.size());
        return fresh.bytes.size();
    }
    // The header is repaired anyway: spare it nine times out of ten.
    const std::size_t spared = seed % 10 == 0 ? 0 : template_header_size;
    return spared + LLVMFuzzerMutate(data + spared, size - spared, most - spared);
}
