// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/particle_template.hpp"
#include "runtime/contact/pairs/ball_mesh.hpp"
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
#include "runtime/contact/pairs/sr_mesh.hpp"
#include "runtime/contact/pairs/sr_sr_continuous.hpp"
#include "runtime/contact/pairs/sr_sr_nodes.hpp"
#include "runtime/contact/pairs/sr_wall.hpp"
#include "runtime/contact/pairs/sr_wall_nodes.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>

/// Every pair of shapes that can touch: one row here, one `collide` beside it. A host makes a list
/// of pairs for each row and calls the row's kernel for the pairs in it.
namespace dem::runtime {

/// A word as an argument of a template.
template <std::size_t size>
struct Word {
    char text[size]{};  // NOLINT(*-avoid-c-arrays): the form that literals have
    constexpr Word(const char (&literal)[size]) {  // NOLINT(*-avoid-c-arrays,*-explicit-*)
        std::copy_n(literal, size, text);
    }
};

inline const char* shape_word(const Sphere* /*kind*/) {
    return "sphere";
}
inline const char* shape_word(const SrShape* /*kind*/) {
    return "sr";
}
inline const char* shape_word(const Clump* /*kind*/) {
    return "clump";
}
inline const char* shape_word(const ConvexShape* /*kind*/) {
    return "convex";
}

/// A pair of kinds of shapes. `row_name` is what checkpoints know it by: never to be given to
/// another. History and Cache: what a pair remembers. `Method`: the way of computing contacts that
/// the row is for; automatic: the only one there is.
template <Word row_name, class ShapeA, class ShapeB, class HistoryType, class CacheType,
          ContactLaw::Method Method = ContactLaw::Method::automatic>
struct PairRow {
    using A = ShapeA;
    using B = ShapeB;
    using History = HistoryType;
    using Cache = CacheType;
    static std::string name() { return row_name.text; }
    static constexpr ContactLaw::Method method = Method;

    /// Whether the row is for these two, in this order or, of two particles, in the other.
    template <class Shape, class Other>
    static constexpr bool is_for(ContactLaw::Method wanted) {
        const bool is_pair = (std::is_same_v<A, Shape> && std::is_same_v<B, Other>) ||
                             (std::is_same_v<A, Other> && std::is_same_v<B, Shape>);
        return is_pair && (method == ContactLaw::Method::automatic || method == wanted);
    }
};

/// How contacts of these spheres and SR shapes are computed: shapes that are not convex need nodes.
inline ContactLaw::Method contact_method(bool all_convex, const ContactLaw& law) {
    const bool with_nodes = law.geometry.method == ContactLaw::Method::nodes || !all_convex;
    return with_nodes ? ContactLaw::Method::nodes : ContactLaw::Method::continuous;
}

/// Whether a pair belongs to a row.
template <class Row>
bool handles(const ParticleTemplate& a, const ParticleTemplate& b, const ContactLaw& law) {
    using A = typename Row::A;
    using B = typename Row::B;
    const auto hold = [](const ParticleTemplate& first, const ParticleTemplate& second) {
        return std::holds_alternative<A>(first.shape) && std::holds_alternative<B>(second.shape);
    };
    return (hold(a, b) || hold(b, a)) &&
           (Row::method == ContactLaw::Method::automatic ||
            Row::method == contact_method(a.is_convex && b.is_convex, law));
}
template <class Row>
bool handles(const ParticleTemplate& a, const WallShape& wall, const ContactLaw& law) {
    return std::holds_alternative<typename Row::A>(a.shape) &&
           std::holds_alternative<typename Row::B>(wall) &&
           (Row::method == ContactLaw::Method::automatic ||
            Row::method == contact_method(a.is_convex && SmoothWall<typename Row::B>, law));
}

template <class... Row>
struct PairTable {
    /// One List<Row> for each row.
    template <template <class> class List>
    using Lists = std::tuple<List<Row>...>;

    static constexpr std::size_t size = sizeof...(Row);

    /// What f<Row>() returns for the row that a pair belongs to.
    template <class Partner, class Visit>
    static auto at_row_of(const ParticleTemplate& a, const Partner& b, const ContactLaw& law,
                          const Visit& f) {
        using First = std::tuple_element_t<0, std::tuple<Row...>>;
        decltype(f.template operator()<First>()) result{};
        static_cast<void>(
            ((handles<Row>(a, b, law) && ((result = f.template operator()<Row>()), true)) || ...));
        return result;
    }

