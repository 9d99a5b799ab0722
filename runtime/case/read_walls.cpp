// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/text.hpp"
#include "formats/template_reader.hpp"
#include "runtime/case/scene_sections.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace dem::runtime {

namespace {

enum class Shape : std::uint8_t { plane, cylinder, box, mesh };

/// A face of the wall `base`: its own name and pose, the rest shared.
Wall face(const Wall& base, const std::string& suffix, const Vec3& origin, const Vec3& z_axis,
          const WallShape& shape) {
    Wall wall = base;
    if (!suffix.empty()) wall.name += "." + suffix;
    wall.position = origin;
    wall.orientation = orientation_towards(z_axis);
    wall.shape = shape;
    return wall;
}

void read_cylinder(const Values& values, const Wall& base, Scene& scene) {
    const Vec3 point = values.vector("point");
    const Vec3 axis = values.direction("axis");
    CylinderWall side;
    const std::optional<double> radius = values.radius();
    if (!radius) {
        throw Error(values.section_where(), "no 'radius' in [" + values.section_name() +
                                                "], it or 'diameter' is required for a cylinder");
    }
    side.radius = *radius;
    side.inside = values.word("side") == "inside";
    const std::optional<double> length = values.optional_number("length");
    if (length) side.length = *length;
    if (!side.inside) {
        scene.walls.push_back(face(base, "", point, axis, side));
        if (!values.has("ends")) return;
        throw Error(values.where("ends"),
                    "a rod (side = outside) always has both ends, expected "
                    "no such key");
    }
    const std::string_view ends = values.word("ends");
    const bool bottom = ends == "bottom" || ends == "both";
    const bool top = ends == "top" || ends == "both";
    if (top && !length) {
        throw Error(values.where("ends"),
                    "found a top on an infinite cylinder, expected "
                    "'length' to say where it is");
    }
    // Faces overlap where they meet: a body pressed into the corner touches each a little outside
    // the other.
    const double margin = 0.1 * side.radius;
    side.length += (bottom ? margin : 0.0) + (top ? margin : 0.0);
    const bool reaches_down = bottom && length;
    const Vec3 origin = reaches_down ? Vec3(point - margin * axis) : point;
    scene.walls.push_back(face(base, "", origin, axis, side));
    const PlaneWall disc{side.radius + margin};
    if (bottom) scene.walls.push_back(face(base, "bottom", point, axis, disc));
    if (top) scene.walls.push_back(face(base, "top", point + *length * axis, -axis, disc));
}

void read_box(const Values& values, const Wall& base, Scene& scene) {
    const Vec3 lower = values.vector("lower");
    const Vec3 upper = values.vector("upper");
    if (!(lower.array() < upper.array()).all()) {
        throw Error(values.where("upper"), "found " + in_quotes(values.text("upper")) +
                                               ", expected it above 'lower' in x, y and z");
    }
    struct Face {
        std::string_view name;
        int axis;
        double sign;  ///< of the inward normal
    };
    constexpr std::array<Face, 6> faces{{{"left", 0, 1.0},
                                         {"right", 0, -1.0},
                                         {"front", 1, 1.0},
                                         {"back", 1, -1.0},
                                         {"bottom", 2, 1.0},
                                         {"top", 2, -1.0}}};
    for (const Face& f : faces) {
        if (values.word("open") == f.name) continue;
        Vec3 origin = 0.5 * (lower + upper);
        origin[f.axis] = f.sign > 0.0 ? lower[f.axis] : upper[f.axis];
        const Vec3 inward = f.sign * Vec3::Unit(f.axis);
        scene.walls.push_back(face(base, std::string(f.name), origin, inward, PlaneWall{}));
    }
}

/// The wall of a template file, its lengths multiplied. Adds the file to the inputs of the scene.
WallMesh read_wall_mesh(const Values& values, Scene& scene) {
    const auto folder = std::filesystem::path(scene.case_path).parent_path();
    const std::string path = (folder / values.text("template")).lexically_normal().string();
    const double scale = values.number("scale");
    try {
        const TemplateLibrary library(path);
        scene.inputs.emplace_back(values.text("template"), library.head().input_hash);
        WallMesh mesh = library.wall(0).mesh;
        return scale == 1.0 ? mesh : scaled(mesh, scale);
    } catch (const Error& error) {
        throw Error(values.where("template"), error.what());
    }
}

void read_mesh(const Values& values, const Wall& base, Scene& scene) {
    Wall wall = base;
    const auto mesh = std::make_shared<const WallMesh>(read_wall_mesh(values, scene));
    wall.position = values.vector("position");
    wall.orientation = *values.optional_orientation("orientation");
    // Farther out positions lose the digits that contacts need.
    constexpr double farthest = 1e6;
    const double reach =
        mesh->bounds.lower.cwiseAbs().cwiseMax(mesh->bounds.upper.cwiseAbs()).norm();
    if (!(reach + wall.position.norm() <= farthest)) {
        throw Error(values.section_where(), "wall " + in_quotes(base.name) +
                                                " reaches beyond 1e6 m "
                                                "from the origin, expected it nearer; see 'scale'");
    }
    wall.shape = MeshWall{mesh};
    scene.walls.push_back(std::move(wall));
}

/// The axis and the point a wall turns about unless the case says otherwise.
Vec3 rotation_axis(const Values& values, Shape shape) {
    if (values.has("rotation_axis")) return values.direction("rotation_axis");
    if (shape == Shape::plane) return values.direction("normal");
    if (shape == Shape::cylinder) return values.direction("axis");
    throw Error(values.section_where(), "no 'rotation_axis' in [" + values.section_name() +
                                            "], a " + std::string(values.word("shape")) +
                                            " that rotates needs it");
}

Vec3 rotation_point(const Values& values, Shape shape) {
    if (values.has("rotation_point")) return values.vector("rotation_point");
    if (shape == Shape::mesh) return values.vector("position");
    if (shape != Shape::box) return values.vector("point");
    return 0.5 * (values.vector("lower") + values.vector("upper"));
}

/// About which torques are given unless the case says otherwise: what a shared motion turns about,
/// or what one of its own would.
Vec3 torque_point(const Values& values, Shape shape, const Motion& motion) {
    const bool is_shared = !motion.name.empty() && motion.pieces.size() == 1;
    if (is_shared && motion.pieces[0].kind == MotionPiece::Kind::rotate)
        return motion.pieces[0].point;
    return rotation_point(values, shape);
}

/// The one piece of a wall's own motion.
MotionPiece read_piece(const Values& values, Shape shape) {
    MotionPiece piece;
    const std::string_view kind = values.word("motion");
    if (kind == "translate") {
        piece.kind = MotionPiece::Kind::translate;
        piece.velocity = values.vector("velocity");
    } else if (kind == "rotate") {
        piece.kind = MotionPiece::Kind::rotate;
        piece.rate = values.number("rate");
        piece.axis = rotation_axis(values, shape);
        piece.point = rotation_point(values, shape);
    } else {
        piece.kind = MotionPiece::Kind::oscillate;
        piece.axis = values.direction("direction");
        piece.amplitude = values.number("amplitude");
        piece.frequency = values.number("frequency");
    }
    piece.from = values.number("from");
    piece.until = values.optional_number("until").value_or(piece.until);
    if (!(piece.until > piece.from)) {
        throw Error(values.where("until"),
                    "found " + in_quotes(values.text("until")) +
                        ", expected later than from = " + in_quotes(values.text("from")));
    }
    return piece;
}

Motion read_motion(const Values& values, Shape shape, const Scene& scene) {
    const std::string_view word = values.word("motion");
    const bool is_own = word == "translate" || word == "rotate" || word == "oscillate";
    if (word != "none" && !is_own)
        return motion_of_name(scene, std::string(word), values.where("motion"));
    Motion motion;
    motion.where = values.section_where();
    if (is_own) motion.pieces.push_back(read_piece(values, shape));
    return motion;
}

/// Shares of a surface velocity that may point out of the surface: rounding of what a case says,
/// and of corners that are stored with seven digits.
constexpr double share_out_of_plane = 1e-9;
constexpr double share_out_of_triangle = 1e-4;

void refuse_surface_velocity(const Values& values, const std::string& expected) {
    throw Error(values.where("surface_velocity"),
                "found " + in_quotes(values.text("surface_velocity")) + ", expected " + expected);
}

void check_surface_velocity(const Values& values, const Wall& wall, const Vec3& velocity) {
    constexpr double fastest = 1e9;  // [m/s]
    const double speed = velocity.norm();
    if (!(speed < fastest)) refuse_surface_velocity(values, "less than 1e9 m/s");
    const Vec3 axis = wall.orientation * Vec3::UnitZ();
    if (values.word("shape") == "plane" &&
        std::abs(velocity.dot(axis)) > share_out_of_plane * speed) {
        refuse_surface_velocity(values, "it along the plane, at right angles to 'normal'");
    }
    if (std::holds_alternative<CylinderWall>(wall.shape) &&
        velocity.cross(axis).norm() > share_out_of_plane * speed) {
        refuse_surface_velocity(values,
                                "it along the axis; 'motion = rotate' moves the surface around it");
    }
    const auto* mesh = std::get_if<MeshWall>(&wall.shape);
    if (mesh == nullptr) return;
    const Vec3 along = wall.orientation.conjugate() * velocity;
    for (const Vec3& normal : mesh->mesh->normals) {
        if (std::abs(normal.dot(along)) <= share_out_of_triangle * speed) continue;
        refuse_surface_velocity(values,
                                "it along every triangle of the mesh; make the surface "
                                "that moves a wall of its own");
    }
}

/// Gives the walls of a section the velocity of their surface: of each face the part along it.
void set_surface_velocity(const Values& values, std::span<Wall> walls) {
    const Vec3 velocity = values.vector("surface_velocity");
    if (velocity.isZero(0.0)) return;
    for (Wall& wall : walls) {
        check_surface_velocity(values, wall, velocity);
        wall.surface_velocity = wall.orientation.conjugate() * velocity;
        if (!std::holds_alternative<PlaneWall>(wall.shape)) continue;
        wall.surface_velocity.z() = 0.0;
        if (wall.surface_velocity.norm() <= share_out_of_plane * velocity.norm())
            wall.surface_velocity.setZero();
    }
}

}  // namespace

void read_wall(const Values& values, Scene& scene) {
    const auto shape = values.choice<Shape>("shape");
    Wall base;
    base.name = own_name(values.section_name());
    base.material = material_index(scene, values.text("material"), values.where("material"));
    base.motion = read_motion(values, shape, scene);
    base.torque_point =
        values.optional_vector("torque_point").value_or(torque_point(values, shape, base.motion));
    const std::size_t before = scene.walls.size();
    switch (shape) {
        case Shape::plane:
            scene.walls.push_back(
                face(base, "", values.vector("point"), values.direction("normal"), PlaneWall{}));
            break;
        case Shape::cylinder:
            read_cylinder(values, base, scene);
            break;
        case Shape::box:
            read_box(values, base, scene);
            break;
        case Shape::mesh:
            read_mesh(values, base, scene);
            break;
    }
    set_surface_velocity(values, std::span(scene.walls).subspan(before));
}

}  // namespace dem::runtime
