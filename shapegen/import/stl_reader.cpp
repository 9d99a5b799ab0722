// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/stl_reader.hpp"

#include "common/error.hpp"
#include "shapegen/import/byte_reader.hpp"
#include "shapegen/import/text_scanner.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace dem::shapegen {
namespace {

constexpr std::size_t header_size = 84;    // 80 bytes of anything, the number of triangles
constexpr std::size_t triangle_size = 50;  // normal, three corners, two bytes of attributes

/// A solid of a binary file.
struct Block {
    std::size_t begin = 0;  ///< of its header
    std::size_t count = 0;  ///< of triangles
    std::size_t end() const { return begin + header_size + triangle_size * count; }
};

/// The block that begins there, when its header is within the file.
std::optional<Block> block_at(std::span<const std::byte> bytes, std::size_t begin) {
    if (bytes.size() - begin < header_size) return std::nullopt;
    return Block{begin, read_as<std::uint32_t>(bytes.data() + begin + header_size - 4)};
}

/// The solids of a file that some program wrote one after the other; nothing when they do not fill
/// the file.
std::vector<Block> filling_blocks(std::span<const std::byte> bytes) {
    std::vector<Block> blocks;
    std::size_t begin = 0;
    while (begin < bytes.size()) {
        const auto block = block_at(bytes, begin);
        if (!block || block->end() > bytes.size()) return {};
        blocks.push_back(*block);
        begin = block->end();
    }
    return blocks;
}

std::string size_words(std::size_t found, const Block& block) {
    const std::string count = std::to_string(block.count);
    return "found " + std::to_string(found) + " bytes, expected 84 + 50 x " + count + " = " +
           std::to_string(block.end()) + " for the " + count +
           " triangles that bytes 80 to 83 count";
}

void read_block(std::span<const std::byte> bytes, const Block& block, const std::string& name,
                PolygonSoup& soup) {
    const std::byte* at = bytes.data() + block.begin + header_size;
    for (std::size_t t = 0; t < block.count; ++t, at += triangle_size) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::byte* corner = at + 12 * (k + 1);
            const Vec3 point(static_cast<double>(read_as<float>(corner)),
                             static_cast<double>(read_as<float>(corner + 4)),
                             static_cast<double>(read_as<float>(corner + 8)));
            if (!point.allFinite())
                throw Error(name + ": byte " + std::to_string(corner - bytes.data()),
                            "found a corner of triangle " + std::to_string(t + 1) +
                                " that is not a finite number, expected coordinates");
            soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
            soup.points.push_back(point);
        }
        soup.end_face();
    }
}

PolygonSoup read_binary(std::span<const std::byte> bytes, const std::string& name) {
    std::vector<Block> blocks = filling_blocks(bytes);
    PolygonSoup soup;
    if (blocks.empty()) {
        const Block block = block_at(bytes, 0).value();
        const std::size_t size = bytes.size();
        const bool is_short = block.end() > size;
        // As many bytes as triangles have: the number of triangles is wrong.
        const bool is_miscounted = !is_short && ((size - block.end()) % triangle_size == 0 ||
                                                 size - block.end() > block.end());
        if (is_short || is_miscounted) throw Error(name, size_words(size, block));
        soup.notes.push_back(
            std::to_string(size - block.end()) +
            " bytes after the last triangle passed over: " + size_words(size, block));
        blocks.push_back(block);
    }
    std::size_t count = 0;
    for (const Block& block : blocks) count += block.count;
    soup.points.reserve(3 * count);
    soup.corners.reserve(3 * count);
    soup.face_ends.reserve(count);
    for (const Block& block : blocks) read_block(bytes, block, name, soup);
    return soup;
}

/// Words, whatever lines they stand on: solid [name], facet [normal x y z], outer loop, three times
/// vertex x y z, endloop, endfacet, endsolid [name].
class TextReader {
  public:
    TextReader(std::string_view text, const std::string& name) : text_(text, name, {}) {}

    PolygonSoup read() {
        bool is_in_solid = false;
        for (std::string_view word = text_.word_of_any_line(); !word.empty();
             word = text_.word_of_any_line()) {
            if (is_in_solid && is_keyword(word, "facet")) {
                read_facet();
            } else if (is_keyword(word, is_in_solid ? "endsolid" : "solid")) {
                is_in_solid = !is_in_solid;
                skip_name();
            } else {
                text_.fail(word, is_in_solid ? "facet or endsolid" : "solid");
            }
        }
        if (is_in_solid) soup_.notes.emplace_back("the last solid has no endsolid");
        return std::move(soup_);
    }

  private:
    void skip_name() {
        while (!text_.word().empty()) continue;
    }

    void read_facet() {
        std::string_view word = text_.word_of_any_line();
        if (is_keyword(word, "normal")) {
            // Of any form, or none: it carries nothing for the shape.
            do {
                word = text_.word();
            } while (!word.empty() && !is_keyword(word, "outer"));
            if (word.empty()) word = text_.word_of_any_line();
        }
        require(word, "outer");
        require(text_.word_of_any_line(), "loop");
        for (int corner = 0; corner < 3; ++corner) read_vertex();
        word = text_.word_of_any_line();
        if (is_keyword(word, "vertex"))
            throw Error(text_.place(), "found a fourth vertex in a facet, expected endloop");
        require(word, "endloop");
        require(text_.word_of_any_line(), "endfacet");
        soup_.end_face();
    }

    void read_vertex() {
        require(text_.word_of_any_line(), "vertex");
        Vec3 point;
        for (double& x : point) x = text_.number("the three coordinates of a vertex");
        soup_.corners.push_back(static_cast<std::uint32_t>(soup_.points.size()));
        soup_.points.push_back(point);
    }

    void require(std::string_view word, std::string_view keyword) const {
        if (!is_keyword(word, keyword)) text_.fail(word, keyword);
    }

    TextScanner text_;
    PolygonSoup soup_;
};

/// Begins with the word solid, and has none of the zeros that fill the header of a binary file.
bool is_text(std::span<const std::byte> bytes) {
    const std::string_view start = text_of(bytes.first(std::min(bytes.size(), header_size)));
    TextScanner words(start, "", {});
    return is_keyword(words.word_of_any_line(), "solid") &&
           start.find('\0') == std::string_view::npos;
}

}  // namespace

PolygonSoup read_stl(std::span<const std::byte> bytes, const std::string& name) {
    const auto block = block_at(bytes, 0);
    const bool is_binary = block && block->end() == bytes.size();
    if (!is_binary && is_text(bytes)) return TextReader(text_of(bytes), name).read();
    if (block) return read_binary(bytes, name);
    throw Error(name, "found " + std::to_string(bytes.size()) +
                          " bytes that do not begin with solid, expected STL: text, or 84 bytes "
                          "and 50 for each triangle");
}

}  // namespace dem::shapegen
