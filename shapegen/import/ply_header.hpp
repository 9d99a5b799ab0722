// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dem::shapegen {

/// What a PLY file says about itself before its data.
struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian };
    enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

    /// A number, or a list of numbers behind their count.
    struct Property {
        std::string name;
        Type type = Type::float32;
        std::optional<Type> count_type;  ///< of a list
    };
    struct Element {
        std::string name;
        std::uint64_t count = 0;
        std::vector<Property> properties;
        std::size_t line = 0;

        /// The index of a property, or nothing.
        std::optional<std::size_t> find(std::string_view property) const;
        /// Bytes that each of them takes at least.
        std::uint64_t least_size(Format format) const;
    };

    Format format = Format::ascii;
    std::vector<Element> elements;
    std::size_t size = 0;   ///< bytes up to the data
    std::size_t lines = 0;  ///< up to the data

    /// Throws Error at NAME:LINE for what is no header.
    static PlyHeader parse(std::string_view text, const std::string& name);
};

/// Bytes in a binary file.
std::size_t size_of(PlyHeader::Type type);
bool is_integer(PlyHeader::Type type);

}  // namespace dem::shapegen
