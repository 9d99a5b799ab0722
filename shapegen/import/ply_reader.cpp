// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/ply_reader.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "shapegen/import/byte_reader.hpp"
#include "shapegen/import/ply_header.hpp"
#include "shapegen/import/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace dem::shapegen {
namespace {

using Element = PlyHeader::Element;
using Property = PlyHeader::Property;
using Type = PlyHeader::Type;

/// The numbers of a text file, a line for each element.
class TextValues {
  public:
    TextValues(std::string_view data, const std::string& name, std::size_t first_line)
        : text_(data, name, {}, first_line) {}

    bool begin_row() { return text_.next_line(); }
    void end_row() {
        if (const std::string_view word = text_.word(); !word.empty())
            text_.fail(word, "the end of the line: the element has no more properties");
    }
    double number(Type /*type*/) { return text_.number("a coordinate"); }
    std::int64_t whole_number(Type /*type*/) { return text_.whole_number("a whole number"); }
    void skip(Type /*type*/) {
        if (text_.word().empty()) fail("the end of the line", "a number for each property");
    }
    std::uint64_t room(Type /*type*/) const { return text_.bytes_left(); }
    /// What follows the last element.
    bool has_more() { return text_.next_line(); }
    std::string place() const { return text_.place(); }
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw Error(place(), "found " + found + ", expected " + expected);
    }

  private:
    TextScanner text_;
};

/// The numbers of a binary file.
class BinaryValues {
  public:
    BinaryValues(std::span<const std::byte> bytes, std::size_t begin, const std::string& name,
                 std::endian order)
        : bytes_(bytes), at_(begin), name_(name), order_(order) {}

    bool begin_row() const { return at_ < bytes_.size(); }
    void end_row() const {}
    double number(Type type) {
        if (type == Type::float32) return static_cast<double>(read<float>());
        if (type == Type::float64) return read<double>();
        return static_cast<double>(whole_number(type));
    }
    std::int64_t whole_number(Type type) {
        switch (type) {
            case Type::int8:
                return read<std::int8_t>();
            case Type::uint8:
                return read<std::uint8_t>();
            case Type::int16:
                return read<std::int16_t>();
            case Type::uint16:
                return read<std::uint16_t>();
            case Type::int32:
                return read<std::int32_t>();
            case Type::uint32:
                return read<std::uint32_t>();
            case Type::float32:
            case Type::float64:
                break;
        }
        fail("indices that are no whole numbers", "an integer type");
    }
    void skip(Type type) {
        require(size_of(type));
        at_ += size_of(type);
    }
    /// How many numbers there is room for.
    std::uint64_t room(Type type) const { return (bytes_.size() - at_) / size_of(type); }
    /// Line ends and zeros behind the last element do no harm.
    bool has_more() const {
        for (std::size_t k = at_; k < bytes_.size(); ++k) {
            const auto c = static_cast<char>(bytes_[k]);
            if (c != '\0' && c != '\n' && c != '\r' && c != ' ') return true;
        }
        return false;
    }
    std::string place() const { return name_ + ": byte " + std::to_string(at_); }
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw Error(place(), "found " + found + ", expected " + expected);
    }

  private:
    void require(std::size_t size) const {
        if (bytes_.size() - at_ < size) fail("the end", "more numbers");
    }
    template <class Number>
    Number read() {
        require(sizeof(Number));
        const auto value = read_as<Number>(bytes_.data() + at_, order_);
        at_ += sizeof(Number);
        return value;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_;
    std::string name_;
    std::endian order_;
};

/// The elements behind the header, in its order.
template <class Values>
class BodyReader {
  public:
    BodyReader(const PlyHeader& header, Values values)
        : header_(header), values_(std::move(values)) {}

    PolygonSoup read() {
        for (const Element& element : header_.elements)
            if (element.name == "vertex") vertices_ = element.count;
        for (const Element& element : header_.elements) read(element);
        if (values_.has_more())
            values_.fail("more data",
                         "the end of the file after the last element that the header "
                         "counts");
        return std::move(soup_);
    }

  private:
    using Read = void (BodyReader::*)(const Element&);

    void read(const Element& element) {
        Read read_one = &BodyReader::skip_row;
        if (element.name == "vertex") {
            for (std::size_t axis = 0; axis < 3; ++axis)
                coordinates_[axis] = element.find(std::array{"x", "y", "z"}[axis]);
            read_one = &BodyReader::read_vertex;
            soup_.points.reserve(element.count);
        } else if (element.name == "face" || element.name == "tristrips") {
            indices_ = element.find("vertex_indices");
            if (!indices_) indices_ = element.find("vertex_index");
            read_one = element.name == "face" ? &BodyReader::read_face : &BodyReader::read_strip;
        } else if (element.count > 0) {
            soup_.notes.push_back("elements " + in_quotes(element.name) + ": " +
                                  std::to_string(element.count) + " left out");
            if (element.properties.empty()) return;
        }
        for (std::uint64_t row = 0; row < element.count; ++row) {
            if (!values_.begin_row())
                values_.fail("the end", in_quotes(element.name) + " " + std::to_string(row + 1) +
                                            " of " + std::to_string(element.count));
            (this->*read_one)(element);
            values_.end_row();
        }
    }

    void skip(const Property& property) {
        if (!property.count_type) return values_.skip(property.type);
        for (std::uint64_t left = list_size(property); left > 0; --left)
            values_.skip(property.type);
    }

