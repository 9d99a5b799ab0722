// SPDX-License-Identifier: BSD-3-Clause
// Convex files, and profiles taken as convex shapes.
#include "shapegen/convex/convex_file.hpp"
#include "tests/fuzz/promise.hpp"

#include <array>

namespace dem::fuzz {

using namespace shapegen;

namespace {

void look_at(const ConvexFile& file) {
    const ConvexShape& shape = file.solid.shape;
    const MassProperties& mass = file.solid.mass_properties;
    promise_positive(file.unit, "the unit of a convex shape");
    promise_positive(mass.volume, "the volume of a convex shape");
    promise_finite(mass.center_of_mass, "the center of mass of a convex shape");
    for (int i = 0; i < 3; ++i)
        promise_positive(mass.principal_moments_per_density[i], "a principal moment");
    promise(std::abs(mass.principal_axes.norm() - 1.0) < 1e-9, "principal axes are a rotation");
    promise_positive(file.solid.mean_squared_surface_distance, "the mean squared distance");
    promise_positive(file.solid.surface_area, "the surface area");
    promise_finite(file.solid.rounding_loss, "the loss by rounding");
    promise_finite(file.solid.corner_retreat, "the retreat of corners");
    promise_positive(shape.bounding_radius, "the bounding radius of a convex shape");
    const double slack = 1.0 + 1e-9;
    for (const Vec3& n : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.0, -0.8)}) {
        promise(extent(shape, n) <= slack * shape.bounding_radius,
                "a convex shape reaches no farther than its bounding radius");
        promise(surface_distance(shape, 2.0 * shape.bounding_radius * n).distance > 0.0,
                "what is beyond the bounding radius is outside");
    }
    promise(surface_distance(shape, Vec3::Zero()).distance < 0.0, "the center of mass is inside");
}

}  // namespace
}  // namespace dem::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size) {
    using namespace dem;
    using namespace dem::shapegen;
    static const std::array<std::string, 1> places = {"x.convex:"};
    const std::string_view text = fuzz::as_text({data, size});
    fuzz::accepts(places, [&] { fuzz::look_at(parse_convex(text, "x.convex")); });
    fuzz::accepts(places, [&] { fuzz::look_at(parse_convex_profile(text, "x.convex")); });
    return 0;
}
