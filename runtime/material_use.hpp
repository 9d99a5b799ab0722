// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/scene.hpp"

#include <cstdint>
#include <set>

namespace dem::runtime {

/// Which materials a scene is made of, as indices into Scene::materials. Walls meet only bodies.
struct MaterialUse {
    std::set<std::uint32_t> bodies, walls;

    bool can_meet(std::uint32_t a, std::uint32_t b) const {
        return (bodies.contains(a) && (bodies.contains(b) || walls.contains(b))) ||
               (bodies.contains(b) && walls.contains(a));
    }
};

inline MaterialUse material_use(const Scene& scene) {
    MaterialUse use;
    for (const BodyKind& kind : scene.kinds) use.bodies.insert(kind.material);
    for (const Wall& wall : scene.walls) use.walls.insert(wall.material);
    return use;
}

}  // namespace dem::runtime
