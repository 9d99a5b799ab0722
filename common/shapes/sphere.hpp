// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace dem {

/// An exact sphere about the body's origin.
struct Sphere {
    double radius = 0.0;  ///< [m]
};

}  // namespace dem
