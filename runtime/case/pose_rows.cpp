// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/pose_rows.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "formats/memory_map.hpp"
#include "formats/number_text.hpp"
#include "runtime/domain.hpp"
#include "runtime/files/csv_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::runtime {

namespace {

/// The order of the values of a row.
const std::vector<std::string>& column_names() {
    static const std::vector<std::string> names = {"t", "x", "y", "z", "qw", "qx", "qy", "qz"};
    return names;
}
constexpr std::size_t first_of_quaternion = 4;
using Columns = std::vector<std::size_t>;  ///< of each field of a row, which value it is

Columns parse_header(const std::vector<std::string>& fields, const std::string& place) {
    const auto& names = column_names();
    Columns columns;
    for (const std::string& field : fields) {
        const auto column =
            static_cast<std::size_t>(std::ranges::find(names, field) - names.begin());
        if (column == names.size()) {
            throw Error(place, "unknown column " + in_quotes(field) +
                                   ", expected a header row of " + joined(names));
        }
        if (std::ranges::find(columns, column) != columns.end())
            throw Error(place, "column " + in_quotes(field) + " is given twice, expected it once");
        columns.push_back(column);
    }
    const bool has_quaternion = std::ranges::any_of(
        columns, [](std::size_t column) { return column >= first_of_quaternion; });
    const std::size_t expected = has_quaternion ? names.size() : first_of_quaternion;
    for (std::size_t column = 0; column < expected; ++column) {
        if (std::ranges::find(columns, column) != columns.end()) continue;
        throw Error(place, "no column " + in_quotes(names[column]) +
                               ", expected a header row of t,x,y,z, or of these and qw,qx,qy,qz");
    }
    return columns;
}

PoseTable::Row parse_row(const std::vector<std::string>& fields, const Columns& columns,
                         const std::string& place) {
    if (fields.size() != columns.size()) {
        throw Error(place, std::to_string(fields.size()) + " fields, expected " +
                               std::to_string(columns.size()) + " as in the header row");
    }
    std::array<double, 8> values = {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const auto value = finite_number(fields[k]);
        if (!value) {
            throw Error(place + ": column '" + column_names()[columns[k]] + "'",
                        "found " + in_quotes(fields[k]) + ", expected a finite number");
        }
        values[columns[k]] = *value;
    }
    PoseTable::Row row{
        values[0], {values[1], values[2], values[3]}, {values[4], values[5], values[6], values[7]}};
    if (!(row.time >= 0.0))
        throw Error(place, "found t = " + number_text(row.time) +
                               ", expected no time before 0: the wall would jump where it begins");
    if (row.position.cwiseAbs().maxCoeff() > farthest_coordinate)
        throw Error(place, "a position further than 1e6 m from the origin, expected it nearer");
    // Rounded to six digits it is off by less.
    constexpr double rounding = 1e-5;
    const double length = row.orientation.coeffs().stableNorm();
    if (!(std::abs(length - 1.0) <= rounding)) {
        throw Error(place, "the quaternion qw, qx, qy, qz has length " + number_text(length) +
                               ", expected 1");
    }
    row.orientation.coeffs() /= length;
    return row;
}

}  // namespace

namespace {

/// Throws Error unless a row follows the one before it in a way that has one meaning.
void check_step(const PoseTable::Row& before, const PoseTable::Row& row, const std::string& place) {
    if (!(row.time > before.time)) {
        throw Error(place, "found t = " + number_text(row.time) + " after t = " +
                               number_text(before.time) + ", expected times that rise");
    }
    // Of half the angle; which way half a turn goes is up to the sign of the quaternion.
    constexpr double least_cosine = 0.01;
    if (std::abs(row.orientation.dot(before.orientation)) < least_cosine) {
        throw Error(place,
                    "turns by half a turn from the row before, which may be either way, "
                    "expected rows in between");
    }
}

}  // namespace

std::vector<PoseTable::Row> parse_pose_rows(std::string_view text, const std::string& where) {
    CsvRows lines(text, where);
    std::vector<std::string> fields;
    if (!lines.next(fields)) throw Error(where, "is empty, expected a header row and poses");
    const Columns columns = parse_header(fields, lines.place());
    std::vector<PoseTable::Row> rows;
    while (lines.next(fields)) {
        rows.push_back(parse_row(fields, columns, lines.place()));
        if (rows.size() > 1) check_step(rows[rows.size() - 2], rows.back(), lines.place());
    }
    if (rows.size() < 2) {
        throw Error(where, "holds " + std::to_string(rows.size()) +
                               (rows.size() == 1 ? " pose" : " poses") +
                               ", expected two or more to move between");
    }
    return rows;
}

std::vector<PoseTable::Row> read_pose_rows(const std::string& path) {
    const MemoryMap map(path, "table of poses");
    const auto* text = reinterpret_cast<const char*>(map.bytes().data());
    return parse_pose_rows(std::string_view(text, map.bytes().size()), path);
}

}  // namespace dem::runtime
