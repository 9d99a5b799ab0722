// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "common/shapes/wall_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <particle_template_generated.h>

/// Arrays of the schema's structs are used in place as arrays of ours: the two must agree byte by
/// byte. Offsets follow from sizes and order for structs of one scalar type.
namespace dem::layout {

template <class Stored, class Used>
inline constexpr bool agree = sizeof(Stored) == sizeof(Used) &&
                              alignof(Stored) >= alignof(Used) && std::is_standard_layout_v<Used>;

static_assert(agree<schema::Vec3, Vec3> && sizeof(Vec3) == 3 * sizeof(double));
static_assert(agree<schema::Triangle, std::array<std::uint32_t, 3>>);
static_assert(agree<schema::SupportPiece, SupportPiece> && offsetof(SupportPiece, center_r) == 0 &&
              offsetof(SupportPiece, center_z) == 8 && offsetof(SupportPiece, a) == 16 &&
              offsetof(SupportPiece, b) == 24);
static_assert(agree<schema::SdfCell, SdfCell> && offsetof(SdfCell, first_value) == 0 &&
              offsetof(SdfCell, level) == 4);
static_assert(agree<schema::CurvatureSample, CurvatureSample> &&
              offsetof(CurvatureSample, r) == 0 && offsetof(CurvatureSample, z) == 8 &&
              offsetof(CurvatureSample, arc_length) == 16 &&
              offsetof(CurvatureSample, mean_curvature) == 24);
static_assert(agree<schema::Node, SurfaceNodes::Node> && offsetof(SurfaceNodes::Node, x) == 0 &&
              offsetof(SurfaceNodes::Node, y) == 8 && offsetof(SurfaceNodes::Node, z) == 16 &&
              offsetof(SurfaceNodes::Node, mean_curvature) == 24);
static_assert(agree<schema::Ball, SurfaceNodes::Ball> && offsetof(SurfaceNodes::Ball, x) == 0 &&
              offsetof(SurfaceNodes::Ball, y) == 8 && offsetof(SurfaceNodes::Ball, z) == 16 &&
              offsetof(SurfaceNodes::Ball, radius) == 24);
static_assert(agree<schema::Ball, Clump::Ball> && offsetof(Clump::Ball, x) == 0 &&
              offsetof(Clump::Ball, y) == 8 && offsetof(Clump::Ball, z) == 16 &&
              offsetof(Clump::Ball, radius) == 24);
static_assert(agree<schema::ClumpSphere, ClumpSphere> && offsetof(ClumpSphere, x) == 0 &&
              offsetof(ClumpSphere, y) == 8 && offsetof(ClumpSphere, z) == 16 &&
              offsetof(ClumpSphere, radius) == 24 && offsetof(ClumpSphere, volume_share) == 32);
static_assert(agree<schema::WallBox, WallMesh::Box> && offsetof(WallMesh::Box, lower) == 0 &&
              offsetof(WallMesh::Box, upper) == 24 && offsetof(WallMesh::Box, first) == 48 &&
              offsetof(WallMesh::Box, count) == 52 && offsetof(WallMesh::Box, next) == 56 &&
              offsetof(WallMesh::Box, spare) == 60);

}  // namespace dem::layout
