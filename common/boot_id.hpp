// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace dem {

/// A number that is another one after every start of the machine; 0 where the system has none.
std::uint64_t boot_id();

}  // namespace dem
