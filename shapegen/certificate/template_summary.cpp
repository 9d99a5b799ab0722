// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/certificate/template_summary.hpp"

#include "common/format.hpp"
#include "common/units.hpp"
#include "shapegen/certificate/certificate_text.hpp"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <map>

#include <nlohmann/json.hpp>

namespace dem::shapegen {

namespace {

using Json = nlohmann::ordered_json;

constexpr int json_schema = 1;  // raised when a name in the JSON changes its meaning or goes

struct Counts {
    std::uint64_t nodes = 0, spheres = 0, vertices = 0, triangles = 0, cells = 0;
};

Counts counts(const ParticleTemplate& shape) {
    Counts n;
    n.vertices = shape.display_mesh.vertices.size();
    n.triangles = shape.display_mesh.triangles.size();
    if (std::holds_alternative<Sphere>(shape.shape)) n.spheres = 1;
    if (const auto* clump = std::get_if<Clump>(&shape.shape)) n.spheres = clump->spheres.size();
    if (const auto* convex = std::get_if<ConvexShape>(&shape.shape)) {
        if (n.vertices == 0) n.vertices = convex->vertices.size();
    }
    if (const auto* sr = std::get_if<SrShape>(&shape.shape)) {
        n.nodes = sr->nodes.count;
        for (const SdfCell& cell : sr->sdf.cells) n.cells += std::uint64_t{1} << 2 * cell.level;
    }
    return n;
}

std::string hash_text(std::uint64_t hash) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016" PRIx64, hash);
    return digits;
}

/// Three entries name_x, name_y, name_z follow one another: a vector.
bool is_vector_at(const Certificate& certificate, std::size_t i) {
    if (i + 3 > certificate.size()) return false;
    const std::string& name = certificate[i].first;
    if (!name.ends_with("_x")) return false;
    const std::string stem = name.substr(0, name.size() - 1);
    return certificate[i + 1].first == stem + 'y' && certificate[i + 2].first == stem + 'z';
}

/// The entries in order, those of a vector as an array under their common name.
Json certificate_json(const Certificate& certificate) {
    Json json = Json::object();
    for (std::size_t i = 0; i < certificate.size(); ++i) {
        const auto& [name, value] = certificate[i];
        if (is_vector_at(certificate, i)) {
            json[name.substr(0, name.size() - 2)] = {value, certificate[i + 1].second,
                                                     certificate[i + 2].second};
            i += 2;
        } else {
            json[name] = value;
        }
    }
    return json;
}

Json json_of(const ParticleTemplate& shape) {
    const MassProperties& mass = shape.mass_properties;
    const Vec3& c = mass.center_of_mass;
    const Vec3& moments = mass.principal_moments_per_density;
    const Quat& q = mass.principal_axes;
    const Counts n = counts(shape);
    return {{"name", shape.name},
            {"kind", kind_name(shape)},
            {"volume", mass.volume},
            {"center_of_mass", {c.x(), c.y(), c.z()}},
            {"rotation", {q.w(), q.x(), q.y(), q.z()}},
            {"principal_moments_per_density", {moments.x(), moments.y(), moments.z()}},
            {"bounding_radius", shape.bounding_radius},
            {"mean_squared_surface_distance", shape.mean_squared_surface_distance},
            {"convex", shape.is_convex},
            {"input_unit", shape.input_unit},
            {"counts",
             {{"nodes", n.nodes},
              {"spheres", n.spheres},
              {"vertices", n.vertices},
              {"triangles", n.triangles},
              {"cells", n.cells}}},
            {"certificate", certificate_json(shape.certificate)}};
}

std::string core_text(const ConvexShape& shape, const LengthUnit& unit) {
    const std::string rounding = shape.rounding > 0.0
                                     ? format(", and all within %.6g %s of it\n",
                                              shape.rounding / unit.meters, unit.name.c_str())
                                     : std::string("\n");
    switch (shape.core) {
        case ConvexShape::Core::ellipsoid:
            return "  core              ellipsoid" + rounding;
        case ConvexShape::Core::cylinder:
            return "  core              cylinder" + rounding;
        case ConvexShape::Core::cone:
            return "  core              cone" + rounding;
        case ConvexShape::Core::polyhedron:
            break;
    }
    return format("  core              polyhedron, vertices: %zu, faces: %zu",
                  shape.vertices.size(), shape.face_count()) +
           rounding;
}

/// Volume, place, orientation, moments, size.
std::string mass_text(const ParticleTemplate& shape, const LengthUnit& unit) {
    const MassProperties& mass = shape.mass_properties;
    const char* name = unit.name.c_str();
    std::string text = format("  volume            %.7g %s^3 (sphere of equal volume: %.6g %s)\n",
                              mass.volume / cube(unit.meters), name,
                              equivalent_diameter(mass.volume) / unit.meters, name);
    // What rounding leaves of a zero is shown as zero; --json has every digit.
    const auto shown = [](double x, double size) { return std::abs(x) < 1e-12 * size ? 0.0 : x; };
    const Vec3& c = mass.center_of_mass;
    const auto place = [&](double x) { return shown(x, shape.bounding_radius) / unit.meters; };
    text += format("  center of mass    %.6g %.6g %.6g %s, in the input's frame\n", place(c.x()),
                   place(c.y()), place(c.z()), name);
    const Quat& q = mass.principal_axes;
    text +=
        format("  rotation          %.6g %.6g %.6g %.6g (w x y z), from body to input's frame\n",
               shown(q.w(), 1.0), shown(q.x(), 1.0), shown(q.y(), 1.0), shown(q.z(), 1.0));
    const Vec3& moments = mass.principal_moments_per_density;
    text += format("  principal moments %.7g %.7g %.7g m^5, times the density\n", moments.x(),
                   moments.y(), moments.z());
    return text +
           format("  bounding radius   %.6g %s\n", shape.bounding_radius / unit.meters, name);
}

std::string text_of(const ParticleTemplate& shape) {
    const LengthUnit unit = length_unit(2.0 * shape.bounding_radius);
    const Counts n = counts(shape);
    const auto* convex = std::get_if<ConvexShape>(&shape.shape);
    std::string text = shape.name + ": " + kind_name(shape);
    text += convex != nullptr ? "\n" : shape.is_convex ? ", convex\n" : ", not convex\n";
    if (convex != nullptr) text += core_text(*convex, unit);
    text += mass_text(shape, unit);
    if (std::holds_alternative<Clump>(shape.shape))
        text += format("  spheres           %" PRIu64 "\n", n.spheres);
    if (n.nodes > 0) text += format("  surface nodes     %" PRIu64 "\n", n.nodes);
    if (n.cells > 0) text += format("  distance cells    %" PRIu64 "\n", n.cells);
    if (n.triangles > 0) text += format("  display triangles %" PRIu64 "\n", n.triangles);
    const bool is_sr = std::holds_alternative<SrShape>(shape.shape);
    if (!shape.certificate.empty()) {
        text += "  measured errors   (";
        text += is_sr ? "l: major axis" : "d_eq: diameter of the sphere of equal volume";
        text += "; names and every digit: --json)\n";
    }
    for (const auto& [name, value] : shape.certificate)
        text += certificate_line(name, value, is_sr ? "l" : "d_eq");
    return text;
}

Json json_of(const TemplateFile& file, const Json& shapes) {
    return {{"schema", json_schema},
            {"command", file.command},
            {"shapegen_version", file.shapegen_version},
            {"input_hash", hash_text(file.input_hash)},
            {"shapes", shapes}};
}

/// Names come from file names, which need not be UTF-8; JSON must be.
std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string made_by(const TemplateFile& file) {
    return "made by           " + file.command + " (shapegen " + file.shapegen_version +
           ", input " + hash_text(file.input_hash) + ")\n";
}

std::string range_text(const TemplateFile& file) {
    const auto [smallest, largest] = std::minmax_element(
        file.shapes.begin(), file.shapes.end(), [](const auto& a, const auto& b) {
            return a.mass_properties.volume < b.mass_properties.volume;
        });
    const LengthUnit unit = length_unit(2.0 * largest->bounding_radius);
    const auto volume = [&](const ParticleTemplate& shape) {
        return shape.mass_properties.volume / cube(unit.meters);
    };
    return format("volumes from %.6g %s^3 (%s) to %.6g %s^3 (%s)\n", volume(*smallest),
                  unit.name.c_str(), smallest->name.c_str(), volume(*largest), unit.name.c_str(),
                  largest->name.c_str());
}

}  // namespace

