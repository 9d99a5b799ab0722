// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/insertion/lattice.hpp"

#include "common/error.hpp"
#include "runtime/insertion/body_draw.hpp"
#include "runtime/insertion/region_frame.hpp"

#include <sstream>

namespace dem {

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

[[noreturn]] void fail_too_small(const InsertionGroup& group, std::size_t placed, const Vec3& cells,
                                 const Vec3& cell) {
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
    const Vec3 cell = spacing_factor * (reach.below + reach.above);
    // A region of exactly n diameters holds n: the spacing's excess is not the user's.
    const Vec3 cells = (frame.size().cwiseQuotient(cell).array() + 1e-5).floor();
    // The cells move apart to make room for the shifts, as far as the region lets them.
    const Vec3 pitch = cell.cwiseMax(
        Vec3((1.0 + group.jitter) * cell).cwiseMin(frame.size().cwiseQuotient(cells)));
    std::vector<BodyPlacement> placed;
    for (double k = 0.0; k < cells.z(); ++k) {
        for (double j = 0.0; j < cells.y(); ++j) {
            for (double i = 0.0; i < cells.x(); ++i) {
                if (placed.size() == group.count) return placed;
                BodyDraw draw(scene, group_index, placed.size());
                BodyPlacement body = draw.body();
                const Vec3 corner = Vec3(i, j, k).cwiseProduct(pitch) + reach.below;
                Random& random = draw.random();
                const Vec3 shift{random.uniform(), random.uniform(), random.uniform()};
                const ParticleTemplate& shape = scene.shapes[scene.kinds[body.kind].shape];
                const auto fits_at = [&](const Vec3& place) {
                    body.position = frame.at(place);
                    return frame.is_within_side(shape, body) && occupancy.is_free(body);
                };
                // A shift may lead out of a round side; the middle of the room comes next.
                if (fits_at(corner + shift.cwiseProduct(pitch - cell)) ||
                    fits_at(corner + 0.5 * (pitch - cell))) {
                    placed.push_back(body);
                }
            }
        }
    }
    if (placed.size() < group.count) fail_too_small(group, placed.size(), cells, cell);
    return placed;
}

}  // namespace dem
