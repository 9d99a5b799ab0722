// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/named_shapes.hpp"

#include "common/error.hpp"
#include "common/math/elementary.hpp"
#include "common/text.hpp"
#include "shapegen/profile/arcs.hpp"
#include "shapegen/profile/profile_curves.hpp"
#include "shapegen/profile/shape_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::shapegen {
namespace {

using Segments = std::vector<ProfileSegment>;

ProfileSegment ellipse(double a, double c) {
    return EllipseArc{Vec2::Zero(), a, c, -0.5 * pi, 0.5 * pi};
}

Segments lines(const std::vector<Vec2>& points) {
    Segments segments;
    for (std::size_t i = 1; i < points.size(); ++i)
        segments.emplace_back(LineSegment{points[i - 1], points[i]});
    return segments;
}

Segments sphere(const ShapeParameters& p) {
    const double radius = p.radius();
    return {ellipse(radius, radius)};
}

Segments spheroid(const ShapeParameters& p) {
    return {ellipse(p.length("a"), p.length("c"))};
}

Segments superquadric(const ShapeParameters& p) {
    const double exponent = p.number("exponent");
    if (!(exponent >= 1.0 && exponent <= 100.0)) p.fail("exponent", "a number from 1 to 100");
    const double a = p.length("a");
    const double c = p.length("c");
    if (exponent == 1.0) return lines({{0.0, -c}, {a, 0.0}, {0.0, c}});
    if (exponent == 2.0) return {ellipse(a, c)};
    const auto quarters = superquadric_quarters(a, c, exponent);
    return {quarters[0], quarters[1]};
}

Segments cylinder(const ShapeParameters& p) {
    const double radius = p.radius();
    const double h = 0.5 * p.length("height");
    return lines({{0.0, -h}, {radius, -h}, {radius, h}, {0.0, h}});
}

/// Rounds both edges of a tablet: cap, band, cap.
Segments with_rounded_edges(const Segments& tablet, double radius, const ShapeParameters& p) {
    const auto lower = fillet(tablet[0], tablet[1], radius);
    const auto upper = lower ? fillet(lower->after, tablet[2], radius) : std::nullopt;
    if (!upper) p.fail("edge_radius", "a radius small enough for the band and the caps");
    return {lower->before, lower->arc, upper->before, upper->arc, upper->after};
}

Segments tablet(const ShapeParameters& p) {
    const double radius = p.length("band_radius");
    const double half_band = 0.5 * p.length("band_height");
    const double cap = p.length("cap_height");
    if (cap > radius) p.fail("cap_height", "a cap no higher than its band_radius");
    const double cap_radius = (square(radius) + square(cap)) / (2.0 * cap);
    const double half_angle = math::atan2(radius, cap_radius - cap);
    const Vec2 center(0.0, half_band + cap - cap_radius);
    const Segments sharp{
        EllipseArc{-center, cap_radius, cap_radius, -0.5 * pi, -0.5 * pi + half_angle},
        LineSegment{{radius, -half_band}, {radius, half_band}},
        EllipseArc{center, cap_radius, cap_radius, 0.5 * pi - half_angle, 0.5 * pi}};
    const double edge = p.has("edge_radius") ? p.length_or_zero("edge_radius") : 0.0;
    return edge > 0.0 ? with_rounded_edges(sharp, edge, p) : sharp;
}

Segments frustum(const ShapeParameters& p) {
    const double bottom = p.length_or_zero("bottom_radius");
    const double top = p.length_or_zero("top_radius");
    const double h = 0.5 * p.length("height");
    if (bottom == 0.0 && top == 0.0) p.fail("top_radius", "one radius above zero");
    std::vector<Vec2> points{{0.0, -h}};
    if (bottom > 0.0) points.emplace_back(bottom, -h);
    if (top > 0.0) points.emplace_back(top, h);
    points.emplace_back(0.0, h);
    return lines(points);
}

Segments spherocylinder(const ShapeParameters& p) {
    const double radius = p.radius();
    const double h = 0.5 * p.length("cylinder_height");
    return {EllipseArc{Vec2(0.0, -h), radius, radius, -0.5 * pi, 0.0},
            LineSegment{{radius, -h}, {radius, h}},
            EllipseArc{Vec2(0.0, h), radius, radius, 0.0, 0.5 * pi}};
}

/// Thinner waists drown in the rounding of the curve, and are finer than any field that is made.
constexpr double thinnest_waist = 0.01;  // of the length

Segments cassini(const ShapeParameters& p) {
    const double focus = p.length("focus");
    const double product_root = p.length("product_root");
    if (!(product_root > focus))
        p.fail("product_root", "a length above 'focus', otherwise the oval falls into two parts");
    // waist^2 / length^2, as below
    const double squared =
        (square(product_root) - square(focus)) / (square(product_root) + square(focus));
    if (squared < square(thinnest_waist))
        p.fail("product_root", "one that leaves a waist of 1/100 of the length or more");
    return {cassini_half(focus, product_root)};
}

/// The Cassini oval of a length and a waist: length^2/4 = p^2 + f^2, waist^2/4 = p^2 - f^2.
Segments peanut(const ShapeParameters& p) {
    const double length = p.length("length");
    const double waist = p.length("waist");
    if (!(waist < length)) p.fail("waist", "a waist smaller than the length");
    if (waist < thinnest_waist * length) p.fail("waist", "1/100 of the length or more");
    return {cassini_half(std::sqrt((square(length) - square(waist)) / 8.0),
                         std::sqrt((square(length) + square(waist)) / 8.0))};
}

Segments red_blood_cell(const ShapeParameters& p) {
    const double diameter = p.length("diameter");
    // Evans & Fung (1972), Table 1, tonicity 300 mO: a cell of 7.82 um.
    std::array<double, 3> c{0.81, 7.83, -4.39};
    for (double& value : c) value *= diameter / 7.82;
    return {red_blood_cell_half(diameter, c)};
}

struct NamedShape {
    std::string name;
    std::vector<std::string> parameters;
    Segments (*make)(const ShapeParameters&);
};

const std::vector<NamedShape>& named_shapes() {
    static const std::vector<NamedShape> list{
        {"sphere", {"radius", "diameter"}, sphere},
        {"spheroid", {"a", "c"}, spheroid},
        {"superquadric", {"a", "c", "exponent"}, superquadric},
        {"cylinder", {"radius", "diameter", "height"}, cylinder},
        {"disc", {"radius", "diameter", "height"}, cylinder},
        {"tablet", {"band_radius", "band_height", "cap_height", "edge_radius"}, tablet},
        {"frustum", {"bottom_radius", "top_radius", "height"}, frustum},
        {"spherocylinder", {"radius", "diameter", "cylinder_height"}, spherocylinder},
        {"cassini", {"focus", "product_root"}, cassini},
        {"peanut", {"length", "waist"}, peanut},
        {"red_blood_cell", {"diameter"}, red_blood_cell}};
    return list;
}

}  // namespace

ProfileDraft named_shape(const ProfileText& text) {
    const NamedShape& shape = find_named(text, named_shapes());
    check_parameters(text, shape.parameters);
    if (!text.statements.empty())
        throw Error(text.place(text.statements.front().line),
                    "found " + in_quotes(text.statements.front().text) +
                        ", expected only parameters of shape " + in_quotes(shape.name));
    ProfileDraft draft;
    const std::string label = text.place(text.settings.find("shape")->second.line);
    for (const ProfileSegment& segment : shape.make(ShapeParameters(text)))
        draft.append(segment, label);
    return draft;
}

}  // namespace dem::shapegen
