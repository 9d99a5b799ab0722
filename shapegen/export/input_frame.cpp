// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/export/input_frame.hpp"

#include "common/units.hpp"
#include "formats/number_text.hpp"

namespace dem::shapegen {

std::string InputFrame::unit_name() const {
    for (const char* name : {"m", "mm", "um", "cm", "in"})
        if (unit_factor(name, Dimension::length) == unit_) return name;
    return number_text(unit_) + " m";
}

}  // namespace dem::shapegen
