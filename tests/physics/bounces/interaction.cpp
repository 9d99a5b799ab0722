// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/bounces/interaction.hpp"

#include "runtime/contact/fields/clump_contact.hpp"

#include <algorithm>

namespace dem::test {

namespace {

std::size_t points_of(const ParticleTemplate& shape) {
    const auto* sr = std::get_if<SrShape>(&shape.shape);
    if (sr != nullptr) return sr->nodes.count;
    const auto* clump = std::get_if<Clump>(&shape.shape);
    return clump != nullptr ? contact_room(*clump) : 0;
}

template <class List>
class KernelOf : public Interaction {
  public:
    using A = typename List::A;
    using B = typename List::B;
    using Cache = typename List::Cache;

    KernelOf(const A& a, const B& b, std::size_t points) : a_(a), b_(b), points_(points) {}

    PairContact collide(const PairState& pair, const ContactLaw& law, double dt,
                        double travel) override {
        if constexpr (std::is_same_v<Cache, NoCache>) {
            return dem::collide(a_, b_, pair, law, dt, history_);
        } else if constexpr (std::is_same_v<Cache, NodeCache>) {
            return dem::collide(a_, b_, pair, law, dt,
                                NodeMemory{history_, cache_, points_, travel});
        } else if constexpr (std::is_same_v<typename List::History, ConvexHistory>) {
            return dem::collide(a_, b_, pair, law, dt, ConvexMemory{history_, cache_, scratch_});
        } else {
            return dem::collide(a_, b_, pair, law, dt, ContactMemory{history_, cache_});
        }
    }
    double gap([[maybe_unused]] double travel) const override {
        if constexpr (std::is_same_v<Cache, MissCache>) return cache_.gap;
        if constexpr (std::is_same_v<Cache, NodeCache>) return cache_.clear_until - travel;
        return 0.0;
    }

  private:
    const A& a_;
    const B& b_;
    typename List::History history_{};
    Cache cache_{};
    ContactScratch points_;
    ConvexScratch scratch_;
};

template <class Partner>
const auto& shape_of(const Partner& partner) {
    if constexpr (std::is_same_v<Partner, ParticleTemplate>)
        return partner.shape;
    else
        return partner;
}

template <class Lists, class Partner>
std::unique_ptr<Interaction> of_lists(const ParticleTemplate& a, const Partner& b,
                                      const ContactLaw& law, std::size_t points) {
    std::unique_ptr<Interaction> found;
    const auto look_at = [&](const auto& list) {
        using List = std::decay_t<decltype(list)>;
        if (found || !handles<List>(a, b, law)) return;
        found = std::make_unique<KernelOf<List>>(std::get<typename List::A>(a.shape),
                                                 std::get<typename List::B>(shape_of(b)), points);
    };
    std::apply([&](const auto&... list) { (look_at(list), ...); }, Lists{});
    return found;
}

}  // namespace

std::unique_ptr<Interaction> interaction(const ParticleTemplate& a, const ParticleTemplate& b,
                                         const ContactLaw& law) {
    return of_lists<PairLists>(a, b, law, std::max(points_of(a), points_of(b)));
}

std::unique_ptr<Interaction> interaction(const ParticleTemplate& a, const WallShape& b,
                                         const ContactLaw& law) {
    return of_lists<WallLists>(a, b, law, points_of(a));
}

}  // namespace dem::test
