// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/frames.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "runtime/files/hdf5_file.hpp"
#include "runtime/files/hdf5_reader.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <csignal>
#include <numeric>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>

namespace dem::runtime {
namespace {

/// Random states of `count` particles and the frame that shows them.
struct State {
    std::vector<std::uint32_t> id, shape, group, coordination;
    std::vector<Vec3> position, velocity, angular_velocity, force;
    std::vector<Quat> orientation;

    State(std::size_t count, std::uint64_t seed) {
        for (std::uint32_t i = 0; i < count; ++i) {
            Random random(seed, i);
            id.push_back(i);
            shape.push_back(i % 2);
            group.push_back(0);
            coordination.push_back(i % 7);
            position.emplace_back(random.direction());
            velocity.emplace_back(random.direction());
            angular_velocity.emplace_back(random.direction());
            force.emplace_back(random.direction());
            orientation.push_back(random.orientation());
        }
    }
    Frame frame(double time) const {
        return {time,
                static_cast<std::uint64_t>(time * 1000),
                id,
                position,
                orientation,
                velocity,
                angular_velocity,
                shape,
                group,
                coordination,
                force};
    }
};

/// The numbers of one table of a file.
std::vector<double> table(const std::filesystem::path& path, const std::string& name) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0) return {};
    const hid_t data = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    std::vector<double> values;
    if (data >= 0) {
        const hid_t space = H5Dget_space(data);
        values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        if (H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
            values.clear();
        }
        H5Sclose(space);
        H5Dclose(data);
    }
    H5Fclose(file);
    return values;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        ++count;
    }
    return count;
}

class Frames : public TemporaryFolder {
  protected:
    const std::vector<ParticleTemplate> shapes_ = {sample::sr_sphere(), sample::sphere(1e-3)};
    const FrameContext context_ = {"case.ini", {"beads"}, false};
};

TEST_F(Frames, EveryNumberOfEveryFrameReadsBackWhileParticlesAreAdded) {
    std::vector<State> states;
    {
        FrameWriter writer(folder_, context_, shapes_);
        // Small tables are stored whole, large ones in compressed chunks.
        for (const std::size_t count : {0U, 1U, 100U, 5000U, 40000U}) {
            states.emplace_back(count, count);
            writer.append(states.back().frame(0.1 * static_cast<double>(states.size())));
        }
    }
    for (std::size_t k = 1; k < states.size(); ++k) {
        const State& s = states[k];
        const std::string group = "/frames/0000000" + std::to_string(k) + "/";
        const auto read = [&](const char* name) {
            return table(folder_ / "frames.h5", group + name);
        };
        ASSERT_EQ(read("position").size(), 3 * s.position.size());
        const auto position = read("position");
        const auto orientation = read("orientation");
        const auto id = read("id");
        const auto force = read("force");
        const auto coordination = read("coordination");
        for (std::size_t i = 0; i < s.position.size(); ++i) {
            ASSERT_EQ(Vec3(position[3 * i], position[3 * i + 1], position[3 * i + 2]),
                      s.position[i]);
            ASSERT_EQ(orientation[4 * i], s.orientation[i].w());
            ASSERT_EQ(orientation[4 * i + 3], s.orientation[i].z());
            ASSERT_EQ(id[i], s.id[i]);
            ASSERT_EQ(force[3 * i + 1], s.force[i].y());
            ASSERT_EQ(coordination[i], s.coordination[i]);
        }
    }
    // The empty frame is in the file but not in the index.
    const std::string index = text("frames.xdmf");
    EXPECT_EQ(occurrences(index, "<Time "), 4U);
    EXPECT_NE(index.find("frames.h5:/frames/00000004/orientation"), std::string::npos);
    EXPECT_NE(index.find("</Xdmf>"), std::string::npos);
}

TEST_F(Frames, TheFilesAreCompleteAfterEveryFrameWhateverBecomesOfTheWriter) {
    const State state(50, 1);
    FrameWriter writer(folder_, context_, shapes_);
    for (int k = 0; k < 5; ++k) {
        writer.append(state.frame(k));
        std::filesystem::copy_file(folder_ / "frames.h5", folder_ / "copy.h5",
                                   std::filesystem::copy_options::overwrite_existing);
        EXPECT_EQ(
            table(folder_ / "copy.h5", "/frames/0000000" + std::to_string(k) + "/position").size(),
            150U);
        EXPECT_EQ(occurrences(text("frames.xdmf"), "<Time "), static_cast<std::size_t>(k + 1));
    }
}

TEST_F(Frames, SomebodyWhoHasTheFileOpenDoesNotStopTheRun) {
    const State state(50, 1);
    FrameWriter writer(folder_, context_, shapes_);
    writer.append(state.frame(0));
    // What HDF5 does to a file that it reads.
    const int reader = open((folder_ / "frames.h5").c_str(), O_RDONLY);
    ASSERT_EQ(flock(reader, LOCK_SH | LOCK_NB), 0);
    EXPECT_NO_THROW(writer.append(state.frame(1)));
    close(reader);
}

