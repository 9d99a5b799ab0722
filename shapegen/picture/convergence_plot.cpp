// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/convergence_plot.hpp"

#include "common/math/elementary.hpp"
#include "shapegen/picture/svg_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::shapegen {

namespace {

struct Curve {
    std::string name, color;
    double (*value)(const ClumpQuality&);  ///< a fraction
};

const std::array<Curve, 3> curves{
    {{"not covered, of the volume", "#1d4ed8",
      [](const ClumpQuality& q) { return 1.0 - q.coverage; }},
     {"RMS deviation, of d_eq", "#c2410c", [](const ClumpQuality& q) { return q.rms_deviation; }},
     {"largest error of a moment", "#15803d",
      [](const ClumpQuality& q) { return q.moment_errors.cwiseAbs().maxCoeff(); }}}};

constexpr double smallest = 1e-6;  // what is below is drawn there
const Vec2 corner(90.0, 90.0);
const Vec2 size(700.0, 460.0);

/// Decades of both axes.
struct Decades {
    double right;        ///< of the count; the left end is 1
    double bottom, top;  ///< of the fractions

    Vec2 operator()(double spheres, double fraction) const {
        const double y = math::log10(std::max(fraction, smallest));
        return corner +
               Vec2(size[0] * math::log10(spheres) / right, size[1] * (top - y) / (top - bottom));
    }
};

Decades decades(const std::vector<ConvergenceRow>& rows) {
    double low = 1.0;
    double high = smallest;
    for (const ConvergenceRow& row : rows) {
        for (const Curve& curve : curves) {
            const double value = std::max(curve.value(row.quality), smallest);
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    const double most = static_cast<double>(rows.back().spheres);
    return {std::max(std::ceil(math::log10(most)), 1.0), std::floor(math::log10(low)),
            std::max(std::ceil(math::log10(high)), std::floor(math::log10(low)) + 1.0)};
}

void draw_grid(SvgPage& page, const Decades& at) {
    for (double d = 0.0; d <= at.right; ++d) {
        const double x = at(math::pow(10.0, d), 1.0)[0];
        page.line({x, corner[1]}, {x, corner[1] + size[1]}, {.stroke = "#d4d4d8"});
        page.text({x, corner[1] + size[1] + 22.0}, short_number(math::pow(10.0, d)), 13,
                  Anchor::middle);
    }
    for (double d = at.bottom; d <= at.top; ++d) {
        const double y = at(1.0, math::pow(10.0, d))[1];
        page.line({corner[0], y}, {corner[0] + size[0], y}, {.stroke = "#d4d4d8"});
        page.text({corner[0] - 8.0, y + 4.0}, short_number(100.0 * math::pow(10.0, d)) + " %", 13,
                  Anchor::end);
    }
    page.text(corner + Vec2(0.5 * size[0], size[1] + 48.0), "spheres", 14, Anchor::middle);
}

}  // namespace

std::string convergence_plot(const std::string& name, const std::vector<ConvergenceRow>& rows) {
    SvgPage page(860.0, 640.0);
    const Decades at = decades(rows);
    page.text({40, 42}, name, 24, Anchor::start, true);
    draw_grid(page, at);
    double x = corner[0];
    for (const Curve& curve : curves) {
        std::vector<Vec2> points;
        points.reserve(rows.size());
        for (const ConvergenceRow& row : rows)
            points.push_back(at(static_cast<double>(row.spheres), curve.value(row.quality)));
        page.polyline(points, {.stroke = curve.color, .width = 2.0});
        page.dots(points, 3.5, curve.color);
        page.line({x, 68.0}, {x + 24.0, 68.0}, {.stroke = curve.color, .width = 2.0});
        page.text({x + 30.0, 72.0}, curve.name, 13);
        x += 240.0;
    }
    return page.finish();
}

}  // namespace dem::shapegen
