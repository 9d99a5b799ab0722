// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"
#include "runtime/contact/cores/gjk.hpp"
#include "runtime/contact/cores/leash.hpp"
#include "runtime/contact/law/contact_law.hpp"
#include "runtime/contact/law/torsion.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

/// The contact of two bodies with flat parts as one potential (docs/contact-convex.md, "Features"):
///     d = (sum s_k d_k^p)^(1/p),  w_k = s_k (d_k/d)^(p-1),  p = 16
/// d_k overlap and s_k weight of feature k. The deepest feature is known beforehand, so that all
/// sums are made in one pass and no feature is stored.
namespace dem::runtime {

/// Derivative of a number with respect to a motion of the pair: to velocity of i (minus that of j),
/// to the angular velocities of i and of j.
struct PairGradient {
    Vec3 shift = Vec3::Zero();
    Vec3 turn_i = Vec3::Zero();
    Vec3 turn_j = Vec3::Zero();
};

/// A force on i and its torques on both.
struct PairWrench {
    Vec3 force = Vec3::Zero();
    Vec3 torque_i = Vec3::Zero();
    Vec3 torque_j = Vec3::Zero();

    void add(double scale, const PairWrench& other) {
        force += scale * other.force;
        torque_i += scale * other.torque_i;
        torque_j += scale * other.torque_j;
    }
};

/// Where two rounded features are near each other.
struct FeaturePoint {
    Vec3 position;   ///< midway between the two surfaces, relative to the center of i [m]
    Vec3 normal;     ///< unit, from j towards i
    double overlap;  ///< [m], > 0
};

class FeatureSum {
  public:
    /// `deepest`: overlap of no less than any feature's [m].
    FeatureSum(const PairState& pair, double deepest) : pair_(pair), deepest_(deepest) {}

    void add(const FeaturePoint& p, double weight) {
        const double x = p.overlap / deepest_;
        const double x2 = x * x;
        const double x4 = x2 * x2;
        const double w = weight * (x4 * x4) * x4 * x2 * x;
        power_ += w * x;
        weight_ += w;
        const Vec3 lever_j = p.position - pair_.displacement;
        const PairWrench along{p.normal, p.position.cross(p.normal), -lever_j.cross(p.normal)};
        const double rate = -(pair_.i.velocity - pair_.j.velocity).dot(p.normal) -
                            pair_.i.angular_velocity.dot(along.torque_i) -
                            pair_.j.angular_velocity.dot(along.torque_j);
        direction_.add(w, along);
        rates_.add(w * rate, along);
        rate_ += w * rate;
        squared_rate_ += w * rate * rate;
        position_ += w * p.position;
        squared_position_ += w * (p.position * p.position.transpose());
        ++count_;
    }

    /// The part of the force of a feature that its changing weight makes.
    void add_weight_gradient(const FeaturePoint& p, const PairGradient& of_weight) {
        const double x = p.overlap / deepest_;
        const double scale = -deepest_ / 16.0 * square(square(square(square(x))));
        of_weights_.add(scale, {of_weight.shift, of_weight.turn_i, of_weight.turn_j});
    }

    /// All features of another sum with the same deepest overlap, their weights times a factor.
    void add(const FeatureSum& other, double factor) {
        power_ += factor * other.power_;
        weight_ += factor * other.weight_;
        rate_ += factor * other.rate_;
        squared_rate_ += factor * other.squared_rate_;
        direction_.add(factor, other.direction_);
        of_weights_.add(factor, other.of_weights_);
        rates_.add(factor, other.rates_);
        position_ += factor * other.position_;
        squared_position_ += factor * other.squared_position_;
        count_ += other.count_;
    }

    /// sum s_k (d_k / deepest)^p
    double power() const { return power_; }
    bool empty() const { return !(power_ > 0.0); }
    std::uint32_t count() const { return count_; }
    const PairState& pair() const { return pair_; }
    double deepest() const { return deepest_; }

    /// d [m].
    double overlap() const { return deepest_ * root(); }
    /// What the sums of this class are to be multiplied with.
    double scale() const {
        const double x = 1.0 / root();
        const double x2 = x * x;
        const double x4 = x2 * x2;
        return (x4 * x4) * x4 * x2 * x;
    }
    double weight() const { return weight_; }
    const PairWrench& direction() const { return direction_; }  ///< sum w_k J_k
    const PairWrench& of_weights() const { return of_weights_; }
    const PairWrench& rates() const { return rates_; }     ///< sum w_k d_k' J_k
    double rate() const { return rate_; }                  ///< sum w_k d_k'
    double squared_rate() const { return squared_rate_; }  ///< sum w_k d_k'^2
    Vec3 center() const { return position_ / weight_; }
    /// Mean squared distance of the points from their center [m^2].
    double squared_spread() const {
        return std::max(0.0, squared_position_.trace() / weight_ - center().squaredNorm());
    }
    /// The same along a direction, times the square of its length [m^4].
    double squared_spread(const Vec3& along) const {
        return std::max(
            0.0, along.dot(squared_position_ * along) / weight_ - square(center().dot(along)));
    }

