// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/particles.hpp"
#include "runtime/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dem::runtime {

/// What has gone out so far, or through a plane along its normal less what came back.
struct Outflow {
    std::int64_t bodies = 0;
    double mass = 0.0;  ///< [kg]
};

/// Of the outlets of a scene, after them "domain" where its end takes bodies out.
std::vector<std::string> outlet_names(const Scene& scene);

/// Their columns in history.csv; none without outlets.
std::vector<std::string> outlet_columns(const Scene& scene);

/// Watches the outlets of a scene, after them the end of its domain where that takes bodies out
/// (RunSettings::domain_exit). Fixed bodies are left alone.
class Outlets {
  public:
    Outlets(const Scene& scene, const Aabb& domain);

    bool is_empty() const { return names_.empty(); }
    const std::vector<std::string>& names() const { return names_; }  ///< outlet_names()

    /// Of one outlet, by group of bodies (Scene::insertions).
    std::span<const Outflow> outflow(std::size_t outlet) const {
        return {outflow_.data() + outlet * groups_, groups_};
    }
    Outflow total(std::size_t outlet) const;

    /// Counts the bodies that have passed a plane since the last look and marks those that are in a
    /// place that takes them out, by the first outlet that does. Returns whether there are any.
    bool look(const Scene& scene, const Particles& particles);

    /// One entry per body of the last look: whether it is to be taken out.
    std::span<const std::uint8_t> leaving() const { return leaving_; }

    /// The bodies are now these: without those that left, with new ones.
    void settle(const Scene& scene, const Particles& particles);

    /// What has been counted so far, for checkpoints.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit("outlets", self.outflow_);
    }
    /// Whether what a checkpoint brought belongs to this scene.
    bool fits() const { return outflow_.size() == names_.size() * groups_; }

  private:
    static constexpr std::uint32_t none = 0xffffffffU;
    /// The first outlet that takes a body out where it is now, or none.
    std::uint32_t outlet_of(const Scene& scene, const Particles& particles, std::uint32_t i) const;
    /// Whether a point is behind the plane of an outlet that counts; false for others.
    bool is_behind(const Scene& scene, std::size_t outlet, const Vec3& x) const;
    /// Books a body that went out, or passed a plane along its normal (1) or against it (-1).
    void count(std::size_t outlet, const Scene& scene, const Particles& particles, std::uint32_t i,
               int sign);

    Aabb domain_;
    bool domain_removes_;
    std::size_t groups_;
    std::vector<std::string> names_;
    std::vector<Outflow> outflow_;  ///< of all groups of the first outlet, of the second, ...
    std::vector<std::uint8_t> leaving_;
    /// Of every body: whether it is behind the plane of each outlet that counts, side by side.
    std::vector<std::uint8_t> behind_;
};

}  // namespace dem::runtime