    void skip_row(const Element& element) {
        for (const Property& property : element.properties) skip(property);
    }

    /// Length of a list that is read next; its numbers are in the file.
    std::uint64_t list_size(const Property& list) {
        const std::int64_t size = values_.whole_number(*list.count_type);
        const std::uint64_t room = values_.room(list.type);
        if (size < 0 || static_cast<std::uint64_t>(size) > room)
            values_.fail("a list of " + std::to_string(size) + " numbers",
                         "at most the " + std::to_string(room) + " that fit the file");
        return static_cast<std::uint64_t>(size);
    }

    void read_vertex(const Element& element) {
        Vec3 point;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const Property& property = element.properties[p];
            const auto axis = std::find(coordinates_.begin(), coordinates_.end(), p);
            if (axis == coordinates_.end()) {
                skip(property);
                continue;
            }
            const double x = values_.number(property.type);
            if (!std::isfinite(x)) values_.fail("a coordinate that is not finite", "a number");
            point[axis - coordinates_.begin()] = x;
        }
        soup_.points.push_back(point);
    }

    /// A row whose list of vertices `read_list` reads.
    template <class ReadList>
    void read_row(const Element& element, const ReadList& read_list) {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (p == indices_)
                read_list(element.properties[p]);
            else
                skip(element.properties[p]);
        }
    }

    std::uint32_t corner(std::int64_t index) const {
        if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_)
            values_.fail("vertex " + std::to_string(index) + " as a corner",
                         "one of the " + std::to_string(vertices_) + " vertices, counted from 0");
        return static_cast<std::uint32_t>(index);
    }

    void read_face(const Element& element) {
        read_row(element, [this](const Property& list) {
            const std::uint64_t size = list_size(list);
            if (size < 3)
                values_.fail("a face of " + std::to_string(size) + " corners", "three or more");
            for (std::uint64_t k = 0; k < size; ++k)
                soup_.corners.push_back(corner(values_.whole_number(list.type)));
            soup_.end_face();
        });
    }

    /// Every corner from the third on makes a triangle with the two before; -1 begins anew. Every
    /// other triangle turns the other way round.
    void read_strip(const Element& element) {
        read_row(element, [this](const Property& list) {
            std::array<std::uint32_t, 2> last{};
            std::size_t length = 0;
            for (std::uint64_t left = list_size(list); left > 0; --left) {
                const std::int64_t index = values_.whole_number(list.type);
                if (index == -1) {
                    length = 0;
                    continue;
                }
                const std::uint32_t next = corner(index);
                if (length >= 2) {
                    const bool is_even = length % 2 == 0;
                    soup_.corners.insert(soup_.corners.end(),
                                         {last[is_even ? 0 : 1], last[is_even ? 1 : 0], next});
                    soup_.end_face();
                }
                last = {last[1], next};
                ++length;
            }
        });
    }

    const PlyHeader& header_;
    Values values_;
    PolygonSoup soup_;
    std::uint64_t vertices_ = 0;
    std::array<std::optional<std::size_t>, 3> coordinates_;  ///< among the properties
    std::optional<std::size_t> indices_;
};

/// Before anything else is done: elements have the properties that they need, and fit the file.
void check(const PlyHeader& header, std::size_t data_size, const std::string& name) {
    constexpr std::uint64_t most_vertices = 0xffff'fffe;
    std::size_t vertex_elements = 0;
    for (const Element& element : header.elements) {
        const std::string place = name + ":" + std::to_string(element.line);
        const std::uint64_t size = element.least_size(header.format);
        const std::uint64_t most = size > 0 ? (data_size + 1) / size : element.count;
        if (element.count > most || element.count > most_vertices)
            throw Error(place, "found " + std::to_string(element.count) + " " +
                                   in_quotes(element.name) +
                                   " promised, expected no more than fit the file (" +
                                   std::to_string(most) + ")");
        const auto require = [&](std::string_view property, bool is_list) {
            const auto index = element.find(property);
            if (!index || element.properties[*index].count_type.has_value() != is_list ||
                (is_list && !is_integer(element.properties[*index].type)))
                throw Error(place, "found no property " + in_quotes(property) + " of " +
                                       in_quotes(element.name) + " that is a " +
                                       (is_list ? "list of whole numbers" : "number") +
                                       ", expected one");
        };
        if (element.name == "vertex") {
            for (const char* axis : {"x", "y", "z"}) require(axis, false);
            if (++vertex_elements > 1)
                throw Error(place, "found a second element 'vertex', expected one");
        }
        if (element.count > 0 && (element.name == "face" || element.name == "tristrips"))
            require(element.find("vertex_index") ? "vertex_index" : "vertex_indices", true);
    }
}

}  // namespace

PolygonSoup read_ply(std::span<const std::byte> bytes, const std::string& name) {
    const std::string_view text = text_of(bytes);
    const PlyHeader header = PlyHeader::parse(text, name);
    const std::string_view data = text.substr(header.size);
    check(header, data.size(), name);
    if (header.format == PlyHeader::Format::ascii)
        return BodyReader(header, TextValues(data, name, header.lines + 1)).read();
    const std::endian order =
        header.format == PlyHeader::Format::little_endian ? std::endian::little : std::endian::big;
    return BodyReader(header, BinaryValues(bytes, bytes.size() - data.size(), name, order)).read();
}

}  // namespace dem::shapegen
