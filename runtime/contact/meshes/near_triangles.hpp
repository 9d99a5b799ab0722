// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/meshes/mesh_touches.hpp"

#include <algorithm>

/// The triangles of a mesh wall near a body.
namespace dem::runtime {

/// What a kernel returns for bodies that are apart by a proven gap > 0 [m].
inline PairContact apart(const MeshCall& call, double gap) {
    const auto& [history, cache] = call.memory;
    cache.clear_until = call.travel + gap;
    return parting(history);
}

/// Width of the shell around a sphere in which triangles are listed, in radii.
inline constexpr double listed_shell = 0.01;
/// What rounding may do to positions and travels, generously, in radii.
inline constexpr double sphere_rounding = 1e-9;

/// The triangles near a sphere: those of the list in the cache as long as it is complete, else
/// those that the tree finds, of which a list is made unless there have been too many.
class NearTriangles {
  public:
    NearTriangles(const WallMesh& mesh, const Vec3& center, double radius, const MeshCall& call)
        : mesh_(mesh), center_(center), radius_(radius), call_(call) {}

    template <class Visit>
    void operator()(const Visit& visit) const {
        NearCache& cache = call_.memory.cache;
        if (call_.travel < cache.listed_until) {
            for (std::uint32_t n = 0; n < cache.count; ++n) visit(cache.nodes[n]);
        } else if (cache.count > NearCache::capacity) {
            visit_near_triangles(mesh_, center_, known_reach() * radius_, visit);
        } else {
            make_list(visit);
        }
    }
    /// No triangle that was not visited is nearer than this [m].
    double others() const {
        const NearCache& cache = call_.memory.cache;
        const double shell = cache.count > NearCache::capacity
                                 ? 0.0
                                 : std::max(0.0, cache.listed_until - call_.travel);
        return known_reach() * radius_ + shell;
    }

  private:
    double known_reach() const { return MeshTouches::reach(mesh_); }

    template <class Visit>
    void make_list(const Visit& visit) const {
        NearCache& cache = call_.memory.cache;
        const double reach = (known_reach() + listed_shell) * radius_;
        cache.count = 0;
        visit_near_triangles(mesh_, center_, reach, [&](std::uint32_t t) {
            if (!(visit(t) < reach) || cache.count > NearCache::capacity) return;
            if (cache.count < NearCache::capacity) cache.nodes[cache.count] = t;
            ++cache.count;
        });
        cache.listed_until = cache.count > NearCache::capacity
                                 ? 0.0
                                 : call_.travel + (listed_shell - sphere_rounding) * radius_;
    }

    const WallMesh& mesh_;
    Vec3 center_;
    double radius_;
    const MeshCall& call_;
};

}  // namespace dem::runtime
