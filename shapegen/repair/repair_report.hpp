// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/math/types.hpp"

#include <string>
#include <vector>

namespace dem::shapegen {

/// Defects of one kind, and what was done about them.
struct Finding {
    std::string what;  ///< "holes", "duplicate triangles"
    std::size_t count = 0;
    Vec3 place = Vec3::Zero();  ///< the first or largest of them [m]
    std::string treatment;      ///< "closed", "removed"; what is expected when it was refused
    double volume = 0.0;        ///< what the treatment changed, or may have got wrong [m^3]
};

/// Everything that a mesh needed to become the surface of a solid; empty when it was one already.
struct RepairReport {
    std::vector<Finding> findings;
    double volume = 0.0;  ///< of the solid [m^3]

    /// Adds a finding, to the one of the same kind when there is one already.
    void add(const Finding& finding);
    /// Fraction of the volume that the repairs changed or may have got wrong.
    double changed_fraction() const;
};

/// "holes: 5, one at (-43.7, 33.9, 9.3), 0.21 % of the volume, closed". Places in the coordinates
/// of the file, `file_unit` meters each; `volume` [m^3] is what the percentage refers to, 0 leaves
/// it out.
std::string describe(const Finding& finding, double file_unit, double volume);

/// One line per finding, then the fraction in all.
std::vector<std::string> describe(const RepairReport& report, double file_unit);

/// "0.21 %", "351 %", "more than 1000 %": two digits, whole numbers from 10 % on.
std::string percentage(double fraction);

}  // namespace dem::shapegen
