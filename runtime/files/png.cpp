// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/png.hpp"

#include "common/error.hpp"

#include <zlib.h>

namespace dem::runtime {

namespace {

void append_big_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<char>((value >> shift) & 0xffU));
    }
}

std::uint32_t length_of(const std::string& bytes) {
    return static_cast<std::uint32_t>(bytes.size());
}

void append_chunk(std::string& png, const std::string& type, const std::string& data) {
    append_big_endian(png, length_of(data));
    const std::string body = type + data;
    png += body;
    append_big_endian(
        png, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                              static_cast<uInt>(body.size()))));
}

std::string compressed(const std::string& raw) {
    uLongf size = compressBound(static_cast<uLong>(raw.size()));
    std::string data(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(data.data()), &size,
                  reinterpret_cast<const Bytef*>(raw.data()), static_cast<uLong>(raw.size()),
                  Z_DEFAULT_COMPRESSION) != Z_OK) {
        throw Error("picture: compression failed");
    }
    data.resize(size);
    return data;
}

}  // namespace

std::string encode_png(const Image& image) {
    std::string header;
    append_big_endian(header, static_cast<std::uint32_t>(image.width));
    append_big_endian(header, static_cast<std::uint32_t>(image.height));
    header += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB, no interlace

    std::string rows;
    rows.reserve(image.height * (1 + 3 * image.width));
    for (std::size_t y = 0; y < image.height; ++y) {
        rows.push_back('\0');  // filter "none"
        rows.append(reinterpret_cast<const char*>(image.rgb.data() + 3 * image.width * y),
                    3 * image.width);
    }

    std::string png("\x89PNG\r\n\x1a\n", 8);
    append_chunk(png, "IHDR", header);
    append_chunk(png, "IDAT", compressed(rows));
    append_chunk(png, "IEND", "");
    return png;
}

}  // namespace dem::runtime
