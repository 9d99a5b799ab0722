// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace dem::shapegen {

/// The number whose bytes, in the order of `order`, begin there.
template <class Number>
Number read_as(const std::byte* bytes, std::endian order = std::endian::little) {
    std::array<std::byte, sizeof(Number)> own;
    std::copy_n(bytes, own.size(), own.begin());
    if (order != std::endian::native) std::reverse(own.begin(), own.end());
    return std::bit_cast<Number>(own);
}

}  // namespace dem::shapegen
