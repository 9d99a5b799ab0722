// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/convex/convex_file.hpp"

#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "common/text.hpp"
#include "formats/text_file.hpp"
#include "shapegen/convex/exact_hull.hpp"
#include "shapegen/convex/make_oblong.hpp"
#include "shapegen/profile/shape_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace dem::shapegen {
namespace {

using Parameters = ShapeParameters;

struct NamedConvex {
    std::string name;
    std::vector<std::string> parameters;
    bool has_edges;  ///< that can be rounded
    ConvexSolid (*make)(const Parameters& p, double rounding);
};

/// Rows `x y z` of a polyhedron [m].
std::vector<Vec3> points(const ProfileText& text) {
    std::vector<Vec3> result;
    for (const auto& [row, line] : text.statements) {
        const auto cells = columns(row);
        if (cells.size() != 3)
            throw Error(text.place(line), "found " + in_quotes(row) + ", expected a point 'x y z'");
        result.emplace_back(text.length(cells[0], line), text.length(cells[1], line),
                            text.length(cells[2], line));
        if (!(result.back().cwiseAbs().maxCoeff() <= most_length))
            throw Error(text.place(line),
                        "found " + in_quotes(row) + ", expected a point within 1e6 m");
    }
    return result;
}

ConvexSolid sphere(const Parameters& p, double) {
    return make_convex_sphere(p.radius());
}
ConvexSolid ellipsoid_of(const Parameters& p, const Vec3& axes) {
    constexpr double most_slender = 2000.0;  // pictures of thinner ones would fill the memory
    if (axes.maxCoeff() > most_slender * axes.minCoeff())
        p.fail("shape", "semi-axes that differ by a factor of 2000 at most");
    return make_ellipsoid(axes);
}
ConvexSolid ellipsoid(const Parameters& p, double) {
    return ellipsoid_of(p, {p.length("a"), p.length("b"), p.length("c")});
}
ConvexSolid spheroid(const Parameters& p, double) {
    return ellipsoid_of(p, {p.length("a"), p.length("a"), p.length("c")});
}
ConvexSolid cylinder(const Parameters& p, double rounding) {
    return make_cylinder(p.radius(), p.length("height"), rounding);
}
ConvexSolid cone(const Parameters& p, double rounding) {
    return make_cone(p.radius(), p.length("height"), rounding);
}
/// A frustum that is a cone or a cylinder, about the middle of its height.
ConvexSolid frustum(const Parameters& p, double rounding) {
    const double bottom = p.length_or_zero("bottom_radius");
    const double top = p.length_or_zero("top_radius");
    const double height = p.length("height");
    if (bottom == top && bottom > 0.0) return make_cylinder(bottom, height, rounding);
    if (bottom > 0.0 && top > 0.0)
        p.fail("top_radius",
               "zero, a cone, or the bottom radius, a cylinder; --sr takes any frustum");
    if (bottom == 0.0 && top == 0.0) p.fail("top_radius", "one radius above zero");
    ConvexSolid cone = make_cone(std::max(bottom, top), height, rounding);
    MassProperties& body = cone.mass_properties;
    body.center_of_mass.z() -= 0.5 * height;
    if (bottom == 0.0) {
        body.center_of_mass.z() *= -1.0;
        body.principal_axes =
            Quat(0.0, 1.0, 0.0, 0.0) * body.principal_axes;  // half a turn about x
    }
    return cone;
}
ConvexSolid cuboid(const Parameters& p, double rounding) {
    return make_cuboid({p.length("length"), p.length("width"), p.length("height")}, rounding);
}
ConvexSolid capsule(const Parameters& p, double) {
    const double radius = p.radius();
    const double length = p.length("length");
    if (length < 2.0 * radius) p.fail("length", "at least twice the radius, from end to end");
    return make_capsule(radius, length);
}
ConvexSolid spherocylinder(const Parameters& p, double) {
    return make_capsule(p.radius(), p.length("cylinder_height") + 2.0 * p.radius());
}
ConvexSolid disc(const Parameters& p, double) {
    const double thickness = p.length("thickness");
    if (!(thickness < 2.0 * p.radius())) p.fail("thickness", "less than twice the radius");
    return make_rounded_disc(p.radius(), thickness);
}
ConvexSolid polyhedron(const Parameters& p, double rounding) {
    const auto corners = points(p.text());
    return make_convex_polyhedron(corners, rounding, exact_hull);
}

ConvexSolid oblong(const Parameters& p, double rounding) {
    OblongTablet tablet{p.length("length"), p.length("width"), p.length("band_height")};
    if (!(tablet.width < tablet.length)) p.fail("width", "less than the length");
    if (p.has("cap_height")) tablet.cap_height = p.length_or_zero("cap_height");
    if (tablet.cap_height > 0.5 * tablet.width)
        p.fail("cap_height", "a cap no higher than half the width");
    if (p.has("sides")) {
        const double sides = p.number("sides");
        if (!(sides >= 4.0 && sides <= 64.0 && sides == std::floor(sides)))
            p.fail("sides", "a whole number from 4 to 64");
        tablet.sides = static_cast<int>(sides);
    }
    ConvexSolid solid = make_oblong(tablet, rounding);
    solid.facet_error = facet_error(tablet);
    return solid;
}

const std::vector<NamedConvex>& shapes() {
    static const std::vector<NamedConvex> list{
        {"sphere", {"radius", "diameter"}, false, sphere},
        {"ellipsoid", {"a", "b", "c"}, false, ellipsoid},
        {"cylinder", {"radius", "diameter", "height", "rounding"}, true, cylinder},
        {"cone", {"radius", "diameter", "height", "rounding"}, true, cone},
        {"cuboid", {"length", "width", "height", "rounding"}, true, cuboid},
        {"capsule", {"radius", "diameter", "length"}, false, capsule},
        {"disc", {"radius", "diameter", "thickness"}, false, disc},
        {"oblong",
         {"length", "width", "band_height", "cap_height", "sides", "rounding"},
         true,
         oblong},
        {"polyhedron", {"rounding"}, true, polyhedron}};
    return list;
}

/// Profiles of the same names or of others.
const std::vector<NamedConvex>& profiles() {
    static const std::vector<NamedConvex> list{
        {"sphere", {"radius", "diameter"}, false, sphere},
        {"spheroid", {"a", "c"}, false, spheroid},
        {"cylinder", {"radius", "diameter", "height"}, true, cylinder},
        {"disc", {"radius", "diameter", "height"}, true, cylinder},
        {"frustum", {"bottom_radius", "top_radius", "height"}, true, frustum},
        {"spherocylinder", {"radius", "diameter", "cylinder_height"}, false, spherocylinder}};
    return list;
}

/// What the user asked for, on the command line or in the file.
std::optional<Rounding> wanted_rounding(const ProfileText& text, const NamedConvex& shape,
                                        const std::optional<Rounding>& from_command_line) {
    if (from_command_line) {
        if (!shape.has_edges)
            throw Error(text.path, "found --rounding, expected none: a " + shape.name +
                                       " has no edges to round");
        return from_command_line;
    }
    const auto setting = text.settings.find("rounding");
    if (setting == text.settings.end()) return std::nullopt;
    try {
        Rounding rounding = parse_rounding(setting->second.value, text.unit);
        if (!rounding.is_share) rounding.value *= text.scale;
        return rounding;
    } catch (const Error& problem) {
        throw Error(text.place(setting->second.line), problem.what());
    }
}

/// Corners of a body without rounding, and a point of each round edge, in the frame of its input.
std::vector<Vec3> sharp_points(const ConvexSolid& solid) {
    const ConvexShape& shape = solid.shape;
    std::vector<Vec3> points;
    if (shape.is_polyhedron()) {
        points.assign(shape.vertices.begin(), shape.vertices.end());
    } else if (shape.core != ConvexShape::Core::ellipsoid) {
        const double high = shape.low + shape.size.z;
        points = {{shape.size.x, 0.0, shape.low},
                  {shape.core == ConvexShape::Core::cone ? 0.0 : shape.size.x, 0.0, high}};
    }
    const MassProperties& body = solid.mass_properties;
    for (Vec3& p : points) p = body.center_of_mass + body.principal_axes * p;
    return points;
}

/// `rounding_place`: of what asks for the rounding, for messages; none: nothing does.
ConvexSolid rounded(const ProfileText& text, const NamedConvex& shape,
                    const std::optional<Rounding>& wanted,
                    const std::optional<std::string>& rounding_place) {
    const Parameters parameters(text);
    // What the shape itself refuses is about the line of `shape`, or about the rounding afterwards.
    std::string place = text.place(text.settings.find("shape")->second.line);
    try {
        ConvexSolid sharp = shape.make(parameters, 0.0);
        if (!shape.has_edges) return sharp;
        if (rounding_place) place = *rounding_place;
        const double volume = sharp.mass_properties.volume;
        ConvexSolid solid = shape.make(
            parameters, wanted ? wanted->radius(volume) : default_rounding(sharp.shape, volume));
        solid.corner_retreat = farthest_outside(solid, sharp_points(sharp));
        return solid;
    } catch (const Error& problem) {
        const std::string words = problem.what();
        if (words.starts_with(text.path + ":")) throw;
        throw Error(place, words);
    }
}

/// How many points of a polyhedron are no corners of it.
std::vector<std::string> notes(const ProfileText& text, const NamedConvex& shape) {
    if (shape.name != "polyhedron") return {};
    const auto given = points(text);
    const std::size_t corners = exact_hull(given).vertices.size();
    if (corners == given.size()) return {};
    return {std::to_string(given.size()) + " points, of which " +
            std::to_string(given.size() - corners) +
            " are repeated or no corners of the hull: left out"};
}

ConvexFile convex(std::string_view bytes, const ProfileText& text, const NamedConvex& shape,
                  const std::optional<Rounding>& rounding) {
    check_parameters(text, shape.parameters);
    if (!text.statements.empty() && shape.name != "polyhedron")
        throw Error(text.place(text.statements.front().line),
                    "found " + in_quotes(text.statements.front().text) +
                        ", expected only parameters of shape " + in_quotes(shape.name));
    ConvexFile file;
    std::optional<std::string> place;
    if (const auto setting = text.settings.find("rounding"); setting != text.settings.end())
        place = text.place(setting->second.line);
    if (rounding) place = "--rounding";
    file.solid = rounded(text, shape, wanted_rounding(text, shape, rounding), place);
    file.name = std::filesystem::path(text.path).stem().string();
    file.hash = file_hash(bytes);
    file.unit = text.unit * text.scale;
    file.lines = notes(text, shape);
    return file;
}

}  // namespace

