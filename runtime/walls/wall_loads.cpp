// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The triangle nearest to a point of the mesh's frame, the first of equally near ones. `guess`: a
/// distance within which there is probably one [m], > 0.
std::uint32_t nearest_triangle(const WallMesh& mesh, const Vec3& x, double guess) {
    for (double reach = guess;; reach *= 2.0) {
        std::uint32_t best = none;
        double nearest = square(reach);
        visit_near_triangles(mesh, x, reach, [&](std::uint32_t t) {
            const TrianglePoint at =
                nearest_on_triangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), x);
            const double distance = (at.point - x).squaredNorm();
            if (distance > nearest || (distance == nearest && best != none)) return;
            nearest = distance;
            best = t;
        });
        if (best != none) return best;
    }
}

/// After Finnie (1960), of an impact at velocity u, `normal` of the wall towards the body.
double finnie_share(const Vec3& u, const Vec3& normal) {
    const double speed = u.norm();
    if (!(speed > 0.0)) return 0.0;
    const double sine = std::min(-u.dot(normal) / speed, 1.0);
    if (!(sine > 0.0)) return 0.0;
    const double cosine = std::sqrt(1.0 - square(sine));
    return 3.0 * sine <= cosine ? 2.0 * sine * cosine - 3.0 * square(sine) : square(cosine) / 3.0;
}

double mass_of(const Bodies& bodies, std::uint32_t id) {
    const auto& ids = bodies.particles.id;
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return bodies.kind(static_cast<std::uint32_t>(at - ids.begin())).mass;
}

}  // namespace

WallLoads::WallLoads(const Scene& scene) {
    first_.assign(scene.walls.size(), none);
    if (!scene.output.wall_contacts) return;
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const auto* wall = std::get_if<MeshWall>(&scene.walls[w].shape);
        if (wall == nullptr) continue;
        first_[w] = count_;
        count_ += static_cast<std::uint32_t>(wall->mesh->triangles.size());
    }
    for (auto* loads : {&normal_, &shear_, &friction_work_, &sliding_work_, &impact_energy_})
        loads->assign(count_, 0.0);
}

bool WallLoads::fits() const {
    return std::ranges::all_of(
        std::array{&normal_, &shear_, &friction_work_, &sliding_work_, &impact_energy_},
        [this](const std::vector<double>* loads) { return loads->size() == count_; });
}

void WallLoads::add(std::span<const SeenContact> contacts, const Bodies& bodies, double dt) {
    for (const SeenContact& contact : contacts) {
        if (contact.is_wall == 0 || first_[contact.j] == none) continue;
        const WallMesh& mesh = *std::get<MeshWall>(bodies.scene.walls[contact.j].shape).mesh;
        const WallState& state = bodies.walls.state[contact.j];
        const Vec3 x =
            state.body.orientation.conjugate() * Vec3(Vec3(contact.point) - state.position);
        const std::uint32_t t = first_[contact.j] + nearest_triangle(mesh, x, contact.overlap);
        const Vec3 normal = contact.normal;
        const Vec3 friction = contact.friction;
        const Vec3 u = contact.velocity;
        const double force = std::max(contact.normal_force, 0.0);
        normal_[t] += contact.normal_force * dt;
        shear_[t] += friction.norm() * dt;
        friction_work_[t] -= friction.dot(u) * dt;
        sliding_work_[t] += force * Vec3(u - u.dot(normal) * normal).norm() * dt;
        if (contact.begins != 0)
            impact_energy_[t] +=
                mass_of(bodies, contact.i) * u.squaredNorm() * finnie_share(u, normal);
    }
}

}  // namespace dem::runtime
