// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/surfaces.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/parts_hash.hpp"
#include "common/text.hpp"
#include "runtime/files/frames.hpp"
#include "runtime/files/hdf5_file.hpp"
#include "runtime/files/hdf5_reader.hpp"
#include "runtime/files/taken_up.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>

namespace dem::runtime {

namespace {

/// The tables of a frame and of a set of triangles in the order of its hash.
using TableNames = std::array<const char*, 2>;
constexpr TableNames frame_tables = {"points", "speed"};
constexpr TableNames topology_tables = {"triangles", "particle_id"};

std::uint64_t hash_of(std::initializer_list<std::span<const std::byte>> tables,
                      const std::string& entry) {
    PartsHash hash;
    for (const auto& table : tables) hash.add(table);
    hash.add(entry);
    return hash.value();
}

/// Throws Error unless the tables, and a frame's entry in the index, are as they were written.
void check_tables(const std::filesystem::path& path, const Hdf5Reader& file,
                  const std::string& group, const TableNames& names, const std::string& entry) {
    PartsHash hash;
    for (const char* name : names) hash.add(file.content(group + "/" + name));
    hash.add(entry);
    if (hash.value() == file.number(group, "hash")) return;
    throw Error(path.string(), "holds " + group + " that was changed after it was written");
}

/// The group of a set of triangles, as what is in it begins.
std::string topology(std::uint64_t number) {
    return "/topologies/" + std::to_string(number) + "/";
}

/// The number that the name of a frame or a set of triangles is.
std::uint64_t number(const std::filesystem::path& path, const std::string& name) {
    const auto value = whole_number(name);
    if (!value) throw Error(path.string(), "holds " + in_quotes(name) + " where numbers were");
    return *value;
}

}  // namespace

SurfaceWriter::SurfaceWriter(const std::filesystem::path& directory,
                             std::span<const ParticleTemplate> shapes, std::uint64_t frames)
    : path_(directory / "surfaces.h5"), index_(directory / "surfaces.xdmf", "surfaces") {
    for (const ParticleTemplate& shape : shapes) meshes_.push_back(shape.display_mesh);
    if (frames > 0 && std::filesystem::exists(path_)) {
        take_up_or_say_how(path_, "surfaces", [&] { take_up(frames); });
        return;
    }
    begin();
}

void SurfaceWriter::begin() {
    index_.begin({});
    PendingFile pending(path_);
    {
        JournaledFile disk(pending);
        Hdf5File file(disk);
        file.make_group("/topologies");
        file.make_group("/frames");
        file.close();
    }
    JournaledFile::forget(path_);
    pending.commit();
    disk_ = std::make_unique<JournaledFile>(path_);
}

void SurfaceWriter::take_up(std::uint64_t frames) {
    disk_ = std::make_unique<JournaledFile>(path_);
    std::vector<std::string> entries;
    std::vector<std::string> later;
    {
        const Hdf5Reader reader(path_);
        for (const std::string& name : reader.members("/frames")) {
            const std::string group = "/frames/" + name;
            if (number(path_, name) >= frames) {
                later.push_back(group);
                continue;
            }
            entries.push_back(reader.text(group, "xdmf"));
            check_tables(path_, reader, group, frame_tables, entries.back());
            topologies_ = reader.number(group, "topologies");
        }
        std::uint64_t kept = 0;
        for (const std::string& name : reader.members("/topologies")) {
            const std::string group = "/topologies/" + name;
            if (number(path_, name) >= topologies_) {
                later.push_back(group);
                continue;
            }
            check_tables(path_, reader, group, topology_tables, "");
            if (number(path_, name) + 1 == topologies_) last_hash_ = reader.number(group, "hash");
            ++kept;
        }
        if (kept != topologies_) {
            throw Error(path_.string(), "has " + std::to_string(kept) + " of " +
                                            std::to_string(topologies_) + " sets of triangles");
        }
    }
    index_.begin(entries);
    if (later.empty()) return;
    Hdf5File file(*disk_);
    for (const std::string& name : later) file.erase(name);
    file.close();
}

void SurfaceWriter::take_triangles(const Frame& frame) {
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> ids;
    std::uint64_t first = 0;
    for (std::size_t i = 0; i < frame.shape.size(); ++i) {
        const DisplayMesh& mesh = meshes_[frame.shape[i]];
        if (first + mesh.vertices.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw Error(path_.string(),
                        "the surfaces of all particles have more than 2^32 vertices, switch "
                        "surfaces off or use coarser display meshes");
        }
        const auto offset = static_cast<std::uint32_t>(first);
        for (const auto& t : mesh.triangles) {
            triangles.insert(triangles.end(), {offset + t[0], offset + t[1], offset + t[2]});
        }
        ids.insert(ids.end(), mesh.triangles.size(), frame.id[i]);
        first += mesh.vertices.size();
    }
    const std::uint64_t hash =
        hash_of({std::as_bytes(std::span(triangles)), std::as_bytes(std::span(ids))}, "");
    // After a file was taken up they may be those that it has.
    if (topologies_ == 0 || hash != last_hash_) {
        const std::string group = topology(topologies_++);
        Hdf5File file(*disk_);
        file.make_group(group);
        file.write(group + "triangles", triangles, 3);
        file.write(group + "particle_id", ids);
        file.describe(group, "hash", hash);
        file.close();
        last_hash_ = hash;
    }
    known_id_.assign(frame.id.begin(), frame.id.end());
    known_shape_.assign(frame.shape.begin(), frame.shape.end());
    vertices_ = first;
    const std::string place = "surfaces.h5:" + topology(topologies_ - 1);
    triangles_ = {place + "triangles", ids.size(), 3, "UInt", 4};
    triangle_id_ = {place + "particle_id", ids.size(), 1, "UInt", 4};
}

void SurfaceWriter::append(const Frame& frame, const std::string& frame_name) {
    if (triangles_.path.empty() || !std::ranges::equal(frame.id, known_id_) ||
        !std::ranges::equal(frame.shape, known_shape_)) {
        take_triangles(frame);
    }
    std::vector<float> points;
    std::vector<float> speeds;
    points.reserve(3 * vertices_);
    speeds.reserve(triangles_.rows);
    for (std::size_t i = 0; i < frame.shape.size(); ++i) {
        const DisplayMesh& mesh = meshes_[frame.shape[i]];
        const Mat3 rotation = frame.orientation[i].toRotationMatrix();
        for (const Vec3& v : mesh.vertices) {
            const Eigen::Vector3f p = (frame.position[i] + rotation * v).cast<float>();
            points.insert(points.end(), p.begin(), p.end());
        }
        speeds.insert(speeds.end(), mesh.triangles.size(),
                      static_cast<float>(frame.velocity[i].norm()));
    }
    const std::string group = "/frames/" + frame_name + "/";
    Hdf5File file(*disk_);
    file.make_group(group);
    file.write(group + "points", points, 3);
    file.write(group + "speed", speeds);
    const std::string place = "surfaces.h5:" + group;
    XdmfGrid grid;
    grid.time = frame.time;
    grid.cells = triangles_;
    grid.points = {place + "points", vertices_, 3, "Float", 4};
    grid.attributes = {
        {"particle_id", "Scalar", "Cell", triangle_id_},
        {"speed", "Scalar", "Cell", {place + "speed", speeds.size(), 1, "Float", 4}}};
    const std::string entry = index_.entry(grid);
    file.describe(group, "time", frame.time);
    file.describe(group, "topologies", topologies_);
    file.describe(
        group, "hash",
        hash_of({std::as_bytes(std::span(points)), std::as_bytes(std::span(speeds))}, entry));
    file.describe(group, "xdmf", entry);
    file.close();
    index_.append(entry);
}

}  // namespace dem::runtime
