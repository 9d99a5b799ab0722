// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/mesh_file.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <memory>
#include <string_view>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace dem {
namespace {

constexpr std::array<std::string_view, 6> extensions{".stl", ".obj",  ".ply",
                                                     ".off", ".gltf", ".glb"};

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

/// Collects the warnings of assimp, which otherwise read past a broken line without a word.
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

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void check_file(const std::filesystem::path& path) {
    if (!is_mesh_file(path))
        throw Error(path.string(), "found the extension '" + lower_extension(path) +
                                       "', expected .stl, .obj, .ply, .off, .gltf or .glb");
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw Error(path.string(), "found no such file, expected a mesh");
    if (std::filesystem::file_size(path, error) == 0)
        throw Error(path.string(), "found an empty file, expected a mesh");
}

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

    TriangleSoup soup;
    std::size_t ignored = 0;  ///< points and lines

  private:
    void append(const aiMesh& mesh, const aiMatrix4x4& to_scene) {
        const auto shift = static_cast<std::uint32_t>(soup.points.size());
        soup.points.reserve(soup.points.size() + mesh.mNumVertices);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D p = to_scene * mesh.mVertices[v];
            soup.points.emplace_back(p.x, p.y, p.z);
        }
        soup.triangles.reserve(soup.triangles.size() + mesh.mNumFaces);
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            const bool in_range =
                std::all_of(face.mIndices, face.mIndices + face.mNumIndices,
                            [&mesh](unsigned index) { return index < mesh.mNumVertices; });
            if (!in_range)
                throw Error("face " + std::to_string(f + 1),
                            "found a corner that does not exist, expected one of " +
                                std::to_string(mesh.mNumVertices));
            if (face.mNumIndices == 3) {
                soup.triangles.push_back(
                    {face.mIndices[0] + shift, face.mIndices[1] + shift, face.mIndices[2] + shift});
            } else {
                ++ignored;
            }
        }
    }

    const aiScene& scene_;
};

void check_finite(const TriangleSoup& soup) {
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& [i, j, k] = soup.triangles[t];
        const bool is_finite =
            soup.points[i].allFinite() && soup.points[j].allFinite() && soup.points[k].allFinite();
        if (!is_finite && count++ == 0) first = t;
    }
    if (count > 0)
        throw Error("triangle " + std::to_string(first + 1),
                    "found " + std::to_string(count) +
                        " triangles with a corner that is not a finite number, expected none");
}

/// assimp reads on after a facet of an STL file that has two or four corners; from there on the
/// corners of the triangles are mixed up.
void check_facets(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        if (warning.find("facet") != std::string::npos && warning.starts_with("STL"))
            throw Error("found '" + warning + "', expected three corners in every facet");
}

/// assimp counts the comments of an OFF file as faces and drops as many at the end.
std::string without_comments(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text;
    for (std::string line; std::getline(file, line);) {
        line.erase(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") != std::string::npos) text += line + '\n';
    }
    return text;
}

const aiScene* read_scene(Assimp::Importer& importer, const std::filesystem::path& path,
                          const std::string& extension) {
    if (extension != ".off") return importer.ReadFile(path.string(), 0);
    const std::string text = without_comments(path);
    return importer.ReadFileFromMemory(text.data(), text.size(), 0, "off");
}

std::string reason(const Assimp::Importer& importer) {
    const std::string text = importer.GetErrorString();
    if (text.find("STL storage representation") != std::string::npos)
        return "neither text that begins with solid nor a size that fits the number of faces";
    return '\'' + one_line(text) + '\'';
}

MeshFile read(const std::filesystem::path& path, const std::string& extension) {
    const WarningLog log;
    Assimp::Importer importer;
    const aiScene* scene = read_scene(importer, path, extension);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw Error("found " + reason(importer) + ", expected a mesh as " + extension +
                    " describes it");
    check_facets(log.lines());
    const bool has_polygons = std::any_of(
        scene->mMeshes, scene->mMeshes + scene->mNumMeshes,
        [](const aiMesh* mesh) { return (mesh->mPrimitiveTypes & aiPrimitiveType_POLYGON) != 0; });
    if (has_polygons) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    Collector collector(*scene);
    collector.append(*scene->mRootNode, aiMatrix4x4());
    MeshFile file;
    file.soup = std::move(collector.soup);
    file.notes = log.lines();
    if (collector.ignored > 0)
        file.notes.push_back(std::to_string(collector.ignored) + " points and lines ignored");
    if (extension == ".gltf" || extension == ".glb") file.unit = "m";
    return file;
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& path) {
    return std::find(extensions.begin(), extensions.end(), lower_extension(path)) !=
           extensions.end();
}

MeshFile read_mesh_file(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    check_file(path);
    try {
        MeshFile file = read(path, extension);
        if (file.soup.triangles.empty())
            throw Error("found no triangles, expected a closed surface");
        check_finite(file.soup);
        return file;
    } catch (const Error& error) {
        throw Error(path.string(), error.what());
    }
}

}  // namespace dem
