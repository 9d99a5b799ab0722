// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/meshes/mesh_contacts.hpp"

#include <algorithm>

// ContactPoint::feature is, from its highest bits on, the number of the touched side (16 bits),
// that of the ball (40) and that of the place among the ball's (8) while places are gathered; then
// the number of the contact takes the place of that of the side, and goes. Places of one ball in
// one contact are told apart by their normals: a place goes on as the one of the step before whose
// normal is nearest to its own.

namespace dem::runtime {

namespace {

constexpr unsigned side_shift = 48;
constexpr unsigned ball_shift = 8;
constexpr std::uint64_t below_side = (std::uint64_t{1} << side_shift) - 1;
constexpr std::uint64_t most_places = std::uint64_t{1} << ball_shift;

std::uint64_t ball_of(std::uint64_t feature) {
    return (feature & below_side) >> ball_shift;
}

constexpr auto by_feature = [](const ContactPoint& a, const ContactPoint& b) {
    return a.feature < b.feature;
};

}  // namespace

void MeshContacts::add_place(ContactPoint point, std::uint32_t side) {
    if (count_ == room_.size()) return;
    const std::uint64_t ball = point.feature;
    std::uint64_t place = 0;
    if (count_ > 0 && ball_of(room_[count_ - 1].feature) == ball)
        place = room_[count_ - 1].feature % most_places + 1;
    point.feature = std::uint64_t{side} << side_shift | ball << ball_shift | place;
    room_[count_++] = point;
}

/// Sides that one contact touched in the step before are still one contact.
void MeshContacts::join_by_history() {
    const MeshHistory& history = call_.memory.history;
    std::array<std::uint32_t, MeshHistory::most_contacts> first{};
    std::array<bool, MeshHistory::most_contacts> is_seen{};
    for (std::uint32_t n = 0; n < sides_.count(); ++n) {
        const std::size_t contact = history.contact_of(sides_.side(n));
        if (contact == history.used) continue;
        if (is_seen[contact])
            sides_.join(first[contact], n);
        else
            first[contact] = n;
        is_seen[contact] = true;
    }
}

/// The group of a side, a new one where its contact has none.
std::uint64_t MeshContacts::group_of(std::uint32_t side) {
    const std::uint32_t contact = sides_.contact_of(side);
    for (std::size_t g = 0; g < group_count_; ++g)
        if (groups_[g].contact == contact) return g;
    if (group_count_ == groups_.size()) return group_count_ - 1;
    groups_[group_count_] = {{}, contact, call_.memory.history.used, 0, Vec3::Zero()};
    return group_count_++;
}

void MeshContacts::sort_into_groups() {
    const std::span<ContactPoint> points = room_.first(count_);
    for (ContactPoint& p : points) {
        const auto side = static_cast<std::uint32_t>(p.feature >> side_shift);
        p.feature = group_of(side) << side_shift | (p.feature & below_side);
    }
    if (!std::is_sorted(points.begin(), points.end(), by_feature))
        std::sort(points.begin(), points.end(), by_feature);
    std::size_t begin = 0;
    for (std::size_t g = 0; g < group_count_; ++g) {
        std::size_t end = begin;
        double deepest = 0.0;
        for (; end < count_ && points[end].feature >> side_shift == g; ++end) {
            points[end].feature &= below_side;
            if (points[end].overlap <= deepest) continue;
            deepest = points[end].overlap;
            groups_[g].deepest_ball = static_cast<std::uint32_t>(ball_of(points[end].feature));
            groups_[g].deepest_normal = points[end].gradient.normalized();
        }
        groups_[g].points = points.subspan(begin, end - begin);
        begin = end;
    }
}

void MeshContacts::make_groups() {
    join_by_history();
    sort_into_groups();
    // The lowest old contact goes on where several have become one.
    const MeshHistory& history = call_.memory.history;
    for (std::uint32_t n = 0; n < sides_.count(); ++n) {
        const std::size_t old = history.contact_of(sides_.side(n));
        for (std::size_t g = 0; g < group_count_; ++g)
            if (groups_[g].contact == sides_.contact_of(n))
                groups_[g].old = std::min(groups_[g].old, old);
    }
    for (std::size_t g = 0; g < group_count_; ++g) name_places(groups_[g]);
}

/// Numbers the places of each ball so that they keep their numbers from step to step.
void MeshContacts::name_places(Group& group) const {
    const MeshHistory& history = call_.memory.history;
    const PatchHistory none{};
    const PatchHistory& before =
        group.old < history.used ? history.contacts[group.old].history : none;
    std::array<bool, PatchHistory::slot_count> taken{};
    for (std::size_t k = 0; k < group.points.size(); ++k) {
        ContactPoint& p = group.points[k];
        const std::uint64_t ball = ball_of(p.feature);
        std::size_t best = before.used;
        double nearest = 0.5;
        for (std::size_t s = 0; s < before.used; ++s) {
            if (taken[s] || ball_of(before.slots[s].feature) != ball) continue;
            const double cosine = p.gradient.dot(Vec3(before.slots[s].normal));
            if (cosine <= nearest) continue;
            nearest = cosine;
            best = s;
        }
        std::uint64_t place = 0;
        if (best < before.used) {
            taken[best] = true;
            place = before.slots[best].feature % most_places;
        } else {
            // The lowest number that neither a place before has nor one of this step.
            const auto is_used = [&](std::uint64_t feature) {
                for (std::size_t s = 0; s < before.used; ++s)
                    if (before.slots[s].feature == feature) return true;
                for (std::size_t m = 0; m < k; ++m)
                    if (group.points[m].feature == feature) return true;
                return false;
            };
            while (place + 1 < most_places && is_used(ball << ball_shift | place)) ++place;
        }
        p.feature = ball << ball_shift | place;
    }
    if (!std::is_sorted(group.points.begin(), group.points.end(), by_feature))
        std::sort(group.points.begin(), group.points.end(), by_feature);
}

std::array<PatchSide, MeshHistory::most_sides> MeshContacts::sides_of(std::size_t group) const {
    std::array<PatchSide, MeshHistory::most_sides> lowest;
    lowest.fill(MeshHistory::none);
    for (std::uint32_t n = 0; n < sides_.count(); ++n) {
        if (sides_.contact_of(n) != groups_[group].contact) continue;
        PatchSide side = sides_.side(n);
        for (PatchSide& place : lowest)
            if (side < place) std::swap(side, place);
    }
    return lowest;
}

/// What the springs of the contacts held that do not go on [J].
double MeshContacts::end_others() const {
    const MeshHistory& history = call_.memory.history;
    double lost = 0.0;
    for (std::size_t k = 0; k < history.used; ++k) {
        bool goes_on = false;
        for (std::size_t g = 0; g < group_count_; ++g) goes_on = goes_on || groups_[g].old == k;
        if (!goes_on) lost += held_energy(history.contacts[k].history);
    }
    return lost;
}

/// Gives each group the place of its number in the history, with what it remembers.
void MeshContacts::put_in_order() {
    MeshHistory& history = call_.memory.history;
    bool is_in_order = true;
    for (std::size_t g = 0; g < group_count_; ++g)
        is_in_order = is_in_order && groups_[g].old == (g < history.used ? g : history.used);
    if (is_in_order) {
        for (std::size_t k = group_count_; k < history.used; ++k) history.contacts[k] = {};
    } else {
        const MeshHistory before = history;
        history = {};
        for (std::size_t g = 0; g < group_count_; ++g)
            if (groups_[g].old < before.used) history.contacts[g] = before.contacts[groups_[g].old];
    }
    history.used = group_count_;
}

}  // namespace dem::runtime
