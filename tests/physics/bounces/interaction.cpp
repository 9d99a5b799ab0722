// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/bounces/interaction.hpp"

#include "runtime/contact/fields/clump_contact.hpp"

#include <algorithm>

namespace dem::test {

using namespace runtime;

namespace {

std::size_t points_of(const ParticleTemplate& shape) {
    const auto* sr = std::get_if<SrShape>(&shape.shape);
    if (sr != nullptr) return sr->nodes.count;
    const auto* clump = std::get_if<Clump>(&shape.shape);
    return clump != nullptr ? contact_room(*clump) : 0;
}

template <class Row>
class KernelOf : public Interaction {
  public:
    using A = typename Row::A;
    using B = typename Row::B;
    using Cache = typename Row::Cache;

    KernelOf(const A& a, const B& b, bool is_reversed, std::size_t points)
        : a_(a), b_(b), is_reversed_(is_reversed), points_(points) {}

    PairContact collide(const PairState& pair, const ContactLaw& law, double dt,
                        double travel) override {
        const Memory memory{history_, cache_};
        const Scratch room{&points_, &features_};
        if (!is_reversed_)
            return runtime::collide(a_, b_, Call{pair, law, dt, memory, travel, room});
        const PairState back = reversed(pair);
        return reversed(runtime::collide(a_, b_, Call{back, law, dt, memory, travel, room}),
                        pair.displacement);
    }
    double gap([[maybe_unused]] double travel) const override {
        if constexpr (std::is_same_v<Cache, MissCache>) return cache_.gap;
        if constexpr (std::is_same_v<Cache, NearCache>) return cache_.clear_until - travel;
        return 0.0;
    }

  private:
    const A& a_;
    const B& b_;
    bool is_reversed_;
    typename Row::History history_{};
    Cache cache_{};
    ContactScratch points_;
    ConvexScratch features_;
};

}  // namespace

std::unique_ptr<Interaction> interaction(const ParticleTemplate& a, const ParticleTemplate& b,
                                         const ContactLaw& law) {
    const std::size_t points = std::max(points_of(a), points_of(b));
    return ParticlePairs::at_row_of(a, b, law, [&]<class Row>() -> std::unique_ptr<Interaction> {
        const bool is_reversed = !std::holds_alternative<typename Row::A>(a.shape) ||
                                 !std::holds_alternative<typename Row::B>(b.shape);
        return std::make_unique<KernelOf<Row>>(
            std::get<typename Row::A>((is_reversed ? b : a).shape),
            std::get<typename Row::B>((is_reversed ? a : b).shape), is_reversed, points);
    });
}

std::unique_ptr<Interaction> interaction(const ParticleTemplate& a, const WallShape& b,
                                         const ContactLaw& law) {
    return WallPairs::at_row_of(a, b, law, [&]<class Row>() -> std::unique_ptr<Interaction> {
        return std::make_unique<KernelOf<Row>>(std::get<typename Row::A>(a.shape),
                                               std::get<typename Row::B>(b), false, points_of(a));
    });
}

}  // namespace dem::test
