// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/picture/clump_surface.hpp"

#include "common/math/aabb.hpp"
#include "shapegen/clump/ball_tree.hpp"
#include "shapegen/surface/surface_query.hpp"

#include <map>
#include <utility>

namespace dem::shapegen {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct UnitSphere {
    std::vector<Vec3> vertices{Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                               -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
    std::vector<Triangle> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

    /// Splits every triangle into four.
    void divide() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto next = static_cast<std::uint32_t>(vertices.size());
            const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), next);
            if (is_new) vertices.push_back((vertices[a] + vertices[b]).normalized());
            return entry->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
};

/// As fine as the number of triangles of all spheres together allows, but at least 32 each.
UnitSphere unit_sphere(std::size_t spheres, std::size_t most_triangles) {
    UnitSphere sphere;
    sphere.divide();
    for (int level = 1; level < 4; ++level)
        if (4 * sphere.triangles.size() * spheres <= most_triangles) sphere.divide();
    return sphere;
}

/// True when one other sphere holds the whole triangle.
bool is_hidden(const Clump& clump, std::uint32_t own, const std::array<Vec3, 3>& corners) {
    const ClumpLevels levels(clump.spheres.size(), clump.balls.span());
    bool hidden = false;
    const auto holds = [&](const Vec3& center, double radius) {
        for (const Vec3& p : corners)
            if ((p - center).squaredNorm() >= square(radius)) return false;
        return true;
    };
    visit_spheres(
        clump.spheres.span(), levels,
        [&](const Clump::Ball& ball) { return hidden || !holds(ball.center(), ball.radius); },
        [&](std::uint32_t k) {
            const ClumpSphere& s = clump.spheres[k];
            hidden = hidden || (k != own && holds(s.center(), s.radius));
        });
    return hidden;
}

TriangleMesh display_surface(const ParticleTemplate& shape) {
    const DisplayMesh& mesh = shape.display_mesh;
    return {{mesh.vertices.begin(), mesh.vertices.end()},
            {mesh.triangles.begin(), mesh.triangles.end()}};
}

}  // namespace

ColoredMesh clump_surface(const ParticleTemplate& shape, std::size_t most_triangles) {
    const auto& clump = std::get<Clump>(shape.shape);
    const UnitSphere unit = unit_sphere(clump.spheres.size(), most_triangles);
    ColoredMesh result;
    constexpr auto unused = std::uint32_t(-1);
    for (std::uint32_t k = 0; k < clump.spheres.size(); ++k) {
        const ClumpSphere& s = clump.spheres[k];
        std::vector<std::uint32_t> place(unit.vertices.size(), unused);
        const auto corner = [&](std::uint32_t i) {
            return Vec3(s.center() + s.radius * unit.vertices[i]);
        };
        for (const auto& [a, b, c] : unit.triangles) {
            if (is_hidden(clump, k, {corner(a), corner(b), corner(c)})) continue;
            Triangle triangle{a, b, c};
            for (std::uint32_t& i : triangle) {
                if (place[i] == unused) {
                    place[i] = static_cast<std::uint32_t>(result.vertices.size());
                    result.vertices.push_back(corner(i));
                }
                i = place[i];
            }
            result.triangles.push_back(triangle);
        }
    }
    const SurfaceQuery body(display_surface(shape));
    for (const Vec3& p : result.vertices) result.values.push_back(body.signed_distance(p));
    return result;
}

ColoredMesh body_surface(const ParticleTemplate& shape) {
    std::vector<Ball> balls;
    for (const ClumpSphere& s : std::get<Clump>(shape.shape).spheres)
        balls.push_back({s.center(), s.radius});
    const BallTree tree(balls);
    TriangleMesh mesh = display_surface(shape);
    ColoredMesh result{std::move(mesh.vertices), std::move(mesh.triangles), {}};
    for (const Vec3& p : result.vertices) result.values.push_back(-tree.nearest(p).distance);
    return result;
}

}  // namespace dem::shapegen
