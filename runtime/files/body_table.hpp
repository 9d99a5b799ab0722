// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Tables of bodies as comma-separated text (docs/output-files.md): what `insert = file` reads and
/// final.csv holds. Columns, SI, world frame:
///     id, template, group, x, y, z, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz
namespace dem::runtime {

struct BodyRow {
    std::uint64_t id = 0;
    std::string template_name;     ///< of the shape; empty where the column is missing
    std::string group;             ///< of the [particles.NAME] section; empty where it is missing
    Vec3 position = Vec3::Zero();  ///< of the center of mass [m]
    Quat orientation = Quat::Identity();   ///< body -> world
    Vec3 velocity = Vec3::Zero();          ///< [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
    std::size_t line = 0;                  ///< of the file it was read from, for messages
};

/// Reads a table with a header row; columns in any order, missing ones are zero and identity.
/// A quaternion within 1e-3 of unit length is normalized (within 1e-12 it is kept bit by bit).
/// Throws Error with file and line: an unknown (suggests the nearest) or repeated column, an
/// incomplete quaternion, a row of another length, a field that is not a finite number, a
/// quaternion that is not a unit one, no rows.
std::vector<BodyRow> read_body_table(const std::filesystem::path& path);

/// Reads the table from text in memory; `where` names it in messages.
std::vector<BodyRow> parse_body_table(std::string_view text, const std::string& where);

/// Writes all columns, whole or not at all; every number reads back as the same double.
void write_body_table(const std::filesystem::path& path, std::span<const BodyRow> bodies);

}  // namespace dem::runtime
