// SPDX-License-Identifier: BSD-3-Clause
#include "tests/physics/bounces/bounce.hpp"

#include "runtime/contact/law/pair_law.hpp"
#include "runtime/time_step.hpp"
#include "runtime/walls/wall_distance.hpp"
#include "tests/physics/bounces/interaction.hpp"
#include "tests/runtime/simulation/scenes.hpp"
#include "tests/support/log_uniform.hpp"

#include <algorithm>
#include <cmath>

namespace dem::test {

using namespace runtime;

namespace {

constexpr double density = 1000.0;      // [kg/m^3]
constexpr double youngs_modulus = 5e6;  // [Pa]

double equivalent_radius(const ParticleTemplate& shape) {
    return 0.5 * equivalent_diameter(shape.mass_properties.volume);
}

/// A bounce that is about to happen.
struct Setup {
    Random random;
    ParticleTemplate i, j;  // j without meaning for a wall
    std::optional<Wall> wall;
    TwoBodies bodies;
    double speed = 0.0;  // of approach [m/s]
};

InverseInertia inertia_of(const ParticleTemplate& shape) {
    const MassProperties& m = shape.mass_properties;
    return inverse_inertia(density * m.volume, density * m.principal_moments_per_density);
}

/// Turned any way, or with a face or an axis nearly along or across the direction to the other.
Quat attitude(const ParticleTemplate& shape, const Vec3& to, Random& random) {
    const double kind = random.uniform();
    if (kind < 0.5) return random.orientation();
    const auto* convex = std::get_if<ConvexShape>(&shape.shape);
    Vec3 face = Vec3::UnitZ();
    if (convex != nullptr && !convex->planes.empty()) face = convex->planes[0].normal;
    const Vec3 direction = kind < 0.75 ? to : Vec3(to.cross(random.direction()).normalized());
    const Quat spun = orientation_towards(direction) *
                      rotation(Vec3(0.0, 0.0, random.uniform(0.0, 2.0 * pi))) *
                      orientation_towards(face).conjugate();
    return rotation(log_uniform(random, 1e-6, 0.3) * random.direction()) * spun;
}

/// Which overlap a bounce of round bodies of this size would reach, from grazing to almost too
/// deep; those with edges go deeper.
double approach_speed(const Setup& s) {
    Random random = s.random;
    const double r_i = equivalent_radius(s.i);
    const double r_j = s.wall ? 1e3 * r_i : equivalent_radius(s.j);
    const double reduced = 1.0 / (s.bodies.i.inverse.mass + s.bodies.j.inverse.mass);
    const double overlap = log_uniform(random, 1e-4, 0.05) * std::min(r_i, r_j);
    const double stiffness = 0.5 * youngs_modulus / 0.91 * std::sqrt(r_i * r_j / (r_i + r_j));
    return std::sqrt(16.0 / 15.0 * stiffness * std::pow(overlap, 2.5) / reduced);
}

void spin(Body& body, double radius, double speed, Random& random) {
    constexpr std::array rims = {0.0, 0.3, 1.0, 3.0};
    const double rim = rims[static_cast<std::size_t>(4.0 * random.uniform())] * speed;
    const Vec3 along_axes = random.direction();
    body.angular_momentum =
        rim / radius * (body.orientation * Vec3(along_axes.cwiseQuotient(body.inverse.moments)));
}

void place_pair(Setup& s) {
    const Vec3 towards = s.random.direction();
    const double far = s.i.bounding_radius + s.j.bounding_radius;
    const Vec3 across = towards.cross(s.random.direction()).normalized();
    TwoBodies& b = s.bodies;
    b.j.position = far * towards + s.random.uniform(0.0, 0.6 * far) * across;
    b.i.orientation = attitude(s.i, towards, s.random);
    b.j.orientation = attitude(s.j, -towards, s.random);
    const double share = b.i.inverse.mass / (b.i.inverse.mass + b.j.inverse.mass);
    b.i.velocity = share * s.speed * towards;
    b.j.velocity = (share - 1.0) * s.speed * towards;
    spin(b.i, s.i.bounding_radius, s.speed, s.random);
    spin(b.j, s.j.bounding_radius, s.speed, s.random);
}

void place_at_wall(Kind kind, Setup& s) {
    const double size = s.i.bounding_radius;
    Vec3 away = Vec3::UnitZ();  // of the body from the wall
    Vec3 place = 1.001 * size * away;
    Wall wall;
    wall.name = "wall";
    if (kind == Kind::plane) {
        wall.shape = PlaneWall{};
    } else {
        CylinderWall cylinder;
        cylinder.inside = kind == Kind::tube;
        const double turn = s.random.uniform(0.0, 2.0 * pi);
        const Vec3 outward(std::cos(turn), std::sin(turn), 0.0);
        away = cylinder.inside ? Vec3(-outward) : outward;
        cylinder.radius = size * (cylinder.inside ? log_uniform(s.random, 1.2, 10.0)
                                                  : log_uniform(s.random, 0.1, 5.0));
        place = (cylinder.radius + (cylinder.inside ? -1.001 : 1.001) * size) * outward;
        if (!cylinder.inside && s.random.uniform() < 0.6) {
            cylinder.length = size * s.random.uniform(0.5, 4.0);
            const Vec3 target =
                cylinder.radius * outward + Vec3(0.0, 0.0, cylinder.length * s.random.uniform());
            away = (target - Vec3(0.0, 0.0, 0.5 * cylinder.length)).normalized();
            place = target + (cylinder.radius + cylinder.length + size) * away;
        }
        wall.shape = cylinder;
    }
    s.bodies.i.position = place;
    s.bodies.i.orientation = attitude(s.i, -away, s.random);
    s.bodies.i.velocity = s.speed * (-away + 0.5 * s.random.uniform() * s.random.direction());
    spin(s.bodies.i, size, s.speed, s.random);
    s.wall = wall;
}

Setup make_setup(const BounceSettings& settings, std::uint64_t seed) {
    const auto pair =
        100 * static_cast<std::uint64_t>(settings.i) + static_cast<std::uint64_t>(settings.j);
    Setup s{Random(seed, pair), {}, {}, std::nullopt, {}, 0.0};
    s.i = member(settings.i, settings.j, s.random);
    s.bodies.i.inverse = inertia_of(s.i);
    if (is_wall(settings.j)) {
        s.wall.emplace();
        s.speed = approach_speed(s);
        s.random.next();
        place_at_wall(settings.j, s);
        return s;
    }
    s.j = member(settings.j, settings.i, s.random);
    s.bodies.j.inverse = inertia_of(s.j);
    // Either may come first.
    if (s.random.uniform() < 0.5) {
        std::swap(s.i, s.j);
        std::swap(s.bodies.i, s.bodies.j);
    }
    s.speed = approach_speed(s);
    s.random.next();
    place_pair(s);
    return s;
}

BodyPlacement placement(const Body& body, std::uint32_t kind) {
    BodyPlacement p;
    p.position = body.position;
    p.orientation = body.orientation;
    p.velocity = body.velocity;
    p.angular_velocity = body.angular_velocity();
    p.kind = kind;
    return p;
}

struct LawAndStep {
    ContactLaw law;
    double dt;
};

/// As the program would choose them for these two bodies.
LawAndStep law_and_step(const Setup& s, const BounceSettings& settings) {
    Scene scene = scenes::one_material({youngs_modulus, density, 1.0, 0.0, {}});
    ContactLaw law = scene.laws.at(0, 0);
    if (settings.model == ContactLaw::Model::linear) {
        // As stiff as the other at an overlap of a hundredth.
        const double r = equivalent_radius(s.i);
        law = linear_law(0.1 * law.youngs_modulus * r, 1.0, 1.0);
        scene.laws.set(0, 0, law);
    }
    std::vector<BodyPlacement> bodies{placement(s.bodies.i, 0)};
    scenes::add_kind(scene, s.i);
    if (s.wall) {
        scene.walls.push_back(*s.wall);
    } else {
        scenes::add_kind(scene, s.j);
        bodies.push_back(placement(s.bodies.j, 1));
    }
    scene.insertions.push_back(scenes::placed(std::move(bodies)));
    if (settings.divisor) scene.run.time_step_divisor = *settings.divisor;
    return {law, time_step(scene).value};
}

double total_energy(const TwoBodies& b) {
    return b.mechanical_energy() + b.dissipated;
}

/// The energies of the last steps. Within a step the velocities lag behind a force that changes
/// suddenly by half a step: what the next step gives back is no jump.
class EnergySteps {
  public:
    explicit EnergySteps(double energy) { energies_.fill(energy); }
    void add(double energy) {
        std::rotate(energies_.begin(), energies_.begin() + 1, energies_.end());
        energies_.back() = energy;
    }
    double now() const { return energies_.back(); }
    /// Between the second and the third of four, as far as it lasted.
    double jump() const {
        return std::min(std::abs(energies_[2] - energies_[1]),
                        std::abs(energies_[3] - energies_[0]));
    }

