// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/gltf_reader.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "shapegen/import/child_process.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/scene.h>

namespace dem::shapegen {
namespace {

/// Triangles as they pass the pipe, then the notes, a line each.
struct Counts {
    std::uint64_t points = 0, corners = 0;
};

/// The first line, not longer than a message bears, without the severity and thread that assimp
/// puts in front.
std::string one_line(std::string_view text) {
    if (const auto thread = text.find("T0: "); thread != std::string_view::npos)
        text.remove_prefix(thread + 4);
    std::string line(text.substr(0, text.find_first_of("\r\n")));
    if (constexpr std::size_t longest = 100; line.size() > longest)
        line.replace(longest, std::string::npos, " ...");
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return line;
}

/// Collects the warnings of assimp.
class WarningLog {
  public:
    WarningLog() {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        stream_ = new Stream;  // owned by the logger once attached
        Assimp::DefaultLogger::get()->attachStream(stream_,
                                                   Assimp::Logger::Warn | Assimp::Logger::Err);
    }
    ~WarningLog() { Assimp::DefaultLogger::kill(); }
    WarningLog(const WarningLog&) = delete;
    WarningLog& operator=(const WarningLog&) = delete;

    const std::vector<std::string>& lines() const { return stream_->lines; }

  private:
    struct Stream : Assimp::LogStream {
        void write(const char* message) override {
            std::string line = one_line(message);
            if (std::find(lines.begin(), lines.end(), line) == lines.end())
                lines.push_back(std::move(line));
        }
        std::vector<std::string> lines;
    };
    Stream* stream_;
};

/// Puts the meshes of a scene together, each as often and where its nodes say.
class Collector {
  public:
    explicit Collector(const aiScene& scene) : scene_(scene) {}

    void append(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 to_scene = parent * node.mTransformation;
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            append(*scene_.mMeshes[node.mMeshes[m]], to_scene);
        for (unsigned c = 0; c < node.mNumChildren; ++c) append(*node.mChildren[c], to_scene);
    }

    PolygonSoup soup;
    std::size_t ignored = 0;  ///< points and lines

  private:
    void append(const aiMesh& mesh, const aiMatrix4x4& to_scene) {
        const auto shift = static_cast<std::uint32_t>(soup.points.size());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D p = to_scene * mesh.mVertices[v];
            soup.points.emplace_back(p.x, p.y, p.z);
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) {
                ++ignored;
                continue;
            }
            for (unsigned k = 0; k < 3; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices)
                    throw Error("found a corner that does not exist, expected one of " +
                                std::to_string(mesh.mNumVertices));
                soup.corners.push_back(face.mIndices[k] + shift);
            }
        }
    }

    const aiScene& scene_;
};

void append(std::string& bytes, const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

/// In the child: all that the file holds, as bytes.
std::string packed_scene(const std::filesystem::path& path) {
    const WarningLog log;
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw Error("found " + in_quotes(one_line(importer.GetErrorString())) +
                    ", expected a mesh as glTF describes it");
    Collector collector(*scene);
    collector.append(*scene->mRootNode, aiMatrix4x4());
    const PolygonSoup& soup = collector.soup;
    const Counts counts{soup.points.size(), soup.corners.size()};
    std::string bytes;
    append(bytes, &counts, sizeof counts);
    for (const Vec3& p : soup.points) append(bytes, p.data(), 3 * sizeof(double));
    append(bytes, soup.corners.data(), soup.corners.size() * sizeof(std::uint32_t));
    for (const std::string& line : log.lines()) bytes += line + '\n';
    if (collector.ignored > 0)
        bytes += "points and lines: " + std::to_string(collector.ignored) + " left out\n";
    return bytes;
}

/// The numbers that come next in an answer of the child.
class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

    template <class Number>
    void read(Number* numbers, std::uint64_t count) {
        static_assert(std::is_trivially_copyable_v<Number>);
        if (count > bytes_.size() / sizeof(Number))
            throw Error("the program that reads it gives half an answer");
        if (count == 0) return;  // of nothing there may be no address
        std::memcpy(numbers, bytes_.data(), count * sizeof(Number));
        bytes_.remove_prefix(count * sizeof(Number));
    }
    std::string_view rest() const { return bytes_; }

  private:
    std::string_view bytes_;
};

PolygonSoup unpacked(std::string_view bytes) {
    Unpacker unpacker(bytes);
    Counts counts;
    unpacker.read(&counts, 1);
    if (counts.points > bytes.size() || counts.corners > bytes.size() || counts.corners % 3 != 0)
        throw Error("the program that reads it gives a wrong answer");
    PolygonSoup soup;
    soup.points.resize(counts.points);
    for (Vec3& point : soup.points) unpacker.read(point.data(), 3);
    soup.corners.resize(counts.corners);
    unpacker.read(soup.corners.data(), counts.corners);
    for (std::size_t end = 3; end <= soup.corners.size(); end += 3) soup.face_ends.push_back(end);
    for (std::string_view notes = unpacker.rest(); !notes.empty();) {
        const std::size_t end = std::min(notes.find('\n'), notes.size() - 1);
        soup.notes.emplace_back(notes.substr(0, end));
        notes.remove_prefix(end + 1);
    }
    for (const std::uint32_t corner : soup.corners) {
        if (corner >= soup.points.size())
            throw Error("found a corner that does not exist, expected one of " +
                        std::to_string(soup.points.size()));
        if (!soup.points[corner].allFinite())
            throw Error("found a corner that is not a finite number, expected coordinates");
    }
    return soup;
}

}  // namespace

PolygonSoup read_gltf(const std::filesystem::path& path) {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    const std::size_t megabytes = unknown ? 0 : static_cast<std::size_t>(size >> 20U);
    // Hundred times the memory of any file that was tried, ten times the time.
    const ChildLimits limits{static_cast<unsigned>(10 + megabytes),
                             (std::size_t{1} << 30U) + 100 * (megabytes << 20U)};
    return unpacked(in_child_process([&path] { return packed_scene(path); }, limits));
}

}  // namespace dem::shapegen
