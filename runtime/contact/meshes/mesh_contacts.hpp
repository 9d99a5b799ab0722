// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/shapes/wall_mesh.hpp"
#include "runtime/contact/meshes/ball_touch.hpp"
#include "runtime/contact/meshes/mesh_history.hpp"
#include "runtime/contact/meshes/smooth_touch.hpp"
#include "runtime/contact/walls/mesh_wall.hpp"

#include <limits>
#include <span>

/// From the places where the balls of a body touch a mesh wall to contacts and their forces.
namespace dem::runtime {

/// How a mesh wall lies in a pair.
struct MeshFrame {
    Mat3 to_world;
    Vec3 origin;  ///< relative to the center of i [m]

    explicit MeshFrame(const PairState& pair)
        : to_world(pair.j.orientation.toRotationMatrix()), origin(pair.displacement) {}
    /// A place relative to the center of i in the frame of the mesh.
    Vec3 in_mesh(const Vec3& x) const { return to_world.transpose() * (x - origin); }
};

/// A ball of body i: its number, its center relative to the center of i, its radius [m].
struct BodyBall {
    std::uint32_t number;
    Vec3 center;
    double radius;
};

/// Gathers what the balls of one body touch in a step and gives the force of all contacts.
class MeshContacts {
  public:
    /// `room`: for the touching places of all balls; what does not fit is left out.
    MeshContacts(const MeshWall& wall, const MeshCall& call, std::span<ContactPoint> room)
        : mesh_(*wall.mesh), frame_(call.pair), call_(call), room_(room) {}

    const MeshFrame& frame() const { return frame_; }

    /// Adds what a ball touches of the triangles that `visit_triangles(visit)` calls visit(t) for,
    /// in rising order; visit returns the distance of a triangle [m]. Balls come in rising order.
    /// Returns the distance of the nearest [m].
    template <class VisitTriangles>
    double add(const BodyBall& ball, const VisitTriangles& visit_triangles);

    /// The same for a body that touches as a whole (SmoothTouches).
    template <class Support, class VisitTriangles>
    double add(const Support& support, const SmoothBody& body,
               const VisitTriangles& visit_triangles);

    bool empty() const { return count_ == 0; }

    /// The force of everything added, after which the history is that of this step.
    /// `radius_of(ball, normal)`: R* of the ball of a
    /// number where it is touched along a unit vector of the world [m].
    template <class RadiusOf>
    PairContact force(const RadiusOf& radius_of);

  private:
    /// The places of one contact.
    struct Group {
        std::span<ContactPoint> points;
        std::uint32_t contact = 0;  ///< as TouchedSides::contact_of() numbers it; of the last group
                                    ///< one of several where there are too many
        std::size_t old = 0;        ///< the contact of the step before that goes on; else `used`
        std::uint32_t deepest_ball = 0;
        Vec3 deepest_normal = Vec3::Zero();  ///< towards the body, world
    };

    /// `point`: its feature is the number of the ball.
    void add_place(ContactPoint point, std::uint32_t side);
    void make_groups();
    void join_by_history();
    std::uint64_t group_of(std::uint32_t side);
    void sort_into_groups();
    void name_places(Group& group) const;
    std::array<PatchSide, MeshHistory::most_sides> sides_of(std::size_t group) const;
    double end_others() const;
    void put_in_order();

    const WallMesh& mesh_;
    MeshFrame frame_;
    const MeshCall& call_;
    std::span<ContactPoint> room_;
    std::size_t count_ = 0;
    TouchedSides sides_;
    std::array<Group, MeshHistory::most_contacts> groups_{};
    std::size_t group_count_ = 0;
    bool is_lost_ = false;  ///< a ball has gone through the wall
};

template <class VisitTriangles>
double MeshContacts::add(const BodyBall& ball, const VisitTriangles& visit_triangles) {
    BallTouches touches(mesh_, frame_.in_mesh(ball.center), ball.radius, call_.memory.history,
                        sides_);
    double nearest = std::numeric_limits<double>::infinity();
    visit_triangles([&](std::uint32_t t) {
        const double distance = touches.add(t);
        nearest = std::min(nearest, distance);
        return distance;
    });
    is_lost_ = is_lost_ || touches.is_lost();
    touches.visit_places([&](const BallTouches::Place& place, std::uint32_t side) {
        const Vec3 gradient = frame_.to_world * place.gradient;
        const Vec3 lever =
            ball.center - (ball.radius - 0.5 * place.overlap) * gradient.normalized();
        add_place({lever, gradient, place.overlap, ball.number}, side);
    });
    return nearest;
}

template <class Support, class VisitTriangles>
double MeshContacts::add(const Support& support, const SmoothBody& body,
                         const VisitTriangles& visit_triangles) {
    SmoothTouches<Support> touches(mesh_, support, body, call_.memory.history, sides_);
    double nearest = std::numeric_limits<double>::infinity();
    visit_triangles([&](std::uint32_t t) {
        const double distance = touches.add(t);
        nearest = std::min(nearest, distance);
        return distance;
    });
    is_lost_ = is_lost_ || touches.is_lost();
    touches.leave_lowest();
    touches.visit_places([&](const MeshTouches::Place& place, std::uint32_t side) {
        const Vec3 gradient = frame_.to_world * place.gradient;
        const Vec3 lever = frame_.to_world * (place.point - body.center) +
                           0.5 * place.overlap * gradient.normalized();
        add_place({lever, gradient, place.overlap, 0}, side);
    });
    return nearest;
}

/// Adds the force of one contact to that of a pair, whose place is that of the heaviest.
inline void put_together(const PairContact& contact, PairContact& sum) {
    if (contact.normal_force >= sum.normal_force) {
        sum.place = contact.place;
        sum.normal = contact.normal;
    }
    sum.normal_force += contact.normal_force;
    sum.friction += contact.friction;
    sum.friction_limit += contact.friction_limit;
    sum.force += contact.force;
    sum.torque_i += contact.torque_i;
    sum.torque_j += contact.torque_j;
    sum.overlap = std::max(sum.overlap, contact.overlap);
    sum.elastic_energy += contact.elastic_energy;
    sum.dissipated_energy += contact.dissipated_energy;
    sum.points += contact.points;
}

/// Overlap of a body a ball of which has gone through the wall: no limit of overlaps allows it.
inline constexpr double lost_overlap = std::numeric_limits<double>::infinity();

template <class RadiusOf>
PairContact MeshContacts::force(const RadiusOf& radius_of) {
    make_groups();
    PairContact sum;
    sum.dissipated_energy = end_others();
    put_in_order();
    MeshHistory& history = call_.memory.history;
    for (std::size_t g = 0; g < group_count_; ++g) {
        MeshHistory::Contact& contact = history.contacts[g];
        contact.sides = sides_of(g);
        const PairContact one = contact_force(
            groups_[g].points, radius_of(groups_[g].deepest_ball, groups_[g].deepest_normal),
            call_.pair, call_.law, call_.dt, contact.history);
        put_together(one, sum);
        if (call_.scratch.several != nullptr) call_.scratch.several->push_back(one);
    }
    if (is_lost_) sum.overlap = std::max(sum.overlap, lost_overlap);
    return sum;
}

}  // namespace dem::runtime