  private:
    std::array<double, 4> energies_{};
};

/// Two bodies, their kernel and their steps.
class Thrown {
  public:
    Thrown(Setup& setup, const LawAndStep& how)
        : s_(setup),
          how_(how),
          kernel_(setup.wall ? interaction(setup.i, setup.wall->shape, how.law)
                             : interaction(setup.i, setup.j, how.law)) {
        if (s_.wall) wall_state_.position = s_.wall->position;
    }

    /// Apart, the bodies only fly: no farther than they are certain not to meet.
    void step() {
        const TwoBodies& b = s_.bodies;
        const double j_size = s_.wall ? 0.0 : s_.j.bounding_radius;
        const double pace = (b.i.velocity - b.j.velocity).norm() +
                            b.i.angular_velocity().norm() * s_.i.bounding_radius +
                            b.j.angular_velocity().norm() * j_size;
        const double flight = b.contact.touches() ? 0.0 : 0.9 * gap() / pace;
        const double dt = std::max(flight, how_.dt);
        travel_ += 1.5 * pace * dt;
        s_.bodies.step(dt, [&](const PairState& pair, double h) {
            return kernel_->collide(pair, how_.law, h, travel_);
        });
    }
    double gap() const {
        const TwoBodies& b = s_.bodies;
        const double balls = s_.wall ? wall_distance(s_.wall->shape, wall_state_, b.i.position) -
                                           s_.i.bounding_radius
                                     : (b.j.position - b.i.position).norm() - s_.i.bounding_radius -
                                           s_.j.bounding_radius;
        return std::max({balls, kernel_->gap(travel_), 0.0});
    }
    /// Away from each other, for good.
    bool is_over(bool touched) const {
        const double size = s_.i.bounding_radius;
        if (touched) return gap() > 1e-3 * size;
        if (s_.wall)
            return s_.bodies.i.position.norm() > 60.0 * size || (gap() > 0.5 * size && parts());
        const Vec3 apart = s_.bodies.j.position - s_.bodies.i.position;
        const double far = size + s_.j.bounding_radius;
        return apart.norm() > far && apart.dot(s_.bodies.j.velocity - s_.bodies.i.velocity) > 0.0;
    }