  private:
    double root() const { return std::sqrt(std::sqrt(std::sqrt(std::sqrt(power_)))); }

    const PairState& pair_;
    double deepest_;
    double power_ = 0.0;
    double weight_ = 0.0;
    double rate_ = 0.0, squared_rate_ = 0.0;
    PairWrench direction_, of_weights_, rates_;
    Vec3 position_ = Vec3::Zero();
    Mat3 squared_position_ = Mat3::Zero();
    std::uint32_t count_ = 0;
};

/// A point that lies deepest but may jump when bodies are parallel, together with features that
/// carry then: d^p = deepest^p G(S), S the power of the others. G rises from 1 to S, so that the
/// point alone counts where others are few (S < 1/2) and the others alone where they are enough
/// (S > 3/2). The force is that of this potential: G' for the others, G - S G' for the point.
inline void add_blended(const FeaturePoint& point, double weight, const FeatureSum& others,
                        FeatureSum& features) {
    const double x = point.overlap / features.deepest();
    const double own = square(square(square(square(x))));
    const double share = own > 0.0 ? others.power() / own : 2.0;
    const double slope = std::clamp(share - 0.5, 0.0, 1.0);
    const double value = share < 1.5 ? 1.0 + 0.5 * slope * slope : share;
    if (point.overlap > 0.0) features.add(point, weight * (value - share * slope));
    if (slope > 0.0) features.add(others, weight * slope);
}

/// A point that lies deepest beside features that are to carry: d^p = deepest^p (1 + S^2)/2 as long
/// as their power S is below one, after that the features alone. It keeps bodies apart where no
/// feature is listed.
inline void add_remaining(const FeaturePoint& point, const FeatureSum& others,
                          FeatureSum& features) {
    const double x = point.overlap / features.deepest();
    const double own = square(square(square(square(x))));
    const double share = std::min(1.0, others.power() / own);
    if (share < 1.0) features.add(point, 0.5 * (1.0 - share * share));
    features.add(others, share);
}

/// The one feature of two polyhedra that touches, while the leash lasts (lone_features.hpp).
struct LoneFeature {
    enum class Kind : std::uint32_t { none, vertex_of_i, vertex_of_j, edges };
    Kind kind = Kind::none;
    std::uint32_t of_i = 0, of_j = 0;  ///< numbers of a vertex, a face or an edge
    std::uint32_t wait = 0;            ///< steps until it is looked for again
};

/// What of a flat end of a cylinder or a cone can touch the other body while the leash lasts
/// (round_features.hpp).
struct NearEnd {
    std::uint16_t samples = 0;  ///< a bit for each sample of the rim
    std::uint16_t can_touch = 0;
};
using NearEnds = std::array<NearEnd, 2>;

/// History of a pair of which at least one body is of kind `convex`. All zero: no contact.
struct ConvexHistory : ContactHistory, SpringHistory, TorsionHistory {
    double weight = 0.0;   ///< of the features together in the step before
    StoredVec3 place;      ///< where friction acted, relative to the center of i [m]
    double deepest = 0.0;  ///< overlap so far [m]; with `held` for laws without slip only
    double held = 0.0;     ///< longest spring over overlap, while that was no less than half
    SearchStart search;    ///< where the search for the distance starts
    LoneFeature lone;
    NearEnds ends_of_i{}, ends_of_j{};
    Leash leash;                  ///< of what is known of the features
    std::uint64_t cores_met = 0;  ///< whether the cores have overlapped in this contact
};
static_assert(std::is_trivially_copyable_v<ConvexHistory>);

/// Without slip the tangential spring has given back what it held when the overlap is gone.
inline double held_energy(const ConvexHistory& history) {
    const auto& spring = static_cast<const SpringHistory&>(history);
    return (history.held > 0.0 ? 0.0 : held_energy(spring)) +
           held_energy(static_cast<const TorsionHistory&>(history)) + held_energy(history.rolling);
}

/// Force of the features of a pair: normal forces from the potential and one dashpot per point,
/// one tangential and one torsion spring for the pair (docs/contact-convex.md, "Friction").
/// `local_radius`: R* at this place [m]. Not for an empty sum.
PairContact contact_force(const FeatureSum& features, double local_radius, const ContactLaw& law,
                          double dt, ConvexHistory& history);

}  // namespace dem::runtime
