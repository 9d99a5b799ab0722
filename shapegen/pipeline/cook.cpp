// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/pipeline/cook.hpp"

#include "common/error.hpp"
#include "shapegen/certificate/sr_certificate.hpp"
#include "shapegen/revolution/convexity.hpp"
#include "shapegen/revolution/curvature.hpp"
#include "shapegen/revolution/display_mesh.hpp"
#include "shapegen/revolution/mass_properties.hpp"
#include "shapegen/revolution/node_rings.hpp"
#include "shapegen/revolution/profile_samples.hpp"
#include "shapegen/revolution/support.hpp"
#include "shapegen/revolution/surface_nodes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

namespace dem::shapegen {

namespace {

constexpr double mesh_tolerance = 1e-3;    // of the display mesh, in l
constexpr double sphere_tolerance = 1e-6;  // largest deviation of a sphere, in its radius

/// H of a ring of nodes. On a sharp edge it has no value: there the largest one that is stored.
class NodeCurvature {
  public:
    NodeCurvature(const Profile& profile, double equivalent_diameter)
        : profile_(profile), equivalent_diameter_(equivalent_diameter) {
        for (const Profile::Corner& corner : profile.corners()) edges_.push_back(corner.segment);
    }

    double operator()(const Ring& ring) const {
        const bool on_edge =
            ring.t == 1.0 && std::find(edges_.begin(), edges_.end(), ring.segment) != edges_.end();
        return stored_mean_curvature(on_edge ? std::numeric_limits<double>::infinity()
                                             : mean_curvature(profile_, ring.segment, ring.t),
                                     equivalent_diameter_);
    }

  private:
    const Profile& profile_;
    double equivalent_diameter_;
    std::vector<std::size_t> edges_;
};

ParticleTemplate common_part(const Profile& profile, const RevolutionMass& mass,
                             const std::string& name) {
    ParticleTemplate shape;
    shape.name = name;
    shape.mass_properties = mass.mass_properties;
    shape.mean_squared_surface_distance = mass.mean_squared_surface_distance;
    shape.bounding_radius = farthest_distance(profile);
    shape.is_convex = convexity(profile).is_convex;
    shape.display_mesh = display_mesh(profile, mesh_tolerance * profile.major_axis_length());
    return shape;
}

ParticleTemplate cook_sr(const Profile& profile, ParticleTemplate shape,
                         const CookOptions& options) {
    SrShape sr;
    sr.is_convex = shape.is_convex;
    sr.bottom_z = profile.bottom_z();
    sr.top_z = profile.top_z();
    sr.max_radius = profile.max_radius();
    sr.bounding_radius = shape.bounding_radius;
    sr.equivalent_diameter = equivalent_diameter(shape.mass_properties.volume);
    sr.major_axis_length = profile.major_axis_length();
    if (sr.is_convex) sr.support = support_map(profile);

    // A sphere touches a shape that is not convex where the field says that its center is near
    // enough (runtime/contact/pairs/sphere_sr_nodes.hpp): spheres of up to this radius.
    const double reach = sr.is_convex ? 0.0 : 0.2 * sr.major_axis_length;
    sr.sdf = signed_distance_field(profile, options.resolution, reach);
    const double interface_size = sr.major_axis_length / options.resolution.interface;
    const SdfError sdf = sdf_error(profile, sr.sdf, interface_size);
    // Twice what was found: the samples may have missed the worst point.
    sr.sdf.lipschitz_slack = 2.0 * sdf.max_outside;
    sr.sdf.surface_slack = 2.0 * sdf.max_near_surface;
    sr.sdf.surface_band = interface_size;

    const CurvatureTable curvature = curvature_table(profile, sr.equivalent_diameter);
    sr.curvature = curvature.samples;
    const std::vector<Ring> rings = node_rings(profile, options.nodes);
    sr.nodes = surface_nodes(rings, NodeCurvature(profile, sr.equivalent_diameter));

    shape.certificate = sr_certificate(profile, shape, sr, {sdf, curvature.largest_error, rings});
    shape.shape = std::move(sr);
    return shape;
}

ParticleTemplate cook_sphere(const Profile& profile, ParticleTemplate shape) {
    const double radius = 0.5 * equivalent_diameter(shape.mass_properties.volume);
    double deviation = 0.0;
    for (const ProfileSample& s : sample_profile(profile, radius / 200.0)) {
        deviation = std::max(deviation, std::abs(s.point.norm() - radius));
    }
    if (deviation > sphere_tolerance * radius) {
        std::array<char, 100> text{};
        std::snprintf(text.data(), text.size(),
                      "found a body that differs from a sphere by %.2g %% of its radius, ",
                      100.0 * deviation / radius);
        throw Error(shape.name, text.data() + std::string("expected a sphere for --sphere"));
    }
    shape.bounding_radius = radius;
    shape.certificate = {
        {"radius_error_max", deviation / radius},
        {"display_mesh_error_max", shape.display_mesh.max_deviation / profile.major_axis_length()}};
    shape.shape = Sphere{radius};
    return shape;
}

}  // namespace

ParticleTemplate cook(const Profile& input, const std::string& name, const CookOptions& options) {
    const RevolutionMass mass = revolution_mass(input);
    const Profile profile = input.translated(-mass.mass_properties.center_of_mass.z());
    ParticleTemplate shape = common_part(profile, mass, name);
    return options.kind == CookOptions::Kind::sphere ? cook_sphere(profile, std::move(shape))
                                                     : cook_sr(profile, std::move(shape), options);
}

}  // namespace dem::shapegen
