// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "runtime/region.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <variant>

namespace dem::runtime {

/// All that lies behind a plane: where normal . (x - point) < 0. The normal is a unit vector [m].
struct HalfSpace {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
};

/// One [outlet.NAME] section.
struct Outlet {
    enum class Kind : std::uint8_t {
        remove,  ///< takes out the bodies whose centers of mass get there
        flow     ///< counts those that pass its plane
    };
    std::string name;
    std::string where;  ///< "case.ini:31", for messages
    Kind kind = Kind::remove;
    std::variant<HalfSpace, BoxRegion, CylinderRegion> place;  ///< flow: a half space
    /// flow: of the disc around `point` that is looked at [m].
    double radius = std::numeric_limits<double>::infinity();
};

/// Whether a point is in the place of an outlet. Not for a point that is no number.
bool holds(const Outlet& outlet, const Vec3& x);

/// Whether bodies of a region may be in the place of an outlet at once. Of regions that lie aslant
/// to the axes their boxes are compared.
bool may_hold(const Outlet& outlet, const Region& region);

}  // namespace dem::runtime
