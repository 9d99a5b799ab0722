// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/obj_reader.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "shapegen/import/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace dem::shapegen {
namespace {

/// What a statement is to a solid.
enum class Statement {
    vertex,
    face,
    attribute,  ///< numbers that carry nothing for the shape
    label,  ///< words that carry nothing for the shape, paths that end in a backslash among them
    thin,   ///< points and lines
    free_form,  ///< curves and surfaces
    other_file
};

constexpr std::pair<std::string_view, Statement> statements[] = {
    {"v", Statement::vertex},
    {"f", Statement::face},
    {"vn", Statement::attribute},
    {"vt", Statement::attribute},
    {"g", Statement::label},
    {"o", Statement::label},
    {"s", Statement::label},
    {"usemtl", Statement::label},
    {"mtllib", Statement::label},
    {"fo", Statement::face},  // faces in old files
    {"p", Statement::thin},
    {"l", Statement::thin},
    {"curv", Statement::free_form},
    {"curv2", Statement::free_form},
    {"surf", Statement::free_form},
    {"vp", Statement::attribute},
    {"cstype", Statement::attribute},
    {"deg", Statement::attribute},
    {"bmat", Statement::attribute},
    {"step", Statement::attribute},
    {"parm", Statement::attribute},
    {"trim", Statement::attribute},
    {"hole", Statement::attribute},
    {"scrv", Statement::attribute},
    {"sp", Statement::attribute},
    {"end", Statement::attribute},
    {"con", Statement::attribute},
    {"ctech", Statement::attribute},
    {"stech", Statement::attribute},
    {"bsp", Statement::attribute},
    {"bzp", Statement::attribute},
    {"cdc", Statement::attribute},
    {"cdp", Statement::attribute},
    {"res", Statement::attribute},
    {"mg", Statement::label},
    {"usemap", Statement::label},
    {"maplib", Statement::label},
    {"bevel", Statement::label},
    {"c_interp", Statement::label},
    {"d_interp", Statement::label},
    {"lod", Statement::label},
    {"shadow_obj", Statement::label},
    {"trace_obj", Statement::label},
    {"ka", Statement::label},  // of materials, which some programs write here
    {"kd", Statement::label},
    {"ks", Statement::label},
    {"ns", Statement::label},
    {"illum", Statement::label},
    {"newmtl", Statement::label},
    {"call", Statement::other_file},
    {"csh", Statement::other_file},
};

class ObjReader {
  public:
    ObjReader(std::span<const std::byte> bytes, const std::string& name)
        : name_(name),
          text_(text_of(bytes), name, {.has_comments = true, .has_continuations = true}) {}

    PolygonSoup read() {
        while (text_.next_line()) {
            const std::string_view keyword = text_.word();
            obey(statement(keyword), keyword);
        }
        if (highest_corner_ > soup_.points.size())
            throw Error(name_ + ":" + std::to_string(highest_line_),
                        "found vertex " + std::to_string(highest_corner_) +
                            " as a corner, expected at most " +
                            std::to_string(soup_.points.size()) + ", the vertices of the file");
        note(weights_, "weights of vertices: ", " passed over, they do not move corners");
        note(thin_, "points and lines: ", " left out");
        note(free_form_, "free-form curves and surfaces: ", " left out");
        return std::move(soup_);
    }

  private:
    Statement statement(std::string_view keyword) const {
        for (const auto& [word, kind] : statements)
            if (is_keyword(keyword, word)) return kind;
        text_.fail(keyword, "a statement of OBJ files: v, f, vn, vt, g, o, ...");
    }

    void obey(Statement kind, std::string_view keyword) {
        switch (kind) {
            case Statement::vertex:
                return read_vertex();
            case Statement::face:
                return read_face();
            case Statement::attribute:
                return skip_words();
            case Statement::label:
                return;
            case Statement::thin:
                ++thin_;
                return skip_words();
            case Statement::free_form:
                ++free_form_;
                return skip_words();
            case Statement::other_file:
                text_.fail(keyword, "one file that holds all of the shape");
        }
    }

    void skip_words() {
        while (!text_.word().empty()) continue;
    }

    void read_vertex() {
        std::array<double, 7> values{};
        std::size_t count = 0;
        for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
            const auto value = finite_number(word);
            if (!value || count == values.size())
                text_.fail(word, "the coordinates of a vertex: x y z, with w, color or nothing");
            values[count++] = *value;
        }
        // x y z, x y z w, x y z r g b, and the last with a weight or opacity.
        if (count != 3 && count != 4 && count != 6 && count != 7)
            throw Error(text_.place(), "found a vertex of " + std::to_string(count) +
                                           " numbers, expected x y z, with w, color or nothing");
        if (count == 4 && values[3] != 1.0) ++weights_;
        soup_.points.emplace_back(values[0], values[1], values[2]);
    }

    void read_face() {
        const std::size_t begin = soup_.corners.size();
        for (std::string_view word = text_.word(); !word.empty(); word = text_.word())
            soup_.corners.push_back(corner(word));
        const std::size_t count = soup_.corners.size() - begin;
        if (count < 3)
            throw Error(text_.place(), "found a face of " + std::to_string(count) +
                                           " corners, expected three or more");
        soup_.end_face();
    }

    /// "7", "7/1", "7//3", "7/1/3": the vertex, counted from the first or, negative, back from
    /// here.
    std::uint32_t corner(std::string_view word) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        std::int64_t vertex = 0;
        if (!parse_whole_number(word.substr(0, slash), vertex) ||
            !is_attributes(word.substr(slash)))
            text_.fail(word, "a corner: vertex, vertex/texture, vertex//normal or all three");
        const auto count = static_cast<std::int64_t>(soup_.points.size());
        if (vertex == 0 || vertex < -count || vertex > most_vertices)
            text_.fail(word, "a vertex from 1 on, or from -1 to -" + std::to_string(count) +
                                 " back from here");
        if (vertex < 0) return static_cast<std::uint32_t>(count + vertex);
        // It may come later in the file.
        if (static_cast<std::uint64_t>(vertex) > highest_corner_) {
            highest_corner_ = static_cast<std::uint64_t>(vertex);
            highest_line_ = text_.line();
        }
        return static_cast<std::uint32_t>(vertex - 1);
    }

    /// "", "/1", "//3", "/1/3", and "/" and "//", which some programs write.
    static bool is_attributes(std::string_view rest) {
        for (int slashes = 0; !rest.empty(); ++slashes) {
            if (slashes == 2) return false;
            rest.remove_prefix(1);
            const std::size_t next = std::min(rest.find('/'), rest.size());
            std::int64_t index = 0;
            if (next > 0 && !parse_whole_number(rest.substr(0, next), index)) return false;
            rest.remove_prefix(next);
        }
        return true;
    }

    void note(std::size_t count, const char* what, const char* treatment) {
        if (count > 0) soup_.notes.push_back(what + std::to_string(count) + treatment);
    }

    static constexpr std::int64_t most_vertices = 0xffff'fffe;

    std::string name_;
    TextScanner text_;
    PolygonSoup soup_;
    std::uint64_t highest_corner_ = 0;
    std::size_t highest_line_ = 0;  ///< the first that names it
    std::size_t weights_ = 0, thin_ = 0, free_form_ = 0;
};

}  // namespace

PolygonSoup read_obj(std::span<const std::byte> bytes, const std::string& name) {
    return ObjReader(bytes, name).read();
}

}  // namespace dem::shapegen
