// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/frames.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/parts_hash.hpp"
#include "runtime/files/frame_tables.hpp"
#include "runtime/files/hdf5_file.hpp"
#include "runtime/files/hdf5_reader.hpp"
#include "runtime/files/taken_up.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

namespace dem::runtime {

namespace {

constexpr std::uint64_t frames_layout = 1;  // raised when a reader would have to change

std::span<const double> numbers(std::span<const Vec3> vectors) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return {vectors.empty() ? nullptr : vectors.front().data(), 3 * vectors.size()};
}

std::vector<double> wxyz(std::span<const Quat> orientations) {
    std::vector<double> values;
    values.reserve(4 * orientations.size());
    for (const Quat& q : orientations) values.insert(values.end(), {q.w(), q.x(), q.y(), q.z()});
    return values;
}

/// All display meshes behind one another: shape k has the vertices [first_vertex[k],
/// first_vertex[k + 1]), and its triangles count from its own first vertex.
struct MeshTables {
    std::vector<double> vertices;
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint64_t> first_vertex = {0};
    std::vector<std::uint64_t> first_triangle = {0};

    explicit MeshTables(std::span<const ParticleTemplate> shapes) {
        for (const ParticleTemplate& shape : shapes) {
            for (const Vec3& v : shape.display_mesh.vertices) {
                vertices.insert(vertices.end(), v.begin(), v.end());
            }
            for (const auto& t : shape.display_mesh.triangles) {
                triangles.insert(triangles.end(), t.begin(), t.end());
            }
            first_vertex.push_back(vertices.size() / 3);
            first_triangle.push_back(triangles.size() / 3);
        }
    }
};

void write_shapes(Hdf5File& file, std::span<const ParticleTemplate> shapes) {
    const MeshTables meshes(shapes);
    std::vector<std::string> names;
    std::vector<std::string> kinds;
    std::vector<double> volumes;
    std::vector<double> radii;
    for (const ParticleTemplate& shape : shapes) {
        names.push_back(shape.name);
        kinds.push_back(kind_name(shape));
        volumes.push_back(shape.mass_properties.volume);
        radii.push_back(shape.bounding_radius);
    }
    file.make_group("/shapes");
    file.write("/shapes/name", names);
    file.write("/shapes/kind", kinds);
    file.write("/shapes/volume", volumes);
    file.write("/shapes/bounding_radius", radii);
    file.write("/shapes/vertices", meshes.vertices, 3);
    file.write("/shapes/triangles", meshes.triangles, 3);
    file.write("/shapes/first_vertex", meshes.first_vertex);
    file.write("/shapes/first_triangle", meshes.first_triangle);
    file.describe("/shapes/vertices", "units", "m");
    file.describe("/shapes/volume", "units", "m^3");
    file.describe("/shapes/bounding_radius", "units", "m");
}

/// The tables of a frame in the order of its hash.
constexpr std::array<const char*, 9> table_names = {
    "position", "id",    "orientation",  "velocity", "angular_velocity",
    "shape",    "group", "coordination", "force"};

XdmfGrid write_tables(FrameTables& tables, const Frame& frame) {
    XdmfGrid grid;
    grid.time = frame.time;
    grid.points = tables.add("position", numbers(frame.position), 3, "m");
    auto& attributes = grid.attributes;
    attributes = {
        {"id", "Scalar", "Node", tables.add("id", frame.id)},
        {"orientation", "Matrix", "Node",
         tables.add("orientation", wxyz(frame.orientation), 4, "1")},
        {"velocity", "Vector", "Node", tables.add("velocity", numbers(frame.velocity), 3, "m/s")},
        {"angular_velocity", "Vector", "Node",
         tables.add("angular_velocity", numbers(frame.angular_velocity), 3, "rad/s")},
        {"shape", "Scalar", "Node", tables.add("shape", frame.shape)},
        {"group", "Scalar", "Node", tables.add("group", frame.group)}};
    if (!frame.coordination.empty()) {
        attributes.push_back(
            {"coordination", "Scalar", "Node", tables.add("coordination", frame.coordination)});
    }
    if (!frame.force.empty()) {
        attributes.push_back(
            {"force", "Vector", "Node", tables.add("force", numbers(frame.force), 3, "N")});
    }
    return grid;
}

/// What is the same in all frames.
void write_beginning(JournaledFile& disk, const FrameContext& context,
                     std::span<const ParticleTemplate> shapes) {
    Hdf5File file(disk);
    file.describe("/", "layout", frames_layout);
    file.describe("/", "program", std::string_view("ShapeDEM " DEM_VERSION));
    file.describe("/", "case", context.case_path);
    file.describe("/", "units", std::string_view("SI, world frame, quaternions w x y z"));
    write_shapes(file, shapes);
    file.write("/groups", context.groups);
    file.make_group("/frames");
    file.make_group("/points");
    file.close();
}

std::string frame_name(std::uint64_t number) {
    char text[24];
    std::snprintf(text, sizeof text, "%08llu", static_cast<unsigned long long>(number));
    return text;
}

/// Throws Error unless the frame is as it was written.
void check_frame(const std::filesystem::path& path, const Hdf5Reader& file,
                 const std::string& group) {
    const std::vector<std::string> members = file.members(group);
    PartsHash hash;
    for (const char* name : table_names) {
        if (std::ranges::find(members, name) == members.end()) continue;
        hash.add(file.content(group + "/" + name));
    }
    hash.add(file.text(group, "xdmf"));
    if (hash.value() == file.number(group, "hash")) return;
    throw Error(path.string(), "has a frame " + group + " that was changed after it was written");
}

}  // namespace