ConvexFile parse_convex(std::string_view bytes, const std::string& path,
                        const std::optional<Rounding>& rounding, double scale) {
    const ProfileText text = parse_profile_text(bytes, path, scale);
    if (text.settings.empty() && text.statements.empty())
        throw Error(path, "the file is empty, expected a convex shape");
    if (!text.settings.contains("shape"))
        throw Error(path,
                    "found no shape, expected 'shape = cuboid' or another of "
                    "docs/convex-file.md");
    return convex(bytes, text, find_named(text, shapes()), rounding);
}

ConvexFile read_convex(const std::string& path, const std::optional<Rounding>& rounding,
                       double scale) {
    return parse_convex(read_text_file(path, "convex shape", most_profile_megabytes), path,
                        rounding, scale);
}

ConvexFile parse_convex_profile(std::string_view bytes, const std::string& path,
                                const std::optional<Rounding>& rounding, double scale) {
    const ProfileText text = parse_profile_text(bytes, path, scale);
    const auto name = text.settings.find("shape");
    const auto& known = profiles();
    const auto found = std::find_if(known.begin(), known.end(), [&](const NamedConvex& shape) {
        return name != text.settings.end() && shape.name == name->second.value;
    });
    if (found == known.end())
        throw Error(
            path,
            "found a profile that is no named sphere, spheroid, cylinder, disc, "
            "frustum or spherocylinder, expected --sr, which takes any convex profile exactly");
    return convex(bytes, text, *found, rounding);
}

ConvexFile read_convex_profile(const std::string& path, const std::optional<Rounding>& rounding,
                               double scale) {
    return parse_convex_profile(read_text_file(path, "profile", most_profile_megabytes), path,
                                rounding, scale);
}

}  // namespace dem::shapegen
