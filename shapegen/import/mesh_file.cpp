// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/mesh_file.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "formats/file_kind.hpp"
#include "formats/memory_map.hpp"
#include "shapegen/import/gltf_reader.hpp"
#include "shapegen/import/obj_reader.hpp"
#include "shapegen/import/off_reader.hpp"
#include "shapegen/import/ply_reader.hpp"
#include "shapegen/import/stl_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string_view>

namespace dem::shapegen {
namespace {

using Read = PolygonSoup (*)(std::span<const std::byte>, const std::string&);

/// The formats that are read here; glTF goes through a library.
struct Format {
    std::string_view extension;
    Read read;
};
constexpr std::array formats{Format{".stl", read_stl}, Format{".obj", read_obj},
                             Format{".ply", read_ply}, Format{".off", read_off},
                             Format{".gltf", nullptr}, Format{".glb", nullptr}};

const Format* format_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Format& format : formats)
        if (format.extension == extension) return &format;
    return nullptr;
}

void check_file(const std::filesystem::path& path) {
    if (!is_mesh_file(path))
        throw Error(path.string(), "found the extension " + in_quotes(path.extension().string()) +
                                       ", expected " + mesh_extensions());
    std::error_code error;
    if (const std::string found = no_file_at(path); !found.empty())
        throw Error(path.string(), found + ", expected a mesh");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (size == 0) throw Error(path.string(), "found an empty file, expected a mesh");
    // With fewer bytes no format holds more points than 32 bits count.
    constexpr std::uintmax_t largest = std::uintmax_t{16} << 30U;
    if (size > largest)
        throw Error(path.string(), "found " + std::to_string(size >> 30U) +
                                       " GB, expected a mesh of at most 16 GB");
}

PolygonSoup read(const std::filesystem::path& path, const Format& format) {
    if (format.read != nullptr) return format.read(MemoryMap(path, "mesh").bytes(), path.string());
    try {
        return read_gltf(path);
    } catch (const Error& error) {
        throw Error(path.string(), error.what());
    }
}

}  // namespace

std::string mesh_extensions() {
    std::string words;
    for (const Format& format : formats) {
        words += &format == &formats.front() ? "" : &format == &formats.back() ? " or " : ", ";
        words += format.extension;
    }
    return words;
}

bool is_mesh_file(const std::filesystem::path& path) {
    return format_of(path) != nullptr;
}

MeshFile read_mesh_file(const std::filesystem::path& path) {
    check_file(path);
    const Format& format = *format_of(path);
    MeshFile file{read(path, format), format.read == nullptr ? "m" : ""};
    if (file.soup.face_count() == 0) {
        std::string beside;
        for (const std::string& note : file.soup.notes) beside += "; " + note;
        throw Error(path.string(), "found " + std::to_string(file.soup.points.size()) +
                                       " points and no faces" + beside +
                                       ", expected faces of a surface");
    }
    // Of the triangles that they are cut into, 32 bits count the corners.
    if (3 * file.soup.corners.size() > 0xffff'ffff)
        throw Error(path.string(), "found " + std::to_string(file.soup.corners.size()) +
                                       " corners of faces, expected at most 1.4e9");
    return file;
}

}  // namespace dem::shapegen
