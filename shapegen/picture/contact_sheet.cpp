// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/contact_sheet.hpp"

#include "common/units.hpp"
#include "shapegen/picture/svg_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace dem::shapegen {

namespace {

constexpr double cell = 220.0;    // [px]
constexpr double caption = 34.0;  // [px]
constexpr double margin = 20.0;   // [px]
constexpr double filled = 0.44;   // of a cell: the largest bounding radius

/// Rows: right, up, towards the viewer.
Mat3 view() {
    const Vec3 towards = Vec3(0.55, -0.75, 0.42).normalized();
    const Vec3 right = Vec3::UnitZ().cross(towards).normalized();
    Mat3 rows;
    rows << right.transpose(), towards.cross(right).transpose(), towards.transpose();
    return rows;
}

std::string shade(double brightness) {
    constexpr std::array<double, 3> sand{230.0, 190.0, 130.0};
    std::array<int, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<int>(std::lround(sand[k] * brightness));
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", c[0] & 255, c[1] & 255, c[2] & 255);
    return text.data();
}

/// Triangles that face the viewer, the farthest first, so that nearer ones cover them.
void draw_mesh(SvgPage& page, const DisplayMesh& mesh, const Vec2& center, double scale) {
    const Mat3 axes = view();
    const Vec3 light = Vec3(-0.4, 0.6, 0.7).normalized();  // camera frame
    struct Facet {
        double depth;
        std::array<Vec2, 3> corners;
        std::string fill;
    };
    std::vector<Facet> facets;
    for (const auto& triangle : mesh.triangles) {
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = axes * mesh.vertices[triangle[k]];
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        if (!(normal.z() > 0.0)) continue;
        Facet facet{p[0].z() + p[1].z() + p[2].z(),
                    {},
                    shade(0.35 + 0.65 * std::max(0.0, normal.normalized().dot(light)))};
        for (std::size_t k = 0; k < 3; ++k)
            facet.corners[k] = center + scale * Vec2(p[k].x(), -p[k].y());
        facets.push_back(std::move(facet));
    }
    std::stable_sort(facets.begin(), facets.end(),
                     [](const Facet& a, const Facet& b) { return a.depth < b.depth; });
    // The stroke closes the seams between triangles of one face.
    for (const Facet& facet : facets)
        page.polyline(facet.corners, {.stroke = facet.fill, .width = 0.6, .fill = facet.fill},
                      true);
}

}  // namespace

std::string contact_sheet(std::span<const ParticleTemplate> shapes) {
    shapes = shapes.first(std::min(shapes.size(), most_shapes_of_a_sheet));
    const auto count = static_cast<double>(shapes.size());
    const double columns = std::ceil(std::sqrt(count));
    const double rows = std::ceil(count / columns);
    SvgPage page(columns * cell + 2.0 * margin, rows * (cell + caption) + 2.0 * margin);
    double largest = 0.0;
    for (const ParticleTemplate& shape : shapes) largest = std::max(largest, shape.bounding_radius);
    const LengthUnit unit = length_unit(2.0 * largest);
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const ParticleTemplate& shape = shapes[k];
        const double column = std::fmod(static_cast<double>(k), columns);
        const double row = std::floor(static_cast<double>(k) / columns);
        const Vec2 center(margin + (column + 0.5) * cell,
                          margin + row * (cell + caption) + 0.5 * cell);
        draw_mesh(page, shape.display_mesh, center, filled * cell / largest);
        const double d_eq = equivalent_diameter(shape.mass_properties.volume);
        const Vec2 below = center + Vec2(0.0, 0.5 * cell + 8.0);
        page.text(below, shape.name, 13, Anchor::middle);
        page.text(below + Vec2(0.0, 16.0),
                  "d_eq " + short_number(d_eq / unit.meters, 3) + " " + unit.name, 12,
                  Anchor::middle);
    }
    return page.finish();
}

}  // namespace dem::shapegen
