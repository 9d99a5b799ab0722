// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/off_reader.hpp"

#include "common/error.hpp"
#include "shapegen/import/text_scanner.hpp"

#include <cstdint>
#include <string_view>
#include <utility>

namespace dem::shapegen {
namespace {

class OffReader {
  public:
    OffReader(std::span<const std::byte> bytes, const std::string& name)
        : text_(text_of(bytes), name, {.has_comments = true}) {}

    PolygonSoup read() {
        read_header();
        for (std::size_t v = 0; v < vertices_; ++v) {
            next_row("vertex", v, vertices_);
            Vec3 point;
            for (double& x : point) x = text_.number("the three coordinates of a vertex");
            soup_.points.push_back(point);
        }
        for (std::size_t f = 0; f < faces_; ++f) {
            next_row("face", f, faces_);
            read_face();
        }
        if (text_.next_line())
            text_.fail(text_.word(), "the end of the file after " + std::to_string(faces_) +
                                         " faces, as many as it promises");
        return std::move(soup_);
    }

  private:
    static constexpr std::string_view header = "OFF, COFF, NOFF or STOFF";

    /// The keyword, then the numbers of vertices, faces and edges, on its line or the next.
    void read_header() {
        if (!text_.next_line()) text_.fail("", header);
        const std::string_view keyword = text_.word();
        std::string_view rest = keyword;
        for (const std::string_view prefix : {"ST", "C", "N"})
            if (rest.starts_with(prefix)) rest.remove_prefix(prefix.size());
        // Some files have the first number without a blank: OFF490.
        if (!is_keyword(rest.substr(0, 3), "off")) text_.fail(keyword, header);
        std::string_view count = rest.substr(3);
        if (count.empty()) count = text_.word();
        if (is_keyword(count, "binary"))
            text_.fail(count, "text: binary OFF files are not read, STL and PLY are");
        if (count.empty() && text_.next_line()) count = text_.word();
        std::int64_t vertices = -1;
        if (!parse_whole_number(count, vertices) || vertices < 0)
            text_.fail(count, "the numbers of vertices, faces and edges");
        const std::int64_t faces = text_.whole_number("the numbers of vertices, faces and edges");
        if (faces < 0) text_.fail(std::to_string(faces), "a number of faces");
        // "0 0 0" and "3 0 0 0" with their line ends: no file has less.
        check_room(static_cast<std::uint64_t>(vertices), 6, "vertices");
        check_room(static_cast<std::uint64_t>(faces), 8, "faces");
        vertices_ = static_cast<std::size_t>(vertices);
        faces_ = static_cast<std::size_t>(faces);
        soup_.points.reserve(vertices_);
        soup_.face_ends.reserve(faces_);
    }

    void check_room(std::uint64_t count, std::uint64_t least_size, const std::string& what) const {
        const std::uint64_t most = (text_.bytes_left() + 1) / least_size;
        if (count > most)
            throw Error(text_.place(), "found " + std::to_string(count) + " " + what +
                                           " promised, expected no more than fit the file (" +
                                           std::to_string(most) + ")");
    }

    void next_row(const char* what, std::size_t index, std::size_t count) {
        if (text_.next_line()) return;
        text_.fail("", std::string(what) + " " + std::to_string(index + 1) + " of " +
                           std::to_string(count));
    }

    void read_face() {
        const std::int64_t count = text_.whole_number("the number of corners of a face");
        if (count < 3) text_.fail(std::to_string(count), "three or more corners of a face");
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int64_t corner = text_.whole_number("a vertex for each corner of a face");
            if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertices_)
                text_.fail(std::to_string(corner),
                           "one of the " + std::to_string(vertices_) + " vertices, counted from 0");
            soup_.corners.push_back(static_cast<std::uint32_t>(corner));
        }
        soup_.end_face();
    }

    TextScanner text_;
    PolygonSoup soup_;
    std::size_t vertices_ = 0, faces_ = 0;
};

}  // namespace

PolygonSoup read_off(std::span<const std::byte> bytes, const std::string& name) {
    return OffReader(bytes, name).read();
}

}  // namespace dem::shapegen