    template <class A, class B>
    static constexpr int rows_for(ContactLaw::Method method) {
        return (0 + ... + static_cast<int>(Row::template is_for<A, B>(method)));
    }
};

using ParticleShape = decltype(ParticleTemplate::shape);

using ParticlePairs = PairTable<
    PairRow<"sphere-sphere", Sphere, Sphere, PointHistory, NoCache>,
    PairRow<"sphere-sr", Sphere, SrShape, PointHistory, MissCache, ContactLaw::Method::continuous>,
    PairRow<"sr-sr", SrShape, SrShape, PointHistory, MissCache, ContactLaw::Method::continuous>,
    PairRow<"sphere-sr.nodes", Sphere, SrShape, PatchHistory, NearCache, ContactLaw::Method::nodes>,
    PairRow<"sr-sr.nodes", SrShape, SrShape, PatchHistory, NearCache, ContactLaw::Method::nodes>,
    PairRow<"clump-clump", Clump, Clump, PatchHistory, NearCache>,
    PairRow<"sphere-clump", Sphere, Clump, PatchHistory, NearCache>,
    PairRow<"clump-sr", Clump, SrShape, PatchHistory, NearCache>,
    PairRow<"convex-convex", ConvexShape, ConvexShape, ConvexHistory, MissCache>,
    PairRow<"sphere-convex", Sphere, ConvexShape, ConvexHistory, MissCache>,
    PairRow<"sr-convex", SrShape, ConvexShape, ConvexHistory, MissCache,
            ContactLaw::Method::continuous>,
    PairRow<"sr-convex.nodes", SrShape, ConvexShape, PatchHistory, NearCache,
            ContactLaw::Method::nodes>,
    PairRow<"clump-convex", Clump, ConvexShape, PatchHistory, NearCache>>;

/// A kind of body and a wall; the name is made of both.
template <class Shape, class Wall, class History, class Cache,
          ContactLaw::Method Method = ContactLaw::Method::automatic>
struct WallRow : PairRow<"", Shape, Wall, History, Cache, Method> {
    static std::string name() {
        std::string both = shape_word(static_cast<const Shape*>(nullptr));
        both += "-" + std::string(Wall::name);
        return Method == ContactLaw::Method::nodes ? both + ".nodes" : both;
    }
};

template <class... Table>
struct Joined;
template <class... Row>
struct Joined<PairTable<Row...>> {
    using Type = PairTable<Row...>;
};
template <class... Row, class... Other, class... Rest>
struct Joined<PairTable<Row...>, PairTable<Other...>, Rest...> {
    using Type = typename Joined<PairTable<Row..., Other...>, Rest...>::Type;
};

/// None where convex surfaces touch the wall by nodes.
template <class Wall>
struct SmoothWallRow {
    using Type = PairTable<>;
};
template <SmoothWall Wall>
struct SmoothWallRow<Wall> {
    using Type = PairTable<WallRow<SrShape, Wall, typename SmoothHistory<Wall>::Type, MissCache,
                                   ContactLaw::Method::continuous>>;
};

/// Every kind of body with every shape of wall that is a field of distances.
template <class Walls>
struct RowsOfWalls;
template <class... Wall>
struct RowsOfWalls<std::variant<Wall...>> {
    using Type = typename Joined<
        PairTable<WallRow<Sphere, Wall, PointHistory, NoCache>...>,
        typename SmoothWallRow<Wall>::Type...,
        PairTable<WallRow<SrShape, Wall, PatchHistory, NearCache, ContactLaw::Method::nodes>...>,
        PairTable<WallRow<Clump, Wall, PatchHistory, NearCache>...>,
        PairTable<WallRow<ConvexShape, Wall, ConvexHistory, MissCache>...>>::Type;
};
using MeshPairs =
    PairTable<WallRow<Sphere, MeshWall, MeshHistory, NearCache>,
              WallRow<Clump, MeshWall, MeshHistory, NearCache>,
              WallRow<SrShape, MeshWall, MeshHistory, NearCache, ContactLaw::Method::continuous>>;
using WallPairs = typename Joined<RowsOfWalls<FieldWallShape>::Type, MeshPairs>::Type;

/// Whether contacts of two kinds are computed by every method; cases with others are refused when
/// they are read.
template <class A, class B>
inline constexpr bool is_computed = true;
template <>
inline constexpr bool is_computed<SrShape, MeshWall> = false;
template <>
inline constexpr bool is_computed<ConvexShape, MeshWall> = false;

/// Surfaces of revolution are the only ones that walls may have no smooth kernel for.
template <class B>
inline constexpr bool has_smooth_kernel = SmoothWall<B> || !AnyWall<B>;

template <class Table, class A, class... B>
constexpr bool has_rows_for(const std::variant<B...>* /*partners*/) {
    using Method = ContactLaw::Method;
    return (true && ... &&
            (!is_computed<A, B> ||
             (Table::template rows_for<A, B>(Method::nodes) == 1 &&
              (!has_smooth_kernel<B> || Table::template rows_for<A, B>(Method::continuous) == 1))));
}
/// Whether each combination of a shape and a partner has one row, whatever the method.
template <class Table, class Partners, class... A>
constexpr bool is_complete(const std::variant<A...>* /*shapes*/) {
    return (true && ... && has_rows_for<Table, A>(static_cast<const Partners*>(nullptr)));
}
static_assert(is_complete<ParticlePairs, ParticleShape>(static_cast<const ParticleShape*>(nullptr)),
              "a pair of kinds of particles without a row, or with two");
static_assert(is_complete<WallPairs, WallShape>(static_cast<const ParticleShape*>(nullptr)),
              "a kind of particles and a wall without a row, or with two");

/// Kernels are written for a pair in the order of its row. Where the first of a pair (the one with
/// the lower id) is the second of the row, the kernel is given the pair as its second sees it, and
/// what it says is turned back.
inline PairState reversed(const PairState& pair) {
    return {-pair.displacement, pair.j, pair.i};
}
/// `displacement`: from the center of the first of the pair to that of the second [m].
inline PairContact reversed(PairContact contact, const Vec3& displacement) {
    contact.force = -contact.force;
    std::swap(contact.torque_i, contact.torque_j);
    contact.place += displacement;
    contact.normal = -contact.normal;
    contact.friction = -contact.friction;
    return contact;
}

}  // namespace dem::runtime
