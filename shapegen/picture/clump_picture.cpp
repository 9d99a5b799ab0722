// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/clump_picture.hpp"

#include "common/math/rotation.hpp"
#include "common/units.hpp"
#include "shapegen/picture/clump_surface.hpp"
#include "shapegen/picture/cross_section_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace dem::shapegen {

namespace {

constexpr std::size_t most_triangles = 60'000;  // browsers draw more only slowly

/// Columns: to the right, up, towards the eye.
Mat3 camera(const Vec3& moments) {
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return moments[a] < moments[b]; });
    Mat3 axes;
    axes.col(0) = Vec3::Unit(order[0]);
    axes.col(1) = Vec3::Unit(order[1]);
    axes.col(2) = axes.col(0).cross(axes.col(1));
    const double tilt = 0.4;  // [rad]: shows three sides
    const Quat turn = rotation_about(Vec3::UnitX(), tilt) * rotation_about(Vec3::UnitY(), -tilt);
    return axes * turn.toRotationMatrix().transpose();
}

/// Blue for -1, nearly white for 0, red for 1; `light` from 0 to 1.
std::string color(double value, double light) {
    const double v = std::clamp(value, -1.0, 1.0);
    const Vec3 end = v < 0.0 ? Vec3(0.10, 0.30, 0.75) : Vec3(0.80, 0.12, 0.10);
    const Vec3 rgb = (Vec3::Constant(0.96) + std::abs(v) * (end - Vec3::Constant(0.96))) * light;
    std::array<char, 8> text{};
    const auto byte = [](double x) { return static_cast<unsigned>(std::lround(255.0 * x)); };
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(rgb.x()), byte(rgb.y()),
                  byte(rgb.z()));
    return text.data();
}

/// The triangles that face the eye, far ones first.
void draw_surface(SvgPage& page, const PanelBox& box, const ColoredMesh& mesh, const Mat3& eye,
                  const Vec2& scales) {
    const double pixels = scales[0];
    const double full_color = scales[1];
    struct Face {
        double depth;
        std::size_t triangle;
    };
    std::vector<Vec3> seen;
    for (const Vec3& p : mesh.vertices) seen.emplace_back(eye.transpose() * p);
    std::vector<Face> faces;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if ((seen[b] - seen[a]).cross(seen[c] - seen[a]).z() > 0.0)
            faces.push_back({seen[a].z() + seen[b].z() + seen[c].z(), t});
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.triangle < b.triangle;
    });
    const Vec3 light = Vec3(-0.4, 0.6, 0.7).normalized();
    const Vec2 middle = box.corner + 0.5 * box.size;
    for (const Face& face : faces) {
        const auto& [a, b, c] = mesh.triangles[face.triangle];
        const Vec3 normal = (seen[b] - seen[a]).cross(seen[c] - seen[a]).normalized();
        const double value = (mesh.values[a] + mesh.values[b] + mesh.values[c]) / 3.0;
        const std::string fill =
            color(value / full_color, 0.55 + 0.45 * std::max(normal.dot(light), 0.0));
        std::array<Vec2, 3> corners;
        std::size_t n = 0;
        for (const std::uint32_t i : {a, b, c})
            corners[n++] = middle + pixels * Vec2(seen[i].x(), -seen[i].y());
        // The stroke closes the hairlines between neighbors.
        page.polyline(corners, {.stroke = fill, .width = 0.5, .fill = fill}, true);
    }
}

void draw_color_bar(SvgPage& page, const Vec2& corner, double full_color, const LengthUnit& unit) {
    constexpr int steps = 41;
    const double width = 8.0;
    for (int i = 0; i < steps; ++i) {
        const double value = 2.0 * i / (steps - 1) - 1.0;
        page.rectangle(corner + Vec2(width * i, 0.0), {width + 0.5, 14.0},
                       {.fill = color(value, 1.0)});
    }
    const std::string end = short_number(full_color / unit.meters, 2) + " " + unit.name;
    page.text(corner + Vec2(0.0, 32.0), "short by " + end, 13);
    page.text(corner + Vec2(0.5 * width * steps, 32.0), "0", 13, Anchor::middle);
    page.text(corner + Vec2(width * steps, 32.0), "out by " + end, 13, Anchor::end);
}

/// The deviation that gets the full color: that of all but the worst 2 % of the body's vertices.
double color_range(const ColoredMesh& body, double size) {
    std::vector<double> sizes;
    for (const double v : body.values) sizes.push_back(std::abs(v));
    std::sort(sizes.begin(), sizes.end());
    const double bulk = sizes.empty() ? 0.0 : sizes[(sizes.size() - 1) * 98 / 100];
    return std::max(bulk, 1e-6 * size);
}

std::string measured(const ParticleTemplate& shape) {
    const auto entry = [&shape](const std::string& name) {
        for (const auto& [key, value] : shape.certificate)
            if (key == name) return value;
        return 0.0;
    };
    return "coverage " + short_number(100.0 * entry("coverage"), 4) + " %, outside " +
           short_number(100.0 * entry("outside"), 3) + " %; deviation RMS " +
           short_number(100.0 * entry("rms_deviation"), 3) + " %, at most " +
           short_number(100.0 * entry("max_deviation_in"), 3) + " % in and " +
           short_number(100.0 * entry("max_deviation_out"), 3) + " % out; drawn within " +
           short_number(100.0 * entry("display_mesh_error_max"), 2) + " %, of d_eq = ";
}

}  // namespace

std::string clump_picture(const ParticleTemplate& shape) {
    const ColoredMesh body = body_surface(shape);
    const ColoredMesh clump = clump_surface(shape, most_triangles);
    const double d_eq = equivalent_diameter(shape.mass_properties.volume);
    const LengthUnit unit = length_unit(d_eq);
    const double full_color = color_range(body, d_eq);
    const Mat3 eye = camera(shape.mass_properties.principal_moments_per_density);
    SvgPage page(1240.0, 720.0);
    page.text({40, 42}, shape.name, 24, Anchor::start, true);
    page.text({40, 66},
              std::to_string(std::get<Clump>(shape.shape).spheres.size()) + " spheres; " +
                  measured(shape) + short_number(d_eq / unit.meters, 4) + " " + unit.name,
              14);
    const Vec2 size(570.0, 540.0);
    const double pixels = 0.5 * size.minCoeff() / shape.bounding_radius;
    page.text({60, 108}, "body", 16, Anchor::start, true);
    draw_surface(page, {{40, 100}, size}, body, eye, {pixels, full_color});
    page.text({650, 108}, "clump", 16, Anchor::start, true);
    draw_surface(page, {{630, 100}, size}, clump, eye, {pixels, full_color});
    draw_color_bar(page, {456, 660}, full_color, unit);
    return page.finish();
}

}  // namespace dem::shapegen
