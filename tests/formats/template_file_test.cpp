// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "formats/template_reader.hpp"
#include "formats/template_writer.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <algorithm>

#include <sys/stat.h>

namespace dem {
namespace {

template <class T>
bool same_bytes(const SharedArray<T>& a, const SharedArray<T>& b) {
    return std::ranges::equal(std::as_bytes(a.span()), std::as_bytes(b.span()));
}

void expect_same(const ParticleTemplate& a, const ParticleTemplate& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.mass_properties.volume, b.mass_properties.volume);
    EXPECT_EQ(a.mass_properties.center_of_mass, b.mass_properties.center_of_mass);
    EXPECT_EQ(a.mass_properties.principal_axes.coeffs(), b.mass_properties.principal_axes.coeffs());
    EXPECT_EQ(a.mass_properties.principal_moments_per_density,
              b.mass_properties.principal_moments_per_density);
    EXPECT_EQ(a.bounding_radius, b.bounding_radius);
    EXPECT_EQ(a.mean_squared_surface_distance, b.mean_squared_surface_distance);
    EXPECT_EQ(a.is_convex, b.is_convex);
    EXPECT_EQ(a.certificate, b.certificate);
    EXPECT_TRUE(same_bytes(a.display_mesh.vertices, b.display_mesh.vertices));
    EXPECT_TRUE(same_bytes(a.display_mesh.triangles, b.display_mesh.triangles));
    EXPECT_EQ(a.display_mesh.max_deviation, b.display_mesh.max_deviation);
    ASSERT_EQ(a.shape.index(), b.shape.index());
}

TEST(TemplateFileTest, EveryValueSurvivesTheRoundTripBitByBit) {
    const TemplateFile written = sample::file();
    const sample::Bytes bytes = sample::unchecked(written);
    const TemplateFile read = read_template(bytes.memory, bytes.bytes, "x.tpl");
    EXPECT_EQ(read.command, written.command);
    EXPECT_EQ(read.input_hash, written.input_hash);
    EXPECT_EQ(read.shapegen_version, written.shapegen_version);
    ASSERT_EQ(read.shapes.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) expect_same(read.shapes[i], written.shapes[i]);
    EXPECT_EQ(std::get<Sphere>(read.shapes[0].shape).radius, 1.5e-3);

    const auto& a = std::get<SrShape>(read.shapes[1].shape);
    const auto& b = std::get<SrShape>(written.shapes[1].shape);
    EXPECT_EQ(a.is_convex, b.is_convex);
    EXPECT_EQ(a.bottom_z, b.bottom_z);
    EXPECT_EQ(a.top_z, b.top_z);
    EXPECT_EQ(a.max_radius, b.max_radius);
    EXPECT_EQ(a.bounding_radius, b.bounding_radius);
    EXPECT_EQ(a.equivalent_diameter, b.equivalent_diameter);
    EXPECT_EQ(a.major_axis_length, b.major_axis_length);
    EXPECT_TRUE(same_bytes(a.support.pieces, b.support.pieces));
    EXPECT_TRUE(same_bytes(a.support.piece_end, b.support.piece_end));
    EXPECT_TRUE(same_bytes(a.support.first_piece, b.support.first_piece));
    EXPECT_EQ(a.sdf.origin_r, b.sdf.origin_r);
    EXPECT_EQ(a.sdf.origin_z, b.sdf.origin_z);
    EXPECT_EQ(a.sdf.base_size, b.sdf.base_size);
    EXPECT_EQ(a.sdf.margin, b.sdf.margin);
    EXPECT_EQ(a.sdf.lipschitz_slack, b.sdf.lipschitz_slack);
    EXPECT_EQ(a.sdf.surface_slack, b.sdf.surface_slack);
    EXPECT_EQ(a.sdf.surface_band, b.sdf.surface_band);
    EXPECT_EQ(a.sdf.cells_r, b.sdf.cells_r);
    EXPECT_EQ(a.sdf.cells_z, b.sdf.cells_z);
    EXPECT_TRUE(same_bytes(a.sdf.cells, b.sdf.cells));
    EXPECT_TRUE(same_bytes(a.sdf.values, b.sdf.values));
    EXPECT_TRUE(same_bytes(a.curvature, b.curvature));
    EXPECT_EQ(a.nodes.count, b.nodes.count);
    EXPECT_TRUE(same_bytes(a.nodes.nodes, b.nodes.nodes));
    EXPECT_TRUE(same_bytes(a.nodes.blocks, b.nodes.blocks));
    EXPECT_TRUE(same_bytes(a.nodes.super_blocks, b.nodes.super_blocks));
    EXPECT_TRUE(same_bytes(a.nodes.stencil, b.nodes.stencil));

    const auto& c = std::get<Clump>(read.shapes[2].shape);
    const auto& d = std::get<Clump>(written.shapes[2].shape);
    EXPECT_TRUE(same_bytes(c.spheres, d.spheres));
    EXPECT_TRUE(same_bytes(c.balls, d.balls));
    EXPECT_EQ(c.largest_radius, d.largest_radius);

    const auto& e = std::get<ConvexShape>(read.shapes[3].shape);
    const auto& f = std::get<ConvexShape>(written.shapes[3].shape);
    EXPECT_EQ(e.core, f.core);
    EXPECT_EQ(e.rounding, f.rounding);
    EXPECT_EQ(e.equivalent_diameter, f.equivalent_diameter);
    EXPECT_TRUE(same_bytes(e.vertices, f.vertices));
    EXPECT_TRUE(same_bytes(e.face_begin, f.face_begin));
    EXPECT_TRUE(same_bytes(e.face_vertices, f.face_vertices));
    EXPECT_TRUE(same_bytes(e.planes, f.planes));
    EXPECT_TRUE(same_bytes(e.edges, f.edges));
    EXPECT_TRUE(same_bytes(e.neighbors, f.neighbors));
}

TEST(TemplateFileTest, ArraysLieInTheBufferAndKeepItAlive) {
    sample::Bytes bytes = sample::unchecked(sample::file());
    const std::span<const std::byte> range = bytes.bytes;
    const std::weak_ptr<void> memory = bytes.memory;
    SharedArray<double> values;
    {
        const TemplateFile read = read_template(bytes.memory, bytes.bytes, "x.tpl");
        values = std::get<SrShape>(read.shapes[1].shape).sdf.values;
        bytes.memory.reset();
    }
    EXPECT_GE(reinterpret_cast<const std::byte*>(values.data()), range.data());
    EXPECT_LE(reinterpret_cast<const std::byte*>(values.data() + values.size()),
              range.data() + range.size());
    EXPECT_FALSE(memory.expired());
    values = {};
    EXPECT_TRUE(memory.expired());
}

using TemplateOnDisk = TemporaryFolder;

TEST_F(TemplateOnDisk, WritingTwiceGivesTheSameBytesAndReadingGivesThemBack) {
    write_template(folder_ / "a.tpl", sample::file());
    write_template(folder_ / "b.tpl", read_template(folder_ / "a.tpl"));
    EXPECT_EQ(text("a.tpl"), text("b.tpl"));
    EXPECT_GT(text("a.tpl").size(), 4000U);
}

TEST_F(TemplateOnDisk, ALibraryOfManyShapesKeepsTheirOrder) {
    TemplateFile library = sample::file();
    library.shapes.clear();
    for (int i = 0; i < 20000; ++i) {
        library.shapes.push_back(sample::sphere(1e-3 + 1e-8 * i, "s" + std::to_string(i)));
    }
    write_template(folder_ / "library.tpl", library);
    const TemplateFile read = read_template(folder_ / "library.tpl");
    ASSERT_EQ(read.shapes.size(), library.shapes.size());
    for (std::size_t i = 0; i < read.shapes.size(); ++i) {
        ASSERT_EQ(std::get<Sphere>(read.shapes[i].shape).radius,
                  std::get<Sphere>(library.shapes[i].shape).radius);
    }
}

TEST_F(TemplateOnDisk, AnInvalidTemplateIsNotWritten) {
    TemplateFile content = sample::file();
    content.shapes[1].bounding_radius = -1.0;
    EXPECT_EQ(message_of<Error>([&] { write_template(folder_ / "a.tpl", content); }),
              (folder_ / "a.tpl").string() +
                  ": shape 1 'sr ball': bounding radius is -1, expected a positive number; make "
                  "the template again");
    content.shapes.clear();
    EXPECT_THROW(write_template(folder_ / "a.tpl", content), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(TemplateOnDisk, MoreThanTwoGigabytesAreRefusedBeforeTheyAreBuilt) {
    // One array of 1.5 GB of zero pages that nobody touches, claimed by two shapes.
    TemplateFile content = sample::file();
    auto& sr = std::get<SrShape>(content.shapes[1].shape);
    const std::size_t count = std::size_t{3} << 26;
    const auto pages = std::shared_ptr<double[]>(
        static_cast<double*>(std::calloc(count, sizeof(double))), [](double* p) { std::free(p); });
    sr.sdf.values = SharedArray<double>(pages, std::span<const double>(pages.get(), count));
    sr.sdf.cells = SharedArray<SdfCell>(
        pages, std::span(reinterpret_cast<const SdfCell*>(pages.get()), count));
    const std::string message =
        message_of<Error>([&] { static_cast<void>(encode_template(content)); });
    EXPECT_NE(message.find("shape 1 of 4: the template exceeds the 2 GB"), std::string::npos)
        << message;
}

TEST_F(TemplateOnDisk, WhatIsNoTemplateIsNamedForWhatItIs) {
    const auto reading = [this](const std::string& name) {
        std::string message = message_of<Error>([&] { read_template(folder_ / name); });
        const std::string place = (folder_ / name).string() + ": ";
        EXPECT_EQ(message.substr(0, place.size()), place);
        return message.substr(std::min(message.size(), place.size()));
    };
    EXPECT_EQ(reading("missing.tpl"), "no such file, expected a template made by shapegen");
    EXPECT_EQ(reading(""), "is a folder, expected a template made by shapegen");
    write("empty.tpl", "");
    EXPECT_EQ(reading("empty.tpl"), "is empty, expected a template made by shapegen");
    write("mesh.stl", "solid bunny, and nothing that a template would hold");
    EXPECT_EQ(reading("mesh.stl"), "is not a template, expected a .tpl file made by shapegen");
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(reading("pipe"), "is a pipe, expected a template made by shapegen");

    write_template(folder_ / "good.tpl", sample::file());
    const std::string good = text("good.tpl");
    write("short.tpl", good.substr(0, 1000));
    EXPECT_EQ(reading("short.tpl"), "is truncated: it has 968 bytes after its header, expected " +
                                        std::to_string(good.size() - 32));
    write("long.tpl", good + "x");
    EXPECT_NE(reading("long.tpl").find("is too long"), std::string::npos);
    std::string other = good;
    other[8] = 7;
    write("other.tpl", other);
    EXPECT_EQ(reading("other.tpl"),
              "is of format version 7, this program reads versions 1 to 2: make it again with this "
              "shapegen");
    other = good;
    other[2000] = static_cast<char>(other[2000] ^ 1);
    write("damaged.tpl", other);
    EXPECT_EQ(reading("damaged.tpl"),
              "is damaged: its checksum does not match, copy or make it again");
}

}  // namespace
}  // namespace dem
