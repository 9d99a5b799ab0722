// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_check.hpp"

#include "common/text.hpp"
#include "formats/value_check.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace dem {

namespace {

constexpr double largest_body = 1e6;  // [m], as everywhere: squares of squares do not overflow

void check_mass_properties(const MassProperties& mass, const ValueCheck& check) {
    check.positive(mass.volume, "volume");
    check.finite(mass.center_of_mass, "center of mass");
    const Quat& q = mass.principal_axes;
    const double norm = q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z();
    check.require(std::abs(norm - 1.0) <= 1e-9, "the principal axes are not a unit quaternion");
    const Vec3& moments = mass.principal_moments_per_density;
    for (int i = 0; i < 3; ++i) check.positive(moments[i], "principal moment");
    // A thin plate reaches equality; rounding may then fall on either side.
    check.require(2.0 * moments.maxCoeff() <= moments.sum() * (1.0 + 1e-9),
                  "the principal moments break the triangle inequality, no solid has them");
}

void check_display_mesh(const DisplayMesh& mesh, double bounding_radius, const ValueCheck& check) {
    check.not_negative(mesh.max_deviation, "deviation of the display mesh");
    // A decimated surface may stand out by its deviation.
    const double limit = check.slack * (bounding_radius + mesh.max_deviation);
    for (const Vec3& v : mesh.vertices) {
        check.require(v.squaredNorm() <= limit * limit,
                      "a vertex of the display mesh lies outside the bounding radius");
    }
    for (const auto& triangle : mesh.triangles) {
        check.require(std::max({triangle[0], triangle[1], triangle[2]}) < mesh.vertices.size(),
                      "a triangle of the display mesh names a vertex that does not exist");
    }
}

void check_name(const std::string& name, const ValueCheck& check) {
    check.require(std::none_of(name.begin(), name.end(),
                               [](unsigned char c) { return std::iscntrl(c) != 0; }),
                  "the name holds control characters");
}

void check_certificate(const Certificate& certificate, const ValueCheck& check) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : certificate) {
        check.require(!name.empty(), "an entry of the certificate has no name");
        check.finite(value, "certificate");
        names.emplace_back(name);
    }
    std::sort(names.begin(), names.end());
    check.require(std::adjacent_find(names.begin(), names.end()) == names.end(),
                  "the certificate has two entries of one name");
}

struct CheckKind {
    const ParticleTemplate& shape;
    const ValueCheck& check;

    void operator()(const Sphere& sphere) const {
        check.positive(sphere.radius, "radius");
        check.require(sphere.radius <= shape.bounding_radius * check.slack,
                      "the radius exceeds the bounding radius");
        check.require(shape.is_convex, "a sphere is not marked convex");
    }
    void operator()(const SrShape& sr) const {
        check.require(sr.is_convex == shape.is_convex, "the two marks of convexity differ");
        check_sr_shape(sr, shape.bounding_radius, shape.mass_properties.volume, check.where);
    }
    void operator()(const Clump& clump) const {
        check_clump(clump, shape.bounding_radius, shape.mass_properties.volume, check.where);
    }
    void operator()(const ConvexShape& convex) const {
        check.require(shape.is_convex, "a convex shape is not marked convex");
        check_convex_faces(convex, check.where);
        check_convex_shape(convex, shape.bounding_radius, shape.mass_properties.volume,
                           check.where);
    }
};

}  // namespace

std::string shape_place(const std::string& where, std::size_t index, const std::string& name) {
    return where + ": shape " + std::to_string(index) + " " + in_quotes(name);
}

void check_template(const ParticleTemplate& shape, const std::string& where) {
    const ValueCheck check{where};
    check_name(shape.name, check);
    check.positive(shape.bounding_radius, "bounding radius");
    check.require(shape.bounding_radius <= largest_body, "the body is larger than 1e6 m");
    check_mass_properties(shape.mass_properties, check);
    check.require(
        shape.mass_properties.volume <= 4.0 / 3.0 * pi * cube(shape.bounding_radius) * check.slack,
        "the volume exceeds that of the bounding sphere");
    check.positive(shape.mean_squared_surface_distance, "mean squared surface distance");
    check.require(
        shape.mean_squared_surface_distance <= square(shape.bounding_radius) * check.slack,
        "the mean squared surface distance exceeds the square of the bounding radius");
    check_display_mesh(shape.display_mesh, shape.bounding_radius, check);
    check_certificate(shape.certificate, check);
    check.positive(shape.input_unit, "unit of the input");
    std::visit(CheckKind{shape, check}, shape.shape);
}

void check_wall(const WallTemplate& wall, const std::string& where) {
    const ValueCheck check{where};
    check_name(wall.name, check);
    check_certificate(wall.certificate, check);
    check.positive(wall.input_unit, "unit of the input");
    check_wall_mesh(wall.mesh, where);
}

}  // namespace dem