FrameWriter::FrameWriter(const std::filesystem::path& directory, const FrameContext& context,
                         std::span<const ParticleTemplate> shapes)
    : path_(directory / "frames.h5"), index_(directory / "frames.xdmf", "particles") {
    begin(context, shapes);
    begin_others(directory, context, shapes);
}

FrameWriter::FrameWriter(const std::filesystem::path& directory, const FrameContext& context,
                         std::span<const ParticleTemplate> shapes, std::uint64_t frames)
    : path_(directory / "frames.h5"),
      count_(frames),
      index_(directory / "frames.xdmf", "particles") {
    if (frames == 0 || !std::filesystem::exists(path_)) {
        begin(context, shapes);
    } else {
        take_up_or_say_how(path_, "frames", [this] { take_up(); });
    }
    begin_others(directory, context, shapes);
}

/// The files beside frames.h5, which have as many frames.
void FrameWriter::begin_others(const std::filesystem::path& directory, const FrameContext& context,
                               std::span<const ParticleTemplate> shapes) {
    if (context.surfaces) surfaces_ = std::make_unique<SurfaceWriter>(directory, shapes, count_);
    if (context.contacts)
        contacts_ = std::make_unique<ContactWriter>(directory, context.walls, count_);
    if (context.wall_contacts != nullptr)
        wall_contacts_ =
            std::make_unique<WallContactWriter>(directory, *context.wall_contacts, count_);
}

void FrameWriter::begin(const FrameContext& context, std::span<const ParticleTemplate> shapes) {
    index_.begin({});
    PendingFile pending(path_);
    {
        JournaledFile disk(pending);
        write_beginning(disk, context, shapes);
    }
    JournaledFile::forget(path_);
    pending.commit();
    disk_ = std::make_unique<JournaledFile>(path_);
}

void FrameWriter::take_up() {
    disk_ = std::make_unique<JournaledFile>(path_);
    std::vector<std::string> entries;
    std::vector<std::string> later;
    std::string last;  // "": begun anew by another resumed run, and no frame since
    {
        const Hdf5Reader file(path_);
        // The last table of point numbers serves the next frames, too.
        for (const std::string& name : file.members("/points")) {
            const std::string table = "/points/" + name;
            if (name >= frame_name(count_)) {
                later.push_back(table);
            } else {
                points_ = {"frames.h5:" + table, file.size(table), 1, "UInt", 4};
            }
        }
        for (const std::string& name : file.members("/frames")) {
            const std::string group = "/frames/" + name;
            if (name >= frame_name(count_)) {
                later.push_back(group);
            } else {
                check_frame(path_, file, group);
                entries.push_back(file.text(group, "xdmf"));
                last = name;
            }
        }
    }
    if (last != frame_name(count_ - 1) && !last.empty()) {
        throw Error(path_.string(), "ends with frame " + last + " of " + std::to_string(count_));
    }
    index_.begin(entries);
    if (later.empty()) return;
    Hdf5File file(*disk_);
    for (const std::string& name : later) file.erase(name);
    file.close();
}

// Readers of XDMF need the number of each point spelled out: Xdmf3 aborts without.
XdmfTable FrameWriter::points(Hdf5File& file, std::size_t count) const {
    if (points_.rows == count && !points_.path.empty()) return points_;
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    const std::string name = "/points/" + frame_name(count_);
    file.write(name, numbers);
    return {"frames.h5:" + name, count, 1, "UInt", 4};
}

void FrameWriter::append(const Frame& frame) {
    const std::string name = frame_name(count_);
    const std::string group = "/frames/" + name + "/";
    Hdf5File file(*disk_);
    FrameTables tables(file, group);
    XdmfGrid grid = write_tables(tables, frame);
    grid.cells = points(file, frame.position.size());
    file.describe(group, "time", frame.time);
    file.describe(group, "step", frame.step);
    file.describe(group, "count", std::uint64_t{frame.position.size()});
    const std::string entry = index_.entry(grid);
    file.describe(group, "hash", tables.hash(entry));
    file.describe(group, "xdmf", entry);
    file.close();
    points_ = grid.cells;
    ++count_;
    index_.append(entry);
    if (surfaces_) surfaces_->append(frame, name);
    if (contacts_) contacts_->append(*frame.contacts, name);
    if (wall_contacts_) wall_contacts_->append(*frame.wall_contacts, name);
}

void FrameWriter::secure() {
    disk_->secure();
    if (surfaces_) surfaces_->secure();
    if (contacts_) contacts_->secure();
    if (wall_contacts_) wall_contacts_->secure();
}

}  // namespace dem::runtime
