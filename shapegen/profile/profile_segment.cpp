// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_segment.hpp"

#include "common/math/elementary.hpp"
#include "common/math/quadrature.hpp"

#include <utility>

namespace dem::shapegen {
namespace {

class ReversedCurve final : public ParametricCurve {
  public:
    explicit ReversedCurve(std::shared_ptr<const ParametricCurve> curve)
        : curve_(std::move(curve)) {}
    CurveJet evaluate(double t) const override {
        CurveJet jet = curve_->evaluate(1.0 - t);
        jet.first = -jet.first;
        return jet;
    }

  private:
    std::shared_ptr<const ParametricCurve> curve_;
};

class TranslatedCurve final : public ParametricCurve {
  public:
    TranslatedCurve(std::shared_ptr<const ParametricCurve> curve, const Vec2& offset)
        : curve_(std::move(curve)), offset_(offset) {}
    CurveJet evaluate(double t) const override {
        CurveJet jet = curve_->evaluate(t);
        jet.point += offset_;
        return jet;
    }

  private:
    std::shared_ptr<const ParametricCurve> curve_;
    Vec2 offset_;
};

CurveJet jet_of(const LineSegment& line, double t) {
    const Vec2 along = line.to - line.from;
    // From the nearer end, so that both ends are met to the last bit.
    const Vec2 point = t < 0.5 ? Vec2(line.from + t * along) : Vec2(line.to - (1.0 - t) * along);
    return {point, along, Vec2::Zero()};
}

CurveJet jet_of(const EllipseArc& arc, double t) {
    const double sweep = arc.end - arc.start;
    const double phi = t < 0.5 ? arc.start + t * sweep : arc.end - (1.0 - t) * sweep;
    const double c = math::cos(phi);
    const double s = math::sin(phi);
    const Vec2 spoke(arc.a * c, arc.b * s);
    return {arc.center + spoke, sweep * Vec2(-arc.a * s, arc.b * c), -sweep * sweep * spoke};
}

CurveJet jet_of(const FreeCurve& free, double t) {
    return free.curve->evaluate(t);
}

}  // namespace

CurveJet evaluate(const ProfileSegment& segment, double t) {
    return std::visit([t](const auto& s) { return jet_of(s, t); }, segment);
}

double arc_length(const ProfileSegment& segment, double t0, double t1) {
    if (const auto* line = std::get_if<LineSegment>(&segment))
        return (line->to - line->from).norm() * (t1 - t0);
    if (const auto* arc = std::get_if<EllipseArc>(&segment); arc && arc->a == arc->b)
        return arc->a * std::abs(arc->end - arc->start) * (t1 - t0);
    const auto speed = [&segment](double t) {
        return Integrals<1>(evaluate(segment, t).first.norm());
    };
    return integrate<1>(speed, t0, t1)[0];
}

ProfileSegment reversed(const ProfileSegment& segment) {
    if (const auto* line = std::get_if<LineSegment>(&segment))
        return LineSegment{line->to, line->from};
    if (const auto* arc = std::get_if<EllipseArc>(&segment))
        return EllipseArc{arc->center, arc->a, arc->b, arc->end, arc->start};
    return FreeCurve{std::make_shared<ReversedCurve>(std::get<FreeCurve>(segment).curve)};
}

ProfileSegment translated(const ProfileSegment& segment, const Vec2& offset) {
    if (const auto* line = std::get_if<LineSegment>(&segment))
        return LineSegment{line->from + offset, line->to + offset};
    if (const auto* arc = std::get_if<EllipseArc>(&segment))
        return EllipseArc{arc->center + offset, arc->a, arc->b, arc->start, arc->end};
    return FreeCurve{std::make_shared<TranslatedCurve>(std::get<FreeCurve>(segment).curve, offset)};
}

double signed_curvature(const CurveJet& jet) {
    const double speed = jet.first.norm();
    return (jet.first.x() * jet.second.y() - jet.first.y() * jet.second.x()) / cube(speed);
}

}  // namespace dem::shapegen
