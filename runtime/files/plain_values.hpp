// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dem::runtime {

/// Values of one type as they lie in memory.
struct PlainValues {
    std::string type;             ///< what one of them is; compared when they are read back
    std::size_t value_bytes = 1;  ///< of one of them
    std::vector<std::byte> bytes;
};

}  // namespace dem::runtime
