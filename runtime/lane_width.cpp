// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/lane_width.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/contact/lanes/lane_kernels.hpp"

#include <cstdlib>
#include <string>

namespace dem::runtime {

int lane_width() {
    const int widest = widest_lanes();
    const char* const wanted = std::getenv("DEM_LANES");
    if (wanted == nullptr) return widest;
    for (const int width : {1, 2, 4, 8})
        if (std::to_string(width) == wanted && lane_kernels(width) != nullptr) return width;
    throw Error("DEM_LANES", in_quotes(wanted) + " found, expected 1, 2, 4 or 8 and at most " +
                                 std::to_string(widest) + ", what this processor has");
}

int lane_width(const Scene& scene) {
    return scene.run.lanes > 0 ? scene.run.lanes : lane_width();
}

}  // namespace dem::runtime
