// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// The 32 bytes before the payload of a `.tpl` file, all integers little-endian:
///
///     0   8  magic "DEMTPL\r\n" (a transfer as text destroys it)
///     8   4  format version
///     12  4  size of this header, 32
///     16  8  size of the payload; the file ends with it
///     24  8  XXH3 64 of the payload; in version 1 FNV-1a 64
///
/// Every byte is checked, so that a change of any byte of the file is noticed.
namespace dem {

inline constexpr std::size_t template_header_size = 32;
/// What is written; version 1, which differs in its checksum alone, is read as well.
inline constexpr std::uint32_t template_format_version = 2;

/// The payload of FlatBuffers addresses itself by signed 32-bit offsets.
inline constexpr std::uint64_t largest_template_payload = 0x7fffffff;

std::array<std::byte, template_header_size> template_header(std::span<const std::byte> payload);

/// The payload within the bytes of a file. Throws Error, with `where` in front, that tells apart:
/// not a template, an unknown format version, truncated, too long, damaged.
std::span<const std::byte> template_payload(std::span<const std::byte> file,
                                            const std::string& where);

}  // namespace dem
