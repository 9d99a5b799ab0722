// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/walls/cylinder_wall.hpp"
#include "runtime/contact/walls/mesh_wall.hpp"
#include "runtime/contact/walls/plane_wall.hpp"

#include <variant>

/// All shapes of walls, as the contact kernels see them, each in its own frame. A `box` of the case
/// file is six planes, a cylinder's ends are discs: each flat or curved face is a contact partner
/// of its own.
namespace dem::runtime {

using WallShape = std::variant<PlaneWall, CylinderWall, MeshWall>;
/// Those that are fields of distances.
using FieldWallShape = std::variant<PlaneWall, CylinderWall>;

/// Calls X(Shape) for all that are fields: where a kernel is a template over walls its file makes
/// those of every shape, which a type list cannot do. A macro for that alone.
#define DEM_FOR_EACH_WALL_SHAPE(X) X(PlaneWall) X(CylinderWall)

template <class Variant>
inline constexpr bool are_all_walls = false;
template <AnyWall... Wall>
inline constexpr bool are_all_walls<std::variant<Wall...>> = true;
static_assert(are_all_walls<WallShape>, "a wall shape leaves a question open (any_wall.hpp)");
template <class Variant>
inline constexpr bool are_all_fields = false;
template <FieldWall... Wall>
inline constexpr bool are_all_fields<std::variant<Wall...>> = true;
static_assert(are_all_fields<FieldWallShape>, "a wall shape is no field (any_wall.hpp)");

}  // namespace dem::runtime