TEST_F(Frames, WhenTheDiskIsFullTheFramesBeforeStayReadable) {
    // A limit on the size of files stands in for the end of a disk.
    const State state(2000, 1);
    FrameWriter writer(folder_, context_, shapes_);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{1500000, limit.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    int written = 0;
    std::string message;
    while (written < 100 && message.empty()) {
        message = message_of<Error>([&] { writer.append(state.frame(written)); });
        if (message.empty()) ++written;
    }
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(message, (folder_ / "frames.h5").string() + ": cannot write: File too large");
    EXPECT_GT(written, 2);
    for (int k = 0; k < written; ++k) {
        EXPECT_EQ(table(folder_ / "frames.h5", "/frames/0000000" + std::to_string(k) + "/position")
                      .size(),
                  6000U);
    }
}

TEST_F(Frames, AFolderThatCannotBeWrittenIsNamed) {
    EXPECT_EQ(message_of<Error>([&] { FrameWriter(folder_ / "no", context_, shapes_); }),
              (folder_ / "no" / "frames.h5").string() +
                  ": cannot create: No such file or directory, expected a folder in which files "
                  "can be made");
    std::filesystem::create_directory(folder_ / "frames.h5");
    const std::string message = message_of<Error>([&] { FrameWriter(folder_, context_, shapes_); });
    EXPECT_EQ(message, (folder_ / "frames.h5").string() +
                           ": is a folder, expected the name of a file to write");
}

TEST_F(Frames, SurfacesAreTheDisplayMeshesMovedByEachParticle) {
    FrameContext context = context_;
    context.surfaces = true;
    std::vector<ParticleTemplate> shapes = shapes_;
    shapes[1].display_mesh = sample::sphere_mesh(1e-3);
    const State few(3, 1);
    const State more(4, 2);
    {
        FrameWriter writer(folder_, context, shapes);
        writer.append(few.frame(0));
        writer.append(few.frame(1));
        writer.append(more.frame(2));
    }
    const auto points = table(folder_ / "surfaces.h5", "/frames/00000002/points");
    ASSERT_EQ(points.size(), 4U * 18U * 3U);
    for (std::size_t i = 0; i < 4; ++i) {
        const DisplayMesh& mesh = shapes[i % 2].display_mesh;
        for (std::size_t k = 0; k < 18; ++k) {
            const Vec3 p = more.position[i] + more.orientation[i] * mesh.vertices[k];
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(points[3 * (18 * i + k) + c], p[static_cast<Eigen::Index>(c)], 1e-7);
            }
        }
    }
    const auto triangles = table(folder_ / "surfaces.h5", "/topologies/1/triangles");
    ASSERT_EQ(triangles.size(), 4U * 32U * 3U);
    EXPECT_EQ(*std::ranges::max_element(triangles), 4 * 18 - 1);
    EXPECT_EQ(triangles[3 * 32 * 3], shapes[1].display_mesh.triangles[0][0] + 3 * 18);
    const auto ids = table(folder_ / "surfaces.h5", "/topologies/1/particle_id");
    EXPECT_EQ(std::accumulate(ids.begin(), ids.end(), 0.0), 32 * (0 + 1 + 2 + 3));
    // Two frames of the same particles share their triangles.
    EXPECT_EQ(occurrences(text("surfaces.xdmf"), "/topologies/0/triangles"), 2U);
    EXPECT_EQ(table(folder_ / "surfaces.h5", "/topologies/2/triangles").size(), 0U);
}

TEST_F(Frames, SurfacesThatWereDamagedAreNotTakenUp) {
    FrameContext context = context_;
    context.surfaces = true;
    std::vector<ParticleTemplate> shapes = shapes_;
    shapes[1].display_mesh = sample::sphere_mesh(1e-3);
    {
        FrameWriter writer(folder_, context, shapes);
        for (std::uint64_t k = 0; k < 3; ++k) {
            writer.append(State(3, k).frame(static_cast<double>(k)));
        }
    }
    const std::string whole = text("surfaces.h5");
    const auto answer = [&] {
        return message_of<Error>([&] { FrameWriter(folder_, context, shapes, 3); });
    };
    EXPECT_EQ(answer(), "");
    const std::string place = (folder_ / "surfaces.h5").string() + ": ";
    const std::string expected =
        ", expected the surfaces before the checkpoint; move the file away and --resume begins a "
        "new one";
    for (const char* table :
         {"/frames/00000001/points", "/frames/00000000/speed", "/topologies/0/triangles"}) {
        const std::vector<std::byte> bytes =
            Hdf5Reader(folder_ / "surfaces.h5").content(std::string(table));
        const std::size_t at =
            whole.find(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        ASSERT_NE(at, std::string::npos) << table;
        std::string damaged = whole;
        damaged[at + 5] = static_cast<char>(damaged[at + 5] ^ 1);
        write("surfaces.h5", damaged);
        const std::string group(table, std::string(table).rfind('/'));
        EXPECT_EQ(answer(),
                  place + "holds " + group + " that was changed after it was written" + expected);
        write("surfaces.h5", whole);
    }
    std::string damaged = whole;
    damaged[whole.find("surfaces.h5:/frames/00000001/speed") + 1] ^= 1;
    write("surfaces.h5", damaged);
    EXPECT_EQ(answer(),
              place + "holds /frames/00000001 that was changed after it was written" + expected);
    for (const std::size_t size : {0UL, 100UL, whole.size() / 2, whole.size() - 1}) {
        write("surfaces.h5", whole.substr(0, size));
        const std::string message = answer();
        EXPECT_TRUE(message.starts_with(place) && message.ends_with(expected)) << message;
    }
    std::filesystem::remove(folder_ / "surfaces.h5");
    EXPECT_EQ(answer(), "");
}

}  // namespace
}  // namespace dem::runtime
