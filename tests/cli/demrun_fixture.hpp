// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/cli/program.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <string>

namespace dem {

/// A folder with a case of twenty balls in a box, case.ini, that runs within a second.
class Demrun : public TemporaryFolder {
  protected:
    static constexpr const char* small_case =
        "[run]\nend_time = 20 ms\n"
        "[material.m]\ndensity = 1000\nyoungs_modulus = 5 MPa\npoissons_ratio = 0.3\n"
        "[contact]\nrestitution = 0.6\nfriction = 0.3\n"
        "[particles.balls]\nradius = 5 mm\nmaterial = m\ncount = 20\n"
        "region = box -20 -20 0 20 20 40 mm\n"
        "[wall.room]\nshape = box\nlower = -20 -20 0 mm\nupper = 20 20 60 mm\nmaterial = m\n";

    Demrun() { write("case.ini", small_case); }
    Outcome demrun(const std::string& arguments) const {
        return run_command(program("demrun") + " " + arguments, folder_);
    }
};

}  // namespace dem
