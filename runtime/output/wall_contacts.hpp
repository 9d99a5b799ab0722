// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/files/wall_contact_series.hpp"
#include "runtime/simulation.hpp"

#include <vector>

namespace dem::runtime {

/// What had been done to the triangles of walls at the last frame: means are taken since.
struct LoadsOfLastFrame {
    double time = 0.0;  ///< [s]
    std::vector<double> normal, shear, friction_work;

    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit("outputs.loads.time", self.time);
        visit("outputs.loads.normal", self.normal);
        visit("outputs.loads.shear", self.shear);
        visit("outputs.loads.friction_work", self.friction_work);
    }
};

/// The triangles of a scene's mesh walls.
WallTriangles wall_triangles(const Scene& scene);

/// The loads for a frame at the present time; `last` becomes those of this frame.
WallContactTable wall_contact_table(const Simulation& simulation, const WallTriangles& walls,
                                    LoadsOfLastFrame& last);

}  // namespace dem::runtime
