// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

/// Numbers computed several at a time. Code that is to run in lanes is written once, as a template
/// of `Real`: double, or a vector of doubles one for each lane, of the compiler's own kind. + - * /
/// and sqrt are rounded correctly in every width, so that a lane of such code has the bits of the
/// same code for double. Where double would branch, lanes compute both ways and select; any()
/// spares a way that no lane takes.
namespace dem {

template <int width>
struct LanesOf;
template <>
struct LanesOf<1> {
    using Real = double;
};
template <>
struct LanesOf<2> {
    typedef double Real __attribute__((vector_size(16)));  // NOLINT(modernize-use-using)
};
template <>
struct LanesOf<4> {
    typedef double Real __attribute__((vector_size(32)));  // NOLINT(modernize-use-using)
};
template <>
struct LanesOf<8> {
    typedef double Real __attribute__((vector_size(64)));  // NOLINT(modernize-use-using)
};
/// That many doubles.
template <int width>
using Lanes = typename LanesOf<width>::Real;

template <class Real>
inline constexpr int width_of = sizeof(Real) / sizeof(double);
template <class Real>
concept OneLane = std::is_same_v<Real, double>;
template <class Real>
concept ManyLanes = std::is_same_v<Real, Lanes<2>> || std::is_same_v<Real, Lanes<4>> ||
    std::is_same_v<Real, Lanes<8>>;

/// What a comparison of two Real gives: bool, or all bits of a lane set or clear.
template <class Real>
using MaskOf = decltype(Real{} > Real{});

inline bool any(bool m) {
    return m;
}
inline bool all(bool m) {
    return m;
}
inline bool no(bool m) {
    return !m;
}
template <class Mask>
requires(!std::is_same_v<Mask, bool>) inline bool any(const Mask& m) {
    std::int64_t bits = 0;
    for (int k = 0; k < width_of<Mask>; ++k) bits |= m[k];
    return bits != 0;
}
template <class Mask>
requires(!std::is_same_v<Mask, bool>) inline bool all(const Mask& m) {
    std::int64_t bits = -1;
    for (int k = 0; k < width_of<Mask>; ++k) bits &= m[k];
    return bits != 0;
}
/// The opposite of a mask, lane by lane.
template <class Mask>
requires(!std::is_same_v<Mask, bool>) inline Mask no(const Mask& m) {
    return ~m;
}

/// Both, either of two masks.
inline bool both(bool a, bool b) {
    return a && b;
}
inline bool either(bool a, bool b) {
    return a || b;
}
template <class Mask>
requires(!std::is_same_v<Mask, bool>) inline Mask both(const Mask& a, const Mask& b) {
    return a & b;
}
template <class Mask>
requires(!std::is_same_v<Mask, bool>) inline Mask either(const Mask& a, const Mask& b) {
    return a | b;
}

/// One number in all lanes.
template <class Real>
inline Real in_all(double x) {
    return x - Real{};
}
template <>
inline double in_all<double>(double x) {
    return x;
}

inline double select(bool m, double yes, double otherwise) {
    return m ? yes : otherwise;
}
template <ManyLanes Real>
inline Real select(const MaskOf<Real>& m, const Real& yes, const Real& otherwise) {
    return m ? yes : otherwise;
}

inline double root(double x) {
    return std::sqrt(x);
}
template <ManyLanes Real>
inline Real root(const Real& x) {
    Real r;
    for (int k = 0; k < width_of<Real>; ++k) r[k] = __builtin_sqrt(x[k]);
    return r;
}

/// std::abs, std::min, std::max and std::clamp of each lane.
inline double absolute(double x) {
    return std::abs(x);
}
template <ManyLanes Real>
inline Real absolute(const Real& x) {
    Real r;
    for (int k = 0; k < width_of<Real>; ++k) r[k] = __builtin_fabs(x[k]);
    return r;
}
template <class Real>
inline Real smaller(const Real& a, const Real& b) {
    return select(b < a, b, a);
}
template <class Real>
inline Real larger(const Real& a, const Real& b) {
    return select(a < b, b, a);
}
template <class Real>
inline Real clamped(const Real& x, const Real& low, const Real& high) {
    return select(x < low, low, select(high < x, high, x));
}

/// A vector in each lane, with the members of Vec3 and its order of operations.
template <class Real>
struct LaneVec3 {
    Real x_, y_, z_;

