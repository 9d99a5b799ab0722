// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_point.hpp"

/// Histories as kernels in lanes know them: of contacts that touch in one point.
namespace dem::runtime {

/// Whether a contact touched in one point, with one normal for all that it remembers.
inline bool is_one_point(const PointHistory& /*history*/) {
    return true;
}
inline bool is_one_point(const PatchHistory& history) {
    return history.used == 1 && Vec3(history.slots[0].normal) == Vec3(history.normal);
}
inline SpringHistory& spring_of(PointHistory& history) {
    return history;
}
inline SpringHistory& spring_of(PatchHistory& history) {
    return history.slots[0];
}
/// After a kernel has moved the contact on.
inline void share_normal(PointHistory& /*history*/) {}
inline void share_normal(PatchHistory& history) {
    history.slots[0].normal = history.normal;
}

}  // namespace dem::runtime
