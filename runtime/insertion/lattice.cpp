// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/lattice.hpp"

#include "common/error.hpp"
#include "runtime/insertion/body_draw.hpp"
#include "runtime/insertion/region_frame.hpp"

#include <sstream>

namespace dem::runtime {

namespace {

/// Neighbors at exactly one diameter would overlap by rounding.
constexpr double spacing_factor = 1.0 + 1e-6;

RegionFrame::Reach largest_reach(const Scene& scene, const InsertionGroup& group,
                                 const RegionFrame& frame) {
    RegionFrame::Reach largest{Vec3::Zero(), Vec3::Zero()};
    for (const std::uint32_t kind : group.kinds) {
        const ParticleTemplate& shape = scene.shapes[scene.kinds[kind].shape];
        RegionFrame::Reach r{Vec3::Constant(shape.bounding_radius),
                             Vec3::Constant(shape.bounding_radius)};
        if (group.orientation) r = frame.reach(shape, *group.orientation);
        largest.below = largest.below.cwiseMax(r.below);
        largest.above = largest.above.cwiseMax(r.above);
    }
    return largest;
}

/// Rows of boxes that hold the largest body of a group however it is turned.
struct Lattice {
    const RegionFrame& frame;
    Vec3 below;  ///< from the lower corner of a cell to the place of its body [m]
    Vec3 cell;   ///< edges of what a body needs [m]
    Vec3 pitch;  ///< from cell to cell, with room for shifts [m]

    Lattice(const RegionFrame& region, const RegionFrame::Reach& reach, double jitter)
        : frame(region),
          below(reach.below),
          cell(spacing_factor * (reach.below + reach.above)),
          pitch((1.0 + jitter) * cell) {}

    /// A region of exactly n diameters holds n: the spacing's excess is not the user's.
    Vec3 cells() const { return (frame.size().cwiseQuotient(pitch).array() + 1e-5).floor(); }
};

std::vector<BodyPlacement> placements_on(const Lattice& lattice, const Scene& scene,
                                         std::uint32_t group_index, const Occupancy& occupancy) {
    const std::uint64_t count = scene.insertions[group_index].count;
    const Vec3 room = lattice.pitch - lattice.cell;
    const Vec3 cells = lattice.cells();
    std::vector<BodyPlacement> placed;
    for (double k = 0.0; k < cells.z(); ++k) {
        for (double j = 0.0; j < cells.y(); ++j) {
            for (double i = 0.0; i < cells.x(); ++i) {
                if (placed.size() == count) return placed;
                BodyDraw draw(scene, group_index, placed.size());
                BodyPlacement body = draw.body();
                const Vec3 corner = Vec3(i, j, k).cwiseProduct(lattice.pitch) + lattice.below;
                Random& random = draw.random();
                const Vec3 shift{random.uniform(), random.uniform(), random.uniform()};
                const ParticleTemplate& shape = scene.shapes[scene.kinds[body.kind].shape];
                const auto fits_at = [&](const Vec3& place) {
                    body.position = lattice.frame.at(place);
                    return lattice.frame.is_within_side(shape, body) && occupancy.is_free(body);
                };
                // A shift may lead out of a round side; the middle of the room comes next.
                if (fits_at(corner + shift.cwiseProduct(room)) || fits_at(corner + 0.5 * room)) {
                    placed.push_back(body);
                }
            }
        }
    }
    return placed;
}

[[noreturn]] void fail_too_small(const InsertionGroup& group, std::size_t placed,
                                 const Lattice& lattice) {
    const Vec3 cells = lattice.cells();
    const Vec3 cell = lattice.cell;
    std::ostringstream message;
    message << "the region of [particles." << group.name << "] holds " << placed << " of "
            << group.count << " bodies on a lattice of " << cells.x() << " x " << cells.y() << " x "
            << cells.z() << " cells of " << cell.x() * 1e3 << " x " << cell.y() * 1e3 << " x "
            << cell.z() * 1e3 << " mm, expected a larger region"
            << (group.jitter > 0.0 ? ", jitter = 0" : "") << " or a smaller count";
    throw Error(group.where, message.str());
}

}  // namespace

std::vector<BodyPlacement> lattice_placements(const Scene& scene, std::uint32_t group_index,
                                              const Occupancy& occupancy) {
    const InsertionGroup& group = scene.insertions[group_index];
    const RegionFrame frame(group.region);
    const RegionFrame::Reach reach = largest_reach(scene, group, frame);
    const Lattice wide(frame, reach, group.jitter);
    std::vector<BodyPlacement> placed = placements_on(wide, scene, group_index, occupancy);
    if (placed.size() == group.count) return placed;
    // As many rows as the region holds, moved apart as far as it lets them: not at all in one of
    // exactly n diameters.
    Lattice close(frame, reach, 0.0);
    close.pitch =
        close.cell.cwiseMax(wide.pitch.cwiseMin(frame.size().cwiseQuotient(close.cells())));
    placed = placements_on(close, scene, group_index, occupancy);
    if (placed.size() < group.count) fail_too_small(group, placed.size(), close);
    return placed;
}

}  // namespace dem::runtime
