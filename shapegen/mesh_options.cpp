// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/mesh_options.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "shapegen/option_values.hpp"

namespace dem {

namespace po = boost::program_options;

po::options_description mesh_options() {
    po::options_description options("Meshes (docs/mesh-import.md)");
    options.add_options()("unit", text("UNIT"),
                          "of the file's coordinates: m, mm, um, cm, in; default: mm, m for glTF")(
        "repair-limit", text("F")->default_value("1%"),
        "largest part of the volume that repairs may put at stake")(
        "largest", "of several bodies in a file keep the largest")(
        "union", "make one body of parts that cross, touch or hold each other");
    return options;
}

MeshLoadOptions read_mesh_options(const po::variables_map& values) {
    MeshLoadOptions options;
    if (is_given(values, "unit")) {
        options.unit = values["unit"].as<std::string>();
        length_unit_option(values, "unit");
    }
    const auto scale = values["scale"].as<std::string>();
    const auto number = finite_number(scale);
    if (!number || !(*number > 0.0))
        throw UsageError("--scale", "found " + in_quotes(scale) + ", expected a number above 0");
    options.scale = *number;
    options.repair_limit =
        fraction_option(values, "repair-limit", -1e-300, 1.0, "0 or more and below 1 (0.01 or 1%)");
    options.keep_largest = values.count("largest") != 0;
    options.unite = values.count("union") != 0;
    return options;
}

}  // namespace dem
