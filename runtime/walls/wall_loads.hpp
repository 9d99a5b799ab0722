// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/narrow_phase/seen_contacts.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem::runtime {

/// What contacts have done to the triangles of mesh walls since time 0: one entry per triangle, of
/// one wall after the other. A contact is booked as a whole on the triangle nearest to its place.
class WallLoads {
  public:
    /// Of all mesh walls of the scene if OutputSettings::wall_contacts asks for it, else empty.
    explicit WallLoads(const Scene& scene);

    bool is_empty() const { return normal_.empty(); }
    std::size_t size() const { return normal_.size(); }

    /// Books the contacts with walls of a step of `dt` [s], in their order.
    void add(std::span<const SeenContact> contacts, const Bodies& bodies, double dt);

    /// Integral of the normal force over time [N s].
    const std::vector<double>& normal() const { return normal_; }
    /// Of the size of the friction [N s].
    const std::vector<double>& shear() const { return shear_; }
    /// Work against friction [J].
    const std::vector<double>& friction_work() const { return friction_work_; }
    /// Integral of the normal force over the way that surfaces slide on each other [J]: times k/H
    /// it is the volume worn off after Archard (1953), H hardness, k his coefficient.
    const std::vector<double>& sliding_work() const { return sliding_work_; }
    /// Sum over the impacts of m v^2 f(a) [J], v speed at the place, a angle to the surface,
    ///     f = sin 2a - 3 sin^2 a for tan a <= 1/3, cos^2 a / 3 above:
    /// in proportion to the volume worn off after Finnie (1960).
    const std::vector<double>& impact_energy() const { return impact_energy_; }

    template <class Self, class Visit>
    static void visit_state(Self& self, Visit& visit) {
        visit("wall_loads.normal", self.normal_);
        visit("wall_loads.shear", self.shear_);
        visit("wall_loads.friction_work", self.friction_work_);
        visit("wall_loads.sliding_work", self.sliding_work_);
        visit("wall_loads.impact_energy", self.impact_energy_);
    }
    /// Whether what a checkpoint brought belongs to this scene.
    bool fits() const;

  private:
    std::vector<std::uint32_t> first_;  ///< by wall: its first triangle, or none
    std::uint32_t count_ = 0;           ///< triangles of all
    std::vector<double> normal_, shear_, friction_work_, sliding_work_, impact_energy_;
};

}  // namespace dem::runtime
