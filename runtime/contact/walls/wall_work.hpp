// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/contact_types.hpp"

namespace dem::runtime {

/// What a moving wall j gives to the body i by a contact in this step [J]. The wall feels -force
/// and torque_j; what it gives is their work, negated.
template <class Pair>
typename Pair::Real wall_work(const Pair& pair, const typename Pair::Contact& contact, double dt) {
    return dt *
           (contact.force.dot(pair.j.velocity) - contact.torque_j.dot(pair.j.angular_velocity));
}

}  // namespace dem::runtime
