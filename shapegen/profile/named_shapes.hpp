// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_text.hpp"

namespace dem::shapegen {

/// The segments of the shape named by the setting `shape` with the parameters in the other settings
/// (docs/profile-file.md lists them), centered on the origin. Throws Error(file:line, ...) for an
/// unknown shape or parameter, a missing one, and values that make no body.
ProfileDraft named_shape(const ProfileText& text);

}  // namespace dem::shapegen
