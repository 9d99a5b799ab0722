// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

#include <span>
#include <string>

namespace dem::shapegen {

/// Stroke and fill of what is drawn, as SVG writes them.
struct Style {
    std::string stroke = "none";
    double width = 1.0;  // [px]
    std::string fill = "none";
    std::string dashes = "none";
};

enum class Anchor { start, middle, end };

/// An SVG drawing, in pixels, y down.
class SvgPage {
  public:
    SvgPage(double width, double height);

    void line(const Vec2& from, const Vec2& to, const Style& style);
    void polyline(std::span<const Vec2> points, const Style& style, bool closed = false);
    void rectangle(const Vec2& corner, const Vec2& size, const Style& style);
    /// Dots of one size and color.
    void dots(std::span<const Vec2> centers, double radius, const std::string& fill);
    /// Axis-parallel strokes in one element: pairs of end points.
    void strokes(std::span<const Vec2> ends, const Style& style);
    void text(const Vec2& at, const std::string& words, double size, Anchor anchor = Anchor::start,
              bool is_bold = false);
    /// Reads from below, centered at the point.
    void text_upwards(const Vec2& at, const std::string& words, double size);

    std::string finish() const { return content_ + "</svg>\n"; }

  private:
    void add(const std::string& element) { content_ += element + "\n"; }

    std::string content_;
};

/// A number with at most `digits` significant digits, without trailing zeros.
std::string short_number(double value, int digits = 4);

}  // namespace dem::shapegen
