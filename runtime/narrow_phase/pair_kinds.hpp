// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "runtime/contact/law/contact_point.hpp"
#include "runtime/contact/pairs/clump_clump.hpp"
#include "runtime/contact/pairs/clump_convex.hpp"
#include "runtime/contact/pairs/clump_sr.hpp"
#include "runtime/contact/pairs/clump_wall.hpp"
#include "runtime/contact/pairs/convex_convex.hpp"
#include "runtime/contact/pairs/convex_sr.hpp"
#include "runtime/contact/pairs/convex_wall.hpp"
#include "runtime/contact/pairs/sphere_sphere.hpp"
#include "runtime/contact/pairs/sphere_sr_nodes.hpp"
#include "runtime/contact/pairs/sphere_wall.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"
#include "runtime/narrow_phase/pair_list.hpp"

#include <tuple>
#include <utility>
#include <variant>

/// Every pair of shapes that the time loop supports: one line here, one `collide` overload in
/// runtime/contact.
namespace dem {

using PairLists = std::tuple<
    PairList<Sphere, Sphere, PointHistory, NoCache>,
    PairList<Sphere, SrShape, PointHistory, MissCache, ContactLaw::Method::continuous>,
    PairList<SrShape, Sphere, PointHistory, MissCache, ContactLaw::Method::continuous>,
    PairList<SrShape, SrShape, PointHistory, MissCache, ContactLaw::Method::continuous>,
    PairList<Sphere, SrShape, PatchHistory, NodeCache, ContactLaw::Method::nodes>,
    PairList<SrShape, Sphere, PatchHistory, NodeCache, ContactLaw::Method::nodes>,
    PairList<SrShape, SrShape, PatchHistory, NodeCache, ContactLaw::Method::nodes>,
    PairList<Clump, Clump, PatchHistory, NodeCache>,
    PairList<Sphere, Clump, PatchHistory, NodeCache>,
    PairList<Clump, Sphere, PatchHistory, NodeCache>,
    PairList<SrShape, Clump, PatchHistory, NodeCache>,
    PairList<Clump, SrShape, PatchHistory, NodeCache>,
    PairList<ConvexShape, ConvexShape, ConvexHistory, MissCache>,
    PairList<Sphere, ConvexShape, ConvexHistory, MissCache>,
    PairList<ConvexShape, Sphere, ConvexHistory, MissCache>,
    PairList<SrShape, ConvexShape, ConvexHistory, MissCache, ContactLaw::Method::continuous>,
    PairList<ConvexShape, SrShape, ConvexHistory, MissCache, ContactLaw::Method::continuous>,
    PairList<SrShape, ConvexShape, PatchHistory, NodeCache, ContactLaw::Method::nodes>,
    PairList<ConvexShape, SrShape, PatchHistory, NodeCache, ContactLaw::Method::nodes>,
    PairList<Clump, ConvexShape, PatchHistory, NodeCache>,
    PairList<ConvexShape, Clump, PatchHistory, NodeCache>>;

/// None where convex surfaces touch the wall by nodes.
template <class Wall>
struct SmoothWallList {
    using Type = std::tuple<>;
};
template <SmoothWall Wall>
struct SmoothWallList<Wall> {
    using Type = std::tuple<PairList<SrShape, Wall, typename SmoothHistory<Wall>::Type, MissCache,
                                     ContactLaw::Method::continuous>>;
};

/// Every kind of body with every shape of wall.
template <class... Wall>
auto lists_of_walls(const std::variant<Wall...>& shapes) -> decltype(std::tuple_cat(
    std::tuple<PairList<Sphere, Wall, PointHistory, NoCache>...>{},
    typename SmoothWallList<Wall>::Type{}...,
    std::tuple<PairList<SrShape, Wall, PatchHistory, NodeCache, ContactLaw::Method::nodes>...>{},
    std::tuple<PairList<Clump, Wall, PatchHistory, NodeCache>...>{},
    std::tuple<PairList<ConvexShape, Wall, ConvexHistory, MissCache>...>{}));
using WallLists = decltype(lists_of_walls(std::declval<WallShape>()));

/// How contacts of these spheres and SR shapes are computed: shapes that are not convex need nodes.
inline ContactLaw::Method contact_method(bool all_convex, const ContactLaw& law) {
    const bool with_nodes = law.method == ContactLaw::Method::nodes || !all_convex;
    return with_nodes ? ContactLaw::Method::nodes : ContactLaw::Method::continuous;
}

/// Whether a pair of shapes belongs to a list.
template <class List>
bool handles(const ParticleTemplate& a, const ParticleTemplate& b, const ContactLaw& law) {
    return std::holds_alternative<typename List::A>(a.shape) &&
           std::holds_alternative<typename List::B>(b.shape) &&
           (List::method == ContactLaw::Method::automatic ||
            List::method == contact_method(a.is_convex && b.is_convex, law));
}
template <class List>
bool handles(const ParticleTemplate& a, const WallShape& wall, const ContactLaw& law) {
    return std::holds_alternative<typename List::A>(a.shape) &&
           std::holds_alternative<typename List::B>(wall) &&
           (List::method == ContactLaw::Method::automatic ||
            List::method == contact_method(a.is_convex && SmoothWall<typename List::B>, law));
}

}  // namespace dem
