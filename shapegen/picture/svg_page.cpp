// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/svg_page.hpp"

#include <array>
#include <cstdio>

namespace dem::shapegen {

namespace {

/// Pixels with two decimals.
std::string px(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

std::string px(const Vec2& p) {
    return px(p[0]) + "," + px(p[1]);
}

std::string escaped(const std::string& words) {
    std::string out;
    for (const char c : words) {
        switch (c) {
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '&':
                out += "&amp;";
                break;
            default:
                if (static_cast<unsigned char>(c) >= 0x20) out += c;
        }
    }
    return out;
}

std::string attributes(const Style& style) {
    return " stroke=\"" + style.stroke + "\" stroke-width=\"" + px(style.width) + "\" fill=\"" +
           style.fill + "\" stroke-dasharray=\"" + style.dashes + "\"/>";
}

}  // namespace

SvgPage::SvgPage(double width, double height) {
    const std::string w = px(width);
    const std::string h = px(height);
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
        "\" viewBox=\"0 0 " + w + " " + h + "\" font-family=\"Helvetica, Arial, sans-serif\">");
    rectangle({0.0, 0.0}, {width, height}, {.fill = "white"});
}

void SvgPage::line(const Vec2& from, const Vec2& to, const Style& style) {
    add("<path d=\"M" + px(from) + "L" + px(to) + "\"" + attributes(style));
}

void SvgPage::polyline(std::span<const Vec2> points, const Style& style, bool closed) {
    std::string d;
    for (const Vec2& p : points) d += (d.empty() ? "M" : "L") + px(p);
    add("<path d=\"" + d + (closed ? "Z\"" : "\"") + " stroke-linejoin=\"round\"" +
        attributes(style));
}

void SvgPage::rectangle(const Vec2& corner, const Vec2& size, const Style& style) {
    add("<rect x=\"" + px(corner[0]) + "\" y=\"" + px(corner[1]) + "\" width=\"" + px(size[0]) +
        "\" height=\"" + px(size[1]) + "\"" + attributes(style));
}

void SvgPage::dots(std::span<const Vec2> centers, double radius, const std::string& fill) {
    add("<g fill=\"" + fill + "\">");
    for (const Vec2& c : centers) {
        add("<circle cx=\"" + px(c[0]) + "\" cy=\"" + px(c[1]) + "\" r=\"" + px(radius) + "\"/>");
    }
    add("</g>");
}

void SvgPage::strokes(std::span<const Vec2> ends, const Style& style) {
    std::string d;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        d += "M" + px(ends[i]) + "L" + px(ends[i + 1]);
    }
    add("<path d=\"" + d + "\"" + attributes(style));
}

void SvgPage::text(const Vec2& at, const std::string& words, double size, Anchor anchor,
                   bool is_bold) {
    constexpr std::array names{"start", "middle", "end"};
    add("<text x=\"" + px(at[0]) + "\" y=\"" + px(at[1]) + "\" font-size=\"" + px(size) +
        "\" text-anchor=\"" + names[static_cast<std::size_t>(anchor)] + "\"" +
        (is_bold ? " font-weight=\"bold\"" : "") + " fill=\"#222\">" + escaped(words) + "</text>");
}

void SvgPage::text_upwards(const Vec2& at, const std::string& words, double size) {
    add("<text transform=\"translate(" + px(at) + ") rotate(-90)\" font-size=\"" + px(size) +
        "\" text-anchor=\"middle\" fill=\"#222\">" + escaped(words) + "</text>");
}

std::string short_number(double value, int digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return text.data();
}

}  // namespace dem::shapegen
