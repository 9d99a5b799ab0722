// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/particle_template.hpp"

namespace dem {

namespace {
struct KindName {
    std::string operator()(const Sphere&) const { return "sphere"; }
    std::string operator()(const SrShape&) const { return "sr"; }
    std::string operator()(const Clump&) const { return "clump"; }
    std::string operator()(const ConvexShape&) const { return "convex"; }
};
}  // namespace

std::string kind_name(const ParticleTemplate& shape) {
    return std::visit(KindName{}, shape.shape);
}

}  // namespace dem
