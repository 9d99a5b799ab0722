// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dem::runtime {

/// Takes the marked entries out of an array; the others keep their order.
template <class T>
void compact(std::vector<T>& values, std::span<const std::uint8_t> leaving) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (leaving[k] == 0) values[kept++] = values[k];
    }
    values.resize(kept);
}

}  // namespace dem::runtime
