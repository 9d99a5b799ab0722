// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dem::runtime {

/// 8-bit RGB picture, row by row from the top left.
struct Image {
    std::size_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< 3 * width * height
};

/// The bytes of a PNG file (zlib-compressed).
std::string encode_png(const Image& image);

}  // namespace dem::runtime
