// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/body_table.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "formats/memory_map.hpp"
#include "formats/number_text.hpp"
#include "runtime/files/csv_rows.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

enum Column : std::size_t {
    id,
    template_name,
    group,
    x,
    y,
    z,
    qw,
    qx,
    qy,
    qz,
    vx,
    vy,
    vz,
    wx,
    wy,
    wz
};

const std::vector<std::string>& column_names() {
    static const std::vector<std::string> names = {"id", "template", "group", "x",  "y",  "z",
                                                   "qw", "qx",       "qy",    "qz", "vx", "vy",
                                                   "vz", "wx",       "wy",    "wz"};
    return names;
}

/// What each field of a row means, from the header row.
std::vector<Column> parse_header(const std::vector<std::string>& fields, const std::string& place) {
    const auto& names = column_names();
    std::vector<Column> columns;
    for (const std::string& field : fields) {
        const auto found = std::find(names.begin(), names.end(), field);
        if (found == names.end()) {
            throw Error(place, "unknown column " + in_quotes(field) + suggestion(field, names) +
                                   ", expected a header row of " + joined(names));
        }
        const auto column = static_cast<Column>(found - names.begin());
        if (std::find(columns.begin(), columns.end(), column) != columns.end()) {
            throw Error(place, "column " + in_quotes(field) + " is given twice, expected it once");
        }
        columns.push_back(column);
    }
    const auto parts =
        std::count_if(columns.begin(), columns.end(), [](Column c) { return c >= qw && c <= qz; });
    if (parts != 0 && parts != 4) {
        throw Error(place, "found " + std::to_string(parts) +
                               " of qw, qx, qy and qz, expected all or none of them");
    }
    return columns;
}

std::uint64_t count(const std::string& field) {
    const auto value = whole_number(field);
    if (!value) throw Error("found " + in_quotes(field) + ", expected a whole number");
    return *value;
}

double number(const std::string& field) {
    const auto value = finite_number(field);
    if (!value) throw Error("found " + in_quotes(field) + ", expected a finite number");
    return *value;
}

void assign(BodyRow& body, Column column, const std::string& field) {
    switch (column) {
        case id:
            body.id = count(field);
            return;
        case template_name:
            body.template_name = field;
            return;
        case group:
            body.group = field;
            return;
        default:
            break;
    }
    const auto value = number(field);
    switch (column) {
        case qw:
            body.orientation.w() = value;
            break;
        case qx:
            body.orientation.x() = value;
            break;
        case qy:
            body.orientation.y() = value;
            break;
        case qz:
            body.orientation.z() = value;
            break;
        default:
            if (column <= z) {
                body.position[static_cast<Eigen::Index>(column - x)] = value;
            } else if (column <= vz) {
                body.velocity[static_cast<Eigen::Index>(column - vx)] = value;
            } else {
                body.angular_velocity[static_cast<Eigen::Index>(column - wx)] = value;
            }
    }
}

void normalize(Quat& q, const std::string& place) {
    const double length = std::sqrt(q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
    if (!(std::abs(length - 1.0) <= 1e-3)) {
        throw Error(place, "the quaternion qw, qx, qy, qz has length " + number_text(length) +
                               ", expected 1");
    }
    // A state that we wrote goes on with the same bits; one typed by hand is rounded.
    if (std::abs(length - 1.0) > 1e-12) q.coeffs() /= length;
}

BodyRow parse_row(const std::vector<std::string>& fields, const std::vector<Column>& columns,
                  const std::string& place) {
    if (fields.size() != columns.size()) {
        throw Error(place, std::to_string(fields.size()) + " fields, expected " +
                               std::to_string(columns.size()) + " as in the header row");
    }
    BodyRow body;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        try {
            assign(body, columns[i], fields[i]);
        } catch (const Error& e) {
            throw Error(place + ": column '" + column_names()[columns[i]] + "'", e.what());
        }
    }
    normalize(body.orientation, place);
    return body;
}

}  // namespace

std::vector<BodyRow> parse_body_table(std::string_view text, const std::string& where) {
    CsvRows rows(text, where);
    std::vector<std::string> fields;
    if (!rows.next(fields)) throw Error(where, "is empty, expected a header row and bodies");
    const std::vector<Column> columns = parse_header(fields, rows.place());
    std::vector<BodyRow> bodies;
    while (rows.next(fields)) {
        bodies.push_back(parse_row(fields, columns, rows.place()));
        bodies.back().line = rows.line();
    }
    if (bodies.empty()) throw Error(where, "holds only a header row, expected bodies below it");
    return bodies;
}

std::vector<BodyRow> read_body_table(const std::filesystem::path& path) {
    const MemoryMap map(path, "table of bodies");
    const auto* text = reinterpret_cast<const char*>(map.bytes().data());
    return parse_body_table(std::string_view(text, map.bytes().size()), path.string());
}

void write_body_table(const std::filesystem::path& path, std::span<const BodyRow> bodies) {
    AtomicFile file(path);
    std::string line;
    for (const std::string& name : column_names()) line += (line.empty() ? "" : ",") + name;
    file.write(line + "\n");
    for (const BodyRow& body : bodies) {
        line = std::to_string(body.id) + ',' + csv_field(body.template_name) + ',' +
               csv_field(body.group);
        const Quat& q = body.orientation;
        for (const double value :
             {body.position.x(), body.position.y(), body.position.z(), q.w(), q.x(), q.y(), q.z(),
              body.velocity.x(), body.velocity.y(), body.velocity.z(), body.angular_velocity.x(),
              body.angular_velocity.y(), body.angular_velocity.z()}) {
            line += ',' + number_text(value);
        }
        file.write(line + "\n");
    }
    file.commit();
}

}  // namespace dem::runtime
