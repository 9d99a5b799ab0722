// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/curvature_panel.hpp"

#include "common/math/elementary.hpp"
#include "common/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dem::shapegen {

namespace {

/// A range of values with round tick marks.
struct Axis {
    double low, high, step;
};

/// Round ticks that hold [low, high], at least five of them.
Axis round_axis(double low, double high) {
    const double raw = (high - low) / 10.0;
    const double decade = math::pow(10.0, std::floor(math::log10(raw)));
    double step = 10.0 * decade;
    for (const double candidate : {5.0, 2.0, 1.0}) {
        if (candidate * decade >= raw) step = candidate * decade;
    }
    return {std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step, step};
}

/// The curvature below which all but the sharpest 3 % of the arc length lies.
double bulk_curvature(const SharedArray<CurvatureSample>& samples) {
    std::vector<std::pair<double, double>> pieces;  // curvature, length
    for (std::size_t i = 1; i < samples.size(); ++i) {
        pieces.emplace_back(std::max(samples[i].mean_curvature, samples[i - 1].mean_curvature),
                            samples[i].arc_length - samples[i - 1].arc_length);
    }
    std::sort(pieces.begin(), pieces.end());
    double left = 0.97 * samples.back().arc_length;
    for (const auto& [curvature, length] : pieces) {
        left -= length;
        if (left <= 0.0) return curvature;
    }
    return pieces.back().first;
}

class Plot {
  public:
    Plot(SvgPage& page, const PanelBox& box, const SrShape& sr)
        : page_(page), box_(box), sr_(sr), unit_(length_unit(sr.major_axis_length)) {
        double lowest = 0.0;
        for (const CurvatureSample& s : sr.curvature) {
            lowest = std::min(lowest, s.mean_curvature);
            highest_ = std::max(highest_, s.mean_curvature);
        }
        const double bulk = bulk_curvature(sr.curvature);
        is_cut_ = highest_ > 2.5 * bulk;
        const double sphere = 2.0 / sr.equivalent_diameter;
        lowest = std::max(lowest, -4.0 * std::max(bulk, sphere));
        const double top = 1.1 * std::max(is_cut_ ? 1.25 * bulk : highest_, sphere);
        y_ = round_axis(lowest * unit_.meters, top * unit_.meters);
        x_ = round_axis(0.0, sr.curvature.back().arc_length / unit_.meters);
        x_.high = sr.curvature.back().arc_length / unit_.meters;
    }

    void draw() {
        draw_grid();
        draw_curve();
        draw_legend();
        const Vec2 below = box_.corner + Vec2(0.5 * box_.size[0], box_.size[1] + 44);
        page_.text(below, "arc length s from the bottom pole [" + unit_.name + "]", 14,
                   Anchor::middle);
        page_.text_upwards(box_.corner + Vec2(-52, 0.5 * box_.size[1]),
                           "mean curvature H [1/" + unit_.name + "]", 14);
        page_.text(box_.corner + Vec2(0, -12), "Curvature along the profile", 15, Anchor::start,
                   true);
    }

  private:
    Vec2 at(double s, double h) const {
        const double cut = std::clamp(h, y_.low, y_.high);
        return box_.corner + Vec2(box_.size[0] * (s - x_.low) / (x_.high - x_.low),
                                  box_.size[1] * (y_.high - cut) / (y_.high - y_.low));
    }

    void draw_grid() {
        const Style grid{.stroke = "#e2e8f0", .width = 1.0};
        for (int i = 0; x_.low + i * x_.step <= x_.high * (1.0 + 1e-9); ++i) {
            const double s = x_.low + i * x_.step;
            page_.line(at(s, y_.low), at(s, y_.high), grid);
            page_.text(at(s, y_.low) + Vec2(0, 20), short_number(s), 12, Anchor::middle);
        }
        for (int i = 0; y_.low + i * y_.step <= y_.high + 1e-9 * y_.step; ++i) {
            const double rounded =
                std::abs(y_.low + i * y_.step) < 1e-9 * y_.step ? 0.0 : y_.low + i * y_.step;
            page_.line(at(x_.low, rounded), at(x_.high, rounded), grid);
            page_.text(at(x_.low, rounded) + Vec2(-8, 4), short_number(rounded), 12, Anchor::end);
        }
        const double sphere = 2.0 / sr_.equivalent_diameter * unit_.meters;
        page_.line(at(x_.low, sphere), at(x_.high, sphere), dashed_);
        page_.rectangle(box_.corner, box_.size, {.stroke = "#334155", .width = 1.0});
    }

    void draw_curve() {
        std::vector<Vec2> curve;
        for (const CurvatureSample& s : sr_.curvature) {
            curve.push_back(at(s.arc_length / unit_.meters, s.mean_curvature * unit_.meters));
        }
        page_.polyline(curve, curve_);
    }

    void draw_legend() {
        Vec2 row = box_.corner + Vec2(0, box_.size[1] + 78);
        page_.line(row, row + Vec2(22, 0), dashed_);
        page_.text(row + Vec2(30, 4), "sphere of equal volume", 13);
        if (!is_cut_) return;
        row[1] += 20;
        page_.line(row, row + Vec2(22, 0), curve_);
        page_.text(row + Vec2(30, 4),
                   "edges reach beyond the frame, up to H = " +
                       short_number(highest_ * unit_.meters, 3) + " 1/" + unit_.name,
                   13);
    }

    Style dashed_{.stroke = "#64748b", .width = 1.0, .dashes = "5 4"};
    Style curve_{.stroke = "#b91c1c", .width = 1.8};

    SvgPage& page_;
    PanelBox box_;
    const SrShape& sr_;
    LengthUnit unit_;
    Axis x_{}, y_{};
    double highest_ = 0.0;
    bool is_cut_ = false;
};

}  // namespace

void draw_curvature(SvgPage& page, const PanelBox& box, const SrShape& sr) {
    Plot(page, box, sr).draw();
}

}  // namespace dem::shapegen
