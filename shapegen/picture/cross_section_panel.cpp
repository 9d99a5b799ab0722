// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/cross_section_panel.hpp"

#include "common/math/elementary.hpp"
#include "common/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dem::shapegen {

namespace {

const std::string outline_color = "#111111";
const std::string node_color = "#c2410c";
/// Colors of the cells, from base to corner.
const std::array<std::string, 3> cell_colors{"#cbd5e1", "#60a5fa", "#1e3a8a"};

/// Body coordinates (x, z) [m] to page pixels.
struct View {
    Vec2 center_on_page;
    Vec2 center;
    double scale;

    Vec2 operator()(double x, double z) const {
        return {center_on_page[0] + scale * (x - center[0]),
                center_on_page[1] - scale * (z - center[1])};
    }
};

View fit(const PanelBox& box, const SrShape& sr, const SdfQuadtree& sdf) {
    const double half_width = sdf.origin_r + sdf.base_size * sdf.cells_r;
    const double height = sdf.base_size * sdf.cells_z;
    const double scale =
        std::min(box.size[0] / (half_width + 1.08 * sr.max_radius), box.size[1] / height);
    const double middle_x = 0.5 * (1.08 * sr.max_radius - half_width);
    return {box.corner + 0.5 * box.size, {middle_x, sdf.origin_z + 0.5 * height}, scale};
}

/// The distinct levels in use, coarse to fine: at most base, interface and corner.
std::vector<std::uint32_t> levels_in_use(const SdfQuadtree& sdf) {
    std::vector<std::uint32_t> levels;
    for (const SdfCell& cell : sdf.cells) levels.push_back(cell.level);
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
}

std::size_t color_of(std::size_t rank, std::size_t levels) {
    return rank + 1 == levels && levels > 2 ? 2 : std::min<std::size_t>(rank, 1);
}

void draw_cells(SvgPage& page, const View& view, const SdfQuadtree& sdf) {
    const auto levels = levels_in_use(sdf);
    for (std::size_t rank = 0; rank < levels.size(); ++rank) {
        std::vector<Vec2> ends;
        for (std::uint32_t k = 0; k < sdf.cells_z; ++k) {
            for (std::uint32_t i = 0; i < sdf.cells_r; ++i) {
                if (sdf.cells[k * sdf.cells_r + i].level != levels[rank]) continue;
                const double size = sdf.base_size;
                const double r = sdf.origin_r + size * i;
                const double z = sdf.origin_z + size * k;
                const std::uint32_t n = 1U << levels[rank];
                for (std::uint32_t a = 0; a <= n; ++a) {
                    const double way = size * a / n;
                    const double inner = std::max(r, 0.0);
                    if (r + way >= 0.0) {
                        ends.push_back(view(-(r + way), z));
                        ends.push_back(view(-(r + way), z + size));
                    }
                    ends.push_back(view(-inner, z + way));
                    ends.push_back(view(-(r + size), z + way));
                }
            }
        }
        page.strokes(ends, {.stroke = cell_colors[color_of(rank, levels.size())],
                            .width = rank == 0 ? 0.6 : 0.3});
    }
}

void draw_outline(SvgPage& page, const View& view, const SharedArray<CurvatureSample>& profile) {
    std::vector<Vec2> whole;
    for (const CurvatureSample& s : profile) whole.push_back(view(s.r, s.z));
    for (std::size_t i = profile.size(); i-- > 0;) {
        whole.push_back(view(-profile[i].r, profile[i].z));
    }
    page.polyline(whole, {.stroke = outline_color, .width = 1.8}, true);
}

void draw_nodes(SvgPage& page, const View& view, const SurfaceNodes& nodes) {
    std::vector<Vec2> front;
    for (std::uint32_t i = 0; i < nodes.count; ++i) {
        const SurfaceNodes::Node& n = nodes.nodes[i];
        if (n.y <= 0.0 && n.x >= 0.0) front.push_back(view(n.x, n.z));
    }
    page.dots(front, std::clamp(60.0 / std::sqrt(nodes.count), 0.5, 2.0), node_color);
}

void draw_axis(SvgPage& page, const View& view, const SdfQuadtree& sdf) {
    const double top = sdf.origin_z + sdf.base_size * sdf.cells_z;
    page.line(view(0.0, sdf.origin_z), view(0.0, top),
              {.stroke = "#666", .width = 1.0, .dashes = "12 4 2 4"});
    const Vec2 center = view(0.0, 0.0);
    const std::array<Vec2, 4> cross{Vec2(center + Vec2(-7, 0)), Vec2(center + Vec2(7, 0)),
                                    Vec2(center + Vec2(0, -7)), Vec2(center + Vec2(0, 7))};
    page.strokes(cross, {.stroke = outline_color, .width = 2.0});
}

/// The largest of 1, 2, 5 times a power of ten that does not exceed `length`.
double round_length(double length) {
    const double decade = math::pow(10.0, std::floor(math::log10(length)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= length) return step * decade;
    }
    return decade;
}

void draw_scale_bar(SvgPage& page, const Vec2& left, const View& view, double size) {
    const LengthUnit unit = length_unit(size);
    const double length = round_length(0.3 * size / unit.meters);
    const Vec2 right = left + Vec2(view.scale * length * unit.meters, 0.0);
    const std::array<Vec2, 6> bar{
        left, right, left - Vec2(0, 5), left + Vec2(0, 5), right - Vec2(0, 5), right + Vec2(0, 5)};
    page.strokes(bar, {.stroke = outline_color, .width = 1.5});
    page.text(0.5 * (left + right) - Vec2(0, 8), short_number(length) + " " + unit.name, 13,
              Anchor::middle);
}

void draw_legend(SvgPage& page, Vec2 at, const ParticleTemplate& shape, const SrShape& sr) {
    const LengthUnit unit = length_unit(sr.major_axis_length);
    const auto row = [&](const std::string& words) {
        page.text(at + Vec2(30, 4), words, 13);
        at[1] += 20;
    };
    page.line(at, at + Vec2(22, 0), {.stroke = outline_color, .width = 1.8});
    row("cross-section; display mesh within " +
        short_number(shape.display_mesh.max_deviation / unit.meters, 2) + " " + unit.name);
    const std::array<Vec2, 1> dot{Vec2(at + Vec2(11, 0))};
    page.dots(dot, 3.0, node_color);
    row(std::to_string(sr.nodes.count) + " surface nodes (right: those of the front side)");
    const auto levels = levels_in_use(sr.sdf);
    for (std::size_t rank = 0; rank < levels.size(); ++rank) {
        page.rectangle(at + Vec2(5, -6), {12, 12},
                       {.stroke = cell_colors[color_of(rank, levels.size())], .width = 1.5});
        const double edge = sr.sdf.base_size / (1U << levels[rank]);
        row("distance-field cells of " + short_number(edge / unit.meters, 3) + " " + unit.name +
            " = l/" + short_number(sr.major_axis_length / edge, 4));
    }
    const std::array<Vec2, 4> cross{Vec2(at + Vec2(4, 0)), Vec2(at + Vec2(18, 0)),
                                    Vec2(at + Vec2(11, -7)), Vec2(at + Vec2(11, 7))};
    page.strokes(cross, {.stroke = outline_color, .width = 2.0});
    row("center of mass; dash-dot: axis of revolution, body z");
}

}  // namespace

void draw_cross_section(SvgPage& page, const PanelBox& box, const ParticleTemplate& shape,
                        const SrShape& sr) {
    constexpr double legend_height = 120.0;
    const PanelBox drawing{box.corner, box.size - Vec2(0.0, legend_height)};
    const View view = fit(drawing, sr, sr.sdf);
    draw_cells(page, view, sr.sdf);
    draw_axis(page, view, sr.sdf);
    draw_nodes(page, view, sr.nodes);
    draw_outline(page, view, sr.curvature);
    const Vec2 below = box.corner + Vec2(0.0, drawing.size[1] + 28.0);
    draw_scale_bar(page, below + Vec2(box.size[0] - 200.0, 0.0), view, sr.major_axis_length);
    draw_legend(page, below, shape, sr);
}

}  // namespace dem::shapegen
