// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/body_rows.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/domain.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace dem::runtime {

namespace {

/// Rows of one group of the run that wrote the table.
std::vector<BodyRow> rows_of_group(std::vector<BodyRow> rows, const std::string& group,
                                   const std::string& where) {
    std::vector<std::string> known;
    for (const BodyRow& row : rows) {
        if (std::find(known.begin(), known.end(), row.group) == known.end()) {
            known.push_back(row.group);
        }
    }
    std::erase_if(rows, [&group](const BodyRow& row) { return row.group != group; });
    if (rows.empty()) {
        throw Error(where, "no row of group " + in_quotes(group) + " in the table" +
                               suggestion_or_all(group, known));
    }
    return rows;
}

}  // namespace

std::vector<BodyRow> read_body_rows(const Values& values, const std::filesystem::path& folder,
                                    InsertionGroup& group) {
    group.file = (folder / values.text("file")).lexically_normal().string();
    group.allow_overlaps = values.word("overlaps") == "allow";
    if (!std::filesystem::exists(group.file)) {
        throw Error(values.where("file"),
                    "no such file " + in_quotes(group.file) + ", expected a table of bodies");
    }
    std::vector<BodyRow> rows = read_body_table(group.file);
    if (values.has("file_group")) {
        rows =
            rows_of_group(std::move(rows), values.text("file_group"), values.where("file_group"));
    }
    for (const BodyRow& row : rows) {
        if (!(row.position.cwiseAbs().maxCoeff() > farthest_coordinate)) continue;
        throw Error(group.file + ":" + std::to_string(row.line),
                    "a body further than 1e6 m from the origin, expected it nearer: so far out "
                    "positions lose the digits that contacts need");
    }
    group.count = rows.size();
    return rows;
}

void place_rows(const std::vector<BodyRow>& rows, InsertionGroup& group) {
    group.placements.reserve(rows.size());
    for (const BodyRow& row : rows) {
        BodyPlacement body;
        body.position = row.position;
        body.orientation = row.orientation;
        body.velocity = row.velocity;
        body.angular_velocity = row.angular_velocity;
        body.kind = group.kinds[group.placements.size() % group.kinds.size()];
        body.line = row.line;
        group.placements.push_back(body);
    }
    std::sort(group.kinds.begin(), group.kinds.end());
    group.kinds.erase(std::unique(group.kinds.begin(), group.kinds.end()), group.kinds.end());
}

}  // namespace dem::runtime