  private:
    bool parts() const { return s_.bodies.i.position.dot(s_.bodies.i.velocity) > 0.0; }

    Setup& s_;
    LawAndStep how_;
    std::unique_ptr<Interaction> kernel_;
    WallState wall_state_{};
    double travel_ = 0.0;
};

}  // namespace

Bounce bounce(const BounceSettings& settings, std::uint64_t seed, const BounceWatch& watch) {
    Setup setup = make_setup(settings, seed);
    const LawAndStep how = law_and_step(setup, settings);
    Thrown thrown(setup, how);
    const double radius = setup.wall
                              ? equivalent_radius(setup.i)
                              : std::min(equivalent_radius(setup.i), equivalent_radius(setup.j));
    Bounce result;
    result.seed = seed;
    EnergySteps energies(total_energy(setup.bodies));
    const double reference = energies.now();
    double first = reference;
    constexpr std::uint64_t most_steps = 100'000;
    std::uint64_t flights = 0;
    while (result.steps < most_steps && flights < 2000) {
        thrown.step();
        const bool touches = setup.bodies.contact.touches();
        if (touches && !result.touched) {
            result.touched = true;
            // Flights are long steps: what they do to a spin is not to the point.
            first = energies.now();
        }
        energies.add(total_energy(setup.bodies));
        if (watch)
            watch({setup.i, setup.j, setup.wall, setup.bodies, how.dt, energies.now() / reference});
        if (result.touched) {
            ++result.steps;
            const double jump = energies.jump() / reference;
            if (jump > result.jump) {
                result.jump = jump;
                result.moment = static_cast<double>(result.steps) * how.dt;
            }
        } else {
            ++flights;
        }
        result.cores_met = result.cores_met || setup.bodies.contact.cores_met;
        result.overlap = std::max(result.overlap, setup.bodies.contact.overlap / radius);
        if (result.overlap > deepest_bounce) break;
        if (!touches && thrown.is_over(result.touched)) break;
    }
    result.change = std::abs(energies.now() - first) / reference;
    return result;
}

}  // namespace dem::test