std::string template_text(const TemplateFile& file) {
    constexpr std::size_t shown_at_most = 10;
    const std::size_t count = file.shapes.size();
    std::string text = made_by(file);
    if (count > shown_at_most) {
        text += std::to_string(count) + " shapes, the first three shown (--json shows all); " +
                range_text(file);
    }
    const std::size_t shown = count > shown_at_most ? 3 : count;
    for (std::size_t i = 0; i < shown; ++i) text += text_of(file.shapes[i]);
    return text;
}

std::string template_json(const TemplateFile& file) {
    Json shapes = Json::array();
    for (const ParticleTemplate& shape : file.shapes) shapes.push_back(json_of(shape));
    return text_of(json_of(file, shapes));
}

std::string template_text(const TemplateFile& file, const WallTemplate& wall) {
    const WallMesh& mesh = wall.mesh;
    const Vec3 size = mesh.bounds.upper - mesh.bounds.lower;
    const LengthUnit unit = length_unit(size.norm());
    std::map<std::string, double> values(wall.certificate.begin(), wall.certificate.end());
    const auto count = [&](const char* name) { return values[name]; };
    return made_by(file) +
           format(
               "%s: wall\n"
               "  triangles         %zu, corners: %zu, area: %.6g %s^2\n"
               "  size              %.6g x %.6g x %.6g %s\n"
               "  pieces            %.0f, %s\n"
               "  patches           %.0f, between edges that bend by more than %.4g deg: %.0f\n"
               "  bending edges     %.0f convex and %.0f concave, seen from the front\n",
               wall.name.c_str(), mesh.triangles.size(), mesh.vertices.size(),
               count("area") / square(unit.meters), unit.name.c_str(), size.x() / unit.meters,
               size.y() / unit.meters, size.z() / unit.meters, unit.name.c_str(), count("pieces"),
               count("rim_edges") == 0.0
                   ? "closed"
                   : format("open, with %.0f edges at rims", count("rim_edges")).c_str(),
               count("patches"), mesh.crease_angle * 180.0 / pi, count("crease_edges"),
               count("convex_edges"), count("concave_edges"));
}

std::string template_json(const TemplateFile& file, const WallTemplate& wall) {
    const Aabb& box = wall.mesh.bounds;
    const Json shape = {
        {"name", wall.name},
        {"kind", "wall"},
        {"input_unit", wall.input_unit},
        {"lower", {box.lower.x(), box.lower.y(), box.lower.z()}},
        {"upper", {box.upper.x(), box.upper.y(), box.upper.z()}},
        {"crease_angle", wall.mesh.crease_angle},
        {"counts",
         {{"vertices", wall.mesh.vertices.size()}, {"triangles", wall.mesh.triangles.size()}}},
        {"certificate", certificate_json(wall.certificate)}};
    return text_of(json_of(file, Json::array({shape})));
}

}  // namespace dem::shapegen
