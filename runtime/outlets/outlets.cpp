// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/outlets/outlets.hpp"

#include "common/math/elementary.hpp"
#include "common/threads/thread_team.hpp"
#include "runtime/loop_grain.hpp"

#include <atomic>

namespace dem::runtime {

namespace {

bool is_fixed(const Scene& scene, const Particles& particles, std::uint32_t i) {
    return scene.kinds[particles.kind[i]].inverse_inertia.mass == 0.0;
}

/// Whether a point is before or behind the part of a plane that is looked at.
bool is_at_disc(const Outlet& outlet, const Vec3& x) {
    const auto& plane = std::get<HalfSpace>(outlet.place);
    const Vec3 off = x - plane.point;
    const Vec3 across = off - off.dot(plane.normal) * plane.normal;
    return across.squaredNorm() <= square(outlet.radius);
}

}  // namespace

std::vector<std::string> outlet_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Outlet& outlet : scene.outlets) names.push_back(outlet.name);
    if (scene.run.domain_exit == DomainExit::remove) names.emplace_back("domain");
    return names;
}

std::vector<std::string> outlet_columns(const Scene& scene) {
    const std::vector<std::string> names = outlet_names(scene);
    std::vector<std::string> columns;
    if (!names.empty()) columns.emplace_back("removed");
    for (const std::string& name : names) {
        for (const char* quantity : {"_bodies", "_mass", "_body_rate", "_mass_rate"})
            columns.push_back(name + quantity);
        if (scene.insertions.size() < 2) continue;
        for (const InsertionGroup& group : scene.insertions) {
            columns.push_back(name + "_" + group.name + "_bodies");
            columns.push_back(name + "_" + group.name + "_mass");
        }
    }
    return columns;
}

Outlets::Outlets(const Scene& scene, const Aabb& domain)
    : domain_(domain),
      domain_removes_(scene.run.domain_exit == DomainExit::remove),
      groups_(scene.insertions.size()),
      names_(outlet_names(scene)) {
    outflow_.resize(names_.size() * groups_);
}

Outflow Outlets::total(std::size_t outlet) const {
    Outflow sum;
    for (const Outflow& part : outflow(outlet)) {
        sum.bodies += part.bodies;
        sum.mass += part.mass;
    }
    return sum;
}

std::uint32_t Outlets::outlet_of(const Scene& scene, const Particles& particles,
                                 std::uint32_t i) const {
    const Vec3& x = particles.position[i];
    const auto count = static_cast<std::uint32_t>(scene.outlets.size());
    for (std::uint32_t o = 0; o < count; ++o) {
        if (scene.outlets[o].kind == Outlet::Kind::remove && holds(scene.outlets[o], x)) return o;
    }
    return domain_removes_ && !domain_.contains(x) ? count : none;
}

bool Outlets::is_behind(const Scene& scene, std::size_t outlet, const Vec3& x) const {
    const Outlet& o = scene.outlets[outlet];
    return o.kind == Outlet::Kind::flow && holds(o, x);
}

void Outlets::count(std::size_t outlet, const Scene& scene, const Particles& particles,
                    std::uint32_t i, int sign) {
    Outflow& out = outflow_[outlet * groups_ + particles.group[i]];
    out.bodies += sign;
    out.mass += sign * scene.kinds[particles.kind[i]].mass;
}

bool Outlets::look(const Scene& scene, const Particles& particles) {
    const std::uint32_t bodies = particles.size();
    const std::size_t planes = scene.outlets.size();
    leaving_.resize(bodies);
    std::atomic<bool> has_any = false;
    share_loop(bodies, bodies_at_a_time, [&](const LoopPart& part) {
        bool has_here = false;
        for (std::size_t k = part.begin; k < part.end; ++k) {
            const auto i = static_cast<std::uint32_t>(k);
            leaving_[i] = 0;
            if (is_fixed(scene, particles, i)) continue;
            if (outlet_of(scene, particles, i) != none) leaving_[i] = 1;
            bool has_passed = false;
            for (std::size_t o = 0; o < planes; ++o) {
                const bool was = behind_[i * planes + o] != 0;
                has_passed |= was != is_behind(scene, o, particles.position[i]);
            }
            has_here |= leaving_[i] != 0 || has_passed;
        }
        if (has_here) has_any = true;
    });
    if (!has_any) return false;
    // Few: in the order of ids, so that sums of masses are the same for any number of threads.
    bool is_any_leaving = false;
    for (std::uint32_t i = 0; i < bodies; ++i) {
        if (is_fixed(scene, particles, i)) continue;
        for (std::size_t o = 0; o < planes; ++o) {
            std::uint8_t& behind = behind_[i * planes + o];
            const bool is = is_behind(scene, o, particles.position[i]);
            if ((behind != 0) == is) continue;
            behind = is ? 1 : 0;
            if (is_at_disc(scene.outlets[o], particles.position[i]))
                count(o, scene, particles, i, is ? -1 : 1);
        }
        if (leaving_[i] == 0) continue;
        is_any_leaving = true;
        count(outlet_of(scene, particles, i), scene, particles, i, 1);
    }
    return is_any_leaving;
}

void Outlets::settle(const Scene& scene, const Particles& particles) {
    const std::size_t planes = scene.outlets.size();
    behind_.resize(particles.size() * planes);
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        for (std::size_t o = 0; o < planes; ++o)
            behind_[i * planes + o] = is_behind(scene, o, particles.position[i]) ? 1 : 0;
    }
}

}  // namespace dem::runtime
