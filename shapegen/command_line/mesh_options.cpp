// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/mesh_options.hpp"

namespace dem::shapegen {

MeshLoadOptions read_mesh_options(const OptionValues& values) {
    MeshLoadOptions options;
    if (values.given("unit")) {
        values.length_unit("unit");
        options.unit = values.text("unit");
    }
    options.scale = values.number("scale");
    options.repair_limit = values.fraction("repair-limit");
    options.keep_largest = values.given("largest");
    options.unite = values.given("union");
    return options;
}

}  // namespace dem::shapegen