    // NOLINTBEGIN(*-naming): as in Vec3
    static LaneVec3 Zero() { return {Real{}, Real{}, Real{}}; }
    static LaneVec3 UnitX() { return {in_all<Real>(1.0), Real{}, Real{}}; }
    static LaneVec3 UnitY() { return {Real{}, in_all<Real>(1.0), Real{}}; }
    static LaneVec3 UnitZ() { return {Real{}, Real{}, in_all<Real>(1.0)}; }
    Real squaredNorm() const { return dot(*this); }
    // NOLINTEND(*-naming)
    const Real& x() const { return x_; }
    const Real& y() const { return y_; }
    const Real& z() const { return z_; }
    Real dot(const LaneVec3& b) const { return (x_ * b.x_ + y_ * b.y_) + z_ * b.z_; }
    Real norm() const { return root(squaredNorm()); }
    LaneVec3 cross(const LaneVec3& b) const {
        return {y_ * b.z_ - z_ * b.y_, z_ * b.x_ - x_ * b.z_, x_ * b.y_ - y_ * b.x_};
    }
    LaneVec3 operator-() const { return {-x_, -y_, -z_}; }
    LaneVec3& operator+=(const LaneVec3& b) { return *this = *this + b; }
    LaneVec3& operator-=(const LaneVec3& b) { return *this = *this - b; }
    friend LaneVec3 operator+(const LaneVec3& a, const LaneVec3& b) {
        return {a.x_ + b.x_, a.y_ + b.y_, a.z_ + b.z_};
    }
    friend LaneVec3 operator-(const LaneVec3& a, const LaneVec3& b) {
        return {a.x_ - b.x_, a.y_ - b.y_, a.z_ - b.z_};
    }
    friend LaneVec3 operator*(const Real& s, const LaneVec3& a) {
        return {s * a.x_, s * a.y_, s * a.z_};
    }
    friend LaneVec3 operator*(const LaneVec3& a, const Real& s) { return s * a; }
    friend LaneVec3 operator*(double s, const LaneVec3& a) {
        return {s * a.x_, s * a.y_, s * a.z_};
    }
    friend LaneVec3 operator*(const LaneVec3& a, double s) { return s * a; }
    friend LaneVec3 operator/(const LaneVec3& a, const Real& s) {
        return {a.x_ / s, a.y_ / s, a.z_ / s};
    }
};

template <class Real>
struct Vec3OfReal {
    using Type = LaneVec3<Real>;
};
template <>
struct Vec3OfReal<double> {
    using Type = Vec3;
};
/// A vector in each lane: Vec3 for double.
template <class Real>
using Vec3Of = typename Vec3OfReal<Real>::Type;

inline Vec3 select(bool m, const Vec3& yes, const Vec3& otherwise) {
    return m ? yes : otherwise;
}
template <class Mask, class Real>
inline LaneVec3<Real> select(const Mask& m, const LaneVec3<Real>& yes,
                             const LaneVec3<Real>& otherwise) {
    return {select(m, yes.x_, otherwise.x_), select(m, yes.y_, otherwise.y_),
            select(m, yes.z_, otherwise.z_)};
}

/// An orientation in each lane, with the members of Quat.
template <class Real>
struct LaneQuat {
    Real w_, x_, y_, z_;

    const Real& w() const { return w_; }
    const Real& x() const { return x_; }
    const Real& y() const { return y_; }
    const Real& z() const { return z_; }
    // NOLINTNEXTLINE(*-naming): as in Quat
    Real squaredNorm() const { return (x_ * x_ + z_ * z_) + (y_ * y_ + w_ * w_); }
    /// First b, then a.
    friend LaneQuat operator*(const LaneQuat& a, const LaneQuat& b) {
        return {(a.w_ * b.w_ - a.y_ * b.y_) - (a.z_ * b.z_ + a.x_ * b.x_),
                (a.w_ * b.x_ + a.y_ * b.z_) - (a.z_ * b.y_ - a.x_ * b.w_),
                (a.w_ * b.y_ + a.y_ * b.w_) + (a.z_ * b.x_ - a.x_ * b.z_),
                (a.w_ * b.z_ - a.y_ * b.x_) + (a.z_ * b.w_ + a.x_ * b.y_)};
    }
};

/// body_axis() in each lane.
template <class Real>
LaneVec3<Real> body_axis(const LaneQuat<Real>& q) {
    return {2.0 * (q.x_ * q.z_ + q.w_ * q.y_), 2.0 * (q.y_ * q.z_ - q.w_ * q.x_),
            1.0 - 2.0 * (q.x_ * q.x_ + q.y_ * q.y_)};
}

template <class Real>
struct QuatOfReal {
    using Type = LaneQuat<Real>;
};
template <>
struct QuatOfReal<double> {
    using Type = Quat;
};
/// An orientation in each lane: Quat for double.
template <class Real>
using QuatOf = typename QuatOfReal<Real>::Type;

template <class Mask, class Real>
inline LaneQuat<Real> select(const Mask& m, const LaneQuat<Real>& yes,
                             const LaneQuat<Real>& otherwise) {
    return {select(m, yes.w_, otherwise.w_), select(m, yes.x_, otherwise.x_),
            select(m, yes.y_, otherwise.y_), select(m, yes.z_, otherwise.z_)};
}
inline Quat select(bool m, const Quat& yes, const Quat& otherwise) {
    return m ? yes : otherwise;
}

template <ManyLanes Real>
inline Real square(const Real& x) {
    return x * x;
}

}  // namespace dem
