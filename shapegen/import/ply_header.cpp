// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/ply_header.hpp"

#include "common/error.hpp"
#include "shapegen/import/text_scanner.hpp"

#include <algorithm>
#include <utility>

namespace dem::shapegen {
namespace {

using Type = PlyHeader::Type;
using Format = PlyHeader::Format;

constexpr std::pair<std::string_view, Type> types[] = {
    {"char", Type::int8},      {"uchar", Type::uint8},    {"short", Type::int16},
    {"ushort", Type::uint16},  {"int", Type::int32},      {"uint", Type::uint32},
    {"float", Type::float32},  {"double", Type::float64}, {"int8", Type::int8},
    {"uint8", Type::uint8},    {"int16", Type::int16},    {"uint16", Type::uint16},
    {"int32", Type::int32},    {"uint32", Type::uint32},  {"float32", Type::float32},
    {"float64", Type::float64}};

constexpr std::pair<std::string_view, Format> formats[] = {
    {"ascii", Format::ascii},
    {"binary_little_endian", Format::little_endian},
    {"binary_big_endian", Format::big_endian}};

class HeaderParser {
  public:
    HeaderParser(std::string_view text, const std::string& name)
        : text_(text), line_(text, name, {}) {}

    PlyHeader parse() {
        next_line();
        if (const std::string_view word = line_.word(); word != "ply")
            line_.fail(word, "ply as the first line");
        bool has_format = false;
        while (next_line()) {
            const std::string_view keyword = line_.word();
            if (keyword == "end_header") {
                if (!has_format) line_.fail(keyword, "a line that begins with format before");
                header_.size = data_begin();
                header_.lines = line_.line();
                return std::move(header_);
            }
            if (keyword == "format") {
                header_.format =
                    choose(formats, "ascii, binary_little_endian or binary_big_endian");
                has_format = true;
            } else if (keyword == "element") {
                add_element();
            } else if (keyword == "property") {
                add_property();
            } else if (keyword != "comment" && keyword != "obj_info") {
                line_.fail(keyword, "format, element, property, comment or end_header");
            }
        }
        line_.fail("", "end_header");
    }

  private:
    bool next_line() { return line_.next_line(); }

    /// The data begin behind the line end of end_header, one of the kind that ends the first line:
    /// a byte of binary data may look like the second half of one.
    std::size_t data_begin() const {
        std::size_t at = text_.size() - line_.bytes_left();
        while (at < text_.size() && text_[at] != '\n' && text_[at] != '\r') ++at;
        const std::size_t first = text_.find_first_of("\r\n");
        const bool is_crlf = text_.substr(first, 2) == "\r\n";
        return std::min(text_.size(), at + (is_crlf ? 2 : 1));
    }

    template <class Value, std::size_t count>
    Value choose(const std::pair<std::string_view, Value> (&choices)[count],
                 std::string_view expected) {
        const std::string_view word = line_.word();
        for (const auto& [name, value] : choices)
            if (name == word) return value;
        line_.fail(word, expected);
    }

    void add_element() {
        PlyHeader::Element element;
        element.name = line_.word();
        const std::int64_t count = line_.whole_number("an element's name and count");
        if (count < 0) line_.fail(std::to_string(count), "a count of zero or more");
        element.count = static_cast<std::uint64_t>(count);
        element.line = line_.line();
        header_.elements.push_back(std::move(element));
    }

    void add_property() {
        if (header_.elements.empty()) line_.fail("property", "an element before");
        constexpr std::string_view expected = "a type: char, uchar, short, ..., float, double";
        PlyHeader::Property property;
        std::string_view word = line_.word();
        if (word == "list") {
            property.count_type = choose(types, expected);
            if (!is_integer(*property.count_type))
                line_.fail("list", "a list with a count of an integer type");
            word = line_.word();
        }
        const auto* const type = std::find_if(std::begin(types), std::end(types),
                                              [&](const auto& t) { return t.first == word; });
        if (type == std::end(types)) line_.fail(word, expected);
        property.type = type->second;
        property.name = line_.word();
        if (property.name.empty()) line_.fail("", "the name of a property");
        header_.elements.back().properties.push_back(std::move(property));
    }

    std::string_view text_;
    TextScanner line_;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyHeader::Type type) {
    switch (type) {
        case Type::int8:
        case Type::uint8:
            return 1;
        case Type::int16:
        case Type::uint16:
            return 2;
        case Type::int32:
        case Type::uint32:
        case Type::float32:
            return 4;
        case Type::float64:
            return 8;
    }
    return 8;
}

bool is_integer(PlyHeader::Type type) {
    return type != Type::float32 && type != Type::float64;
}

std::optional<std::size_t> PlyHeader::Element::find(std::string_view property) const {
    for (std::size_t p = 0; p < properties.size(); ++p)
        if (properties[p].name == property) return p;
    return std::nullopt;
}

std::uint64_t PlyHeader::Element::least_size(Format format) const {
    std::uint64_t size = 0;
    for (const Property& property : properties)
        // In text a digit and a blank.
        size += format == Format::ascii ? 2 : size_of(property.count_type.value_or(property.type));
    return size;
}

PlyHeader PlyHeader::parse(std::string_view text, const std::string& name) {
    return HeaderParser(text, name).parse();
}

}  // namespace dem::shapegen
