// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/error.hpp"
#include "runtime/case/read_scene.hpp"

#include <string>

namespace dem::runtime {

/// A complete case of spheres in a vessel; the sections of `more` come after it.
inline std::string sphere_case(const std::string& more = "") {
    return "[run]\n"
           "end_time = 1 s\n"
           "[material.coating]\n"
           "density = 1000\n"
           "youngs_modulus = 50 MPa\n"
           "poissons_ratio = 0.3\n"
           "[material.steel]\n"
           "shear_modulus = 20 MPa\n"
           "poissons_ratio = 0.25\n"
           "[contact]\n"
           "restitution = 0.6\n"
           "friction = 0.38\n"
           "[contact.steel.coating]\n"
           "friction = 0.22\n"
           "[particles.balls]\n"
           "radius = 5 mm\n"
           "material = coating\n"
           "count = 20\n"
           "region = cylinder 0 0 10 mm  0 0 100 mm  25 mm\n"
           "[wall.vessel]\n"
           "shape = cylinder\n"
           "point = 0 0 0\n"
           "radius = 25 mm\n"
           "material = steel\n" +
           more;
}

/// The case with overrides ("section.key=value") applied.
template <class... Overrides>
Scene scene_of(const std::string& text, const Overrides&... overrides) {
    CaseFile file = parse_case(text, "c.ini");
    (override_value(file, overrides), ...);
    return read_scene(file);
}

/// The error of reading it, or "fine".
template <class... Overrides>
std::string case_message(const std::string& text, const Overrides&... overrides) {
    try {
        scene_of(text, overrides...);
    } catch (const Error& error) {
        return error.what();
    }
    return "fine";
}

}  // namespace dem::runtime
