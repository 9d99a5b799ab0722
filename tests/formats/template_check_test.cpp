// SPDX-License-Identifier: BSD-3-Clause
#include "formats/template_check.hpp"

#include "common/error.hpp"
#include "formats/template_reader.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <functional>
#include <limits>

#include <particle_template_generated.h>

namespace dem {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

template <class T>
void set(SharedArray<T>& array, std::size_t i, const T& value) {
    std::vector<T> values(array.begin(), array.end());
    values.at(i) = value;
    array = std::move(values);
}
template <class T>
void drop_last(SharedArray<T>& array) {
    array = std::vector<T>(array.begin(), array.end() - 1);
}

std::string reading(const TemplateFile& content) {
    const sample::Bytes bytes = sample::unchecked(content);
    return message_of<Error>([&] { read_template(bytes.memory, bytes.bytes, "x.tpl"); });
}

using Change = std::function<void(ParticleTemplate&, SrShape&)>;
struct Case {
    const char* expected;
    Change change;
};

// The sphere of tests/formats/sample_template.hpp, one thing made wrong, the checksum right.
const Case wrong[] = {
    {"volume is nan", [](auto& t, auto&) { t.mass_properties.volume = nan; }},
    {"volume is 0", [](auto& t, auto&) { t.mass_properties.volume = 0.0; }},
    {"volume exceeds", [](auto& t, auto&) { t.mass_properties.volume *= 1.01; }},
    {"center of mass is inf", [](auto& t, auto&) { t.mass_properties.center_of_mass.y() = inf; }},
    {"unit quaternion", [](auto& t, auto&) { t.mass_properties.principal_axes.w() = 0.6; }},
    {"unit quaternion", [](auto& t, auto&) { t.mass_properties.principal_axes.x() = nan; }},
    {"principal moment is -",
     [](auto& t, auto&) { t.mass_properties.principal_moments_per_density.x() = -1.0; }},
    {"triangle inequality",
     [](auto& t, auto&) { t.mass_properties.principal_moments_per_density.z() *= 2.1; }},
    {"bounding radius is 0", [](auto& t, auto&) { t.bounding_radius = 0.0; }},
    {"two bounding radii", [](auto& t, auto&) { t.bounding_radius *= 1.5; }},
    {"two marks of convexity", [](auto& t, auto&) { t.is_convex = false; }},
    {"mean squared surface distance", [](auto& t, auto&) { t.mean_squared_surface_distance = -1; }},
    {"mean squared surface distance", [](auto& t, auto&) { t.mean_squared_surface_distance = 1; }},
    {"control characters", [](auto& t, auto&) { t.name = "two\nlines"; }},
    {"has no name", [](auto& t, auto&) { t.certificate[0].first = ""; }},
    {"certificate is inf", [](auto& t, auto&) { t.certificate[1].second = inf; }},
    {"two entries of one name", [](auto& t, auto&) { t.certificate[1].first = "volume_error"; }},
    {"display mesh", [](auto& t, auto&) { set(t.display_mesh.vertices, 3, Vec3(0, nan, 0)); }},
    {"display mesh", [](auto& t, auto&) { set(t.display_mesh.vertices, 3, Vec3(1, 0, 0)); }},
    {"display mesh",
     [](auto& t, auto&) {
         set(t.display_mesh.triangles, 0, {0U, 1U, 18U});
     }},
    {"display mesh", [](auto& t, auto&) { t.display_mesh.max_deviation = nan; }},

    {"bottom", [](auto&, auto& s) { s.bottom_z = s.top_z; }},
    {"reaches beyond", [](auto&, auto& s) { s.top_z *= 1.5; }},
    {"top is nan", [](auto&, auto& s) { s.top_z = nan; }},
    {"largest radius", [](auto&, auto& s) { s.max_radius = -1.0; }},
    {"equivalent diameter", [](auto&, auto& s) { s.equivalent_diameter *= 1.01; }},
    {"major axis length", [](auto&, auto& s) { s.major_axis_length *= 0.9; }},
    {"major axis length", [](auto&, auto& s) { s.major_axis_length *= 1.1; }},

    {"needs a support map", [](auto&, auto& s) { s.support = {}; }},
    {"needs a support map", [](auto& t, auto& s) { s.is_convex = t.is_convex = false; }},
    {"differ in number", [](auto&, auto& s) { drop_last(s.support.piece_end); }},
    {"center of a support piece is nan",
     [](auto&, auto& s) {
         set(s.support.pieces, 0, {nan, 0, 1, 1});
     }},
    {"semi-axis",
     [](auto&, auto& s) {
         set(s.support.pieces, 0, {0, 0, -1, 1});
     }},
    {"one semi-axis of zero",
     [](auto&, auto& s) {
         set(s.support.pieces, 0, {0, 0, 0, 1});
     }},
    {"do not rise", [](auto&, auto& s) { set(s.support.piece_end, 0, nan); }},
    {"do not rise", [](auto&, auto& s) { set(s.support.piece_end, 0, 1.5); }},
    {"reach the top", [](auto&, auto& s) { set(s.support.piece_end, 1, 0.9); }},
    {"no index", [](auto&, auto& s) { s.support.first_piece = std::vector<std::uint32_t>{0}; }},
    {"out of range", [](auto&, auto& s) { set(s.support.first_piece, 3, 2U); }},
    {"out of range", [](auto&, auto& s) { set(s.support.first_piece, 4, 9U); }},
    {"skips a piece", [](auto&, auto& s) { set(s.support.first_piece, 2, 1U); }},

    {"do not match its grid", [](auto&, auto& s) { s.sdf.cells_r = 4; }},
    {"do not match its grid", [](auto&, auto& s) { drop_last(s.sdf.cells); }},
    {"do not match its grid",
     [](auto&, auto& s) {
         s.sdf.cells_r = s.sdf.cells_z = 0;
         s.sdf.cells = {};
     }},
    {"has no values", [](auto&, auto& s) { drop_last(s.sdf.values); }},
    {"has no values",
     [](auto&, auto& s) {
         set(s.sdf.cells, 2, SdfCell{0xfffffffeU, 0});
     }},
    {"too deep",
     [](auto&, auto& s) {
         set(s.sdf.cells, 2, SdfCell{0, 32});
     }},
    {"distance is nan", [](auto&, auto& s) { set(s.sdf.values, 7, nan); }},
    {"cell size", [](auto&, auto& s) { s.sdf.base_size = inf; }},
    {"too large for the body", [](auto&, auto& s) { s.sdf.base_size = 1e243; }},
    {"too large for the body", [](auto&, auto& s) { s.sdf.surface_band = 1e243; }},
    {"too large for the body", [](auto&, auto& s) { set(s.sdf.values, 7, 1e243); }},
    {"slack of the distance field is too large",
     [](auto&, auto& s) { s.sdf.lipschitz_slack = 1e243; }},
    {"does not cover", [](auto&, auto& s) { s.sdf.origin_z = 0.0; }},
    {"does not cover", [](auto&, auto& s) { s.sdf.origin_r = 1e-4; }},
    {"does not cover", [](auto&, auto& s) { s.sdf.base_size *= 0.5; }},
    {"slack of the distance field", [](auto&, auto& s) { s.sdf.lipschitz_slack = -1.0; }},
    {"margin of the distance field", [](auto&, auto& s) { s.sdf.margin = -1.0; }},
    {"distance field near the surface", [](auto&, auto& s) { s.sdf.surface_slack = -1.0; }},
    {"band of the distance field", [](auto&, auto& s) { s.sdf.surface_band = -1.0; }},

    {"less than two samples", [](auto&, auto& s) { s.curvature = {}; }},
    {"curvature is inf",
     [](auto&, auto& s) { set(s.curvature, 0, CurvatureSample{0, -2e-3, 0, inf}); }},
    {"does not rise",
     [](auto&, auto& s) { set(s.curvature, 1, CurvatureSample{0, -2e-3, -1, 0}); }},
    {"off the profile",
     [](auto&, auto& s) { set(s.curvature, 1, CurvatureSample{1, -2e-3, 1e-3, 0}); }},
    {"off the profile",
     [](auto&, auto& s) { set(s.curvature, 1, CurvatureSample{-1e-3, 0, 1e-3, 0}); }},

    {"do not match", [](auto&, auto& s) { s.nodes.count = 40; }},
    {"do not match", [](auto&, auto& s) { drop_last(s.nodes.nodes); }},
    {"do not match", [](auto&, auto& s) { drop_last(s.nodes.blocks); }},
    {"do not match", [](auto&, auto& s) { drop_last(s.nodes.super_blocks); }},
    {"do not match", [](auto&, auto& s) { drop_last(s.nodes.stencil); }},
    {"neighbor", [](auto&, auto& s) { set(s.nodes.stencil, 5, 20U); }},
    {"outside the bounding radius",
     [](auto&, auto& s) { set(s.nodes.nodes, 5, SurfaceNodes::Node{nan, 0, 0, 0}); }},
    {"outside the bounding radius",
     [](auto&, auto& s) { set(s.nodes.nodes, 5, SurfaceNodes::Node{0, 0, 3e-3, 0}); }},
    {"sphere of its block",
     [](auto&, auto& s) { set(s.nodes.blocks, 0, SurfaceNodes::Ball{0, 0, 0, 1e-3}); }},
    {"sphere of its block",
     [](auto&, auto& s) { set(s.nodes.super_blocks, 0, SurfaceNodes::Ball{nan, 0, 0, 1}); }},
    {"radius of a block",
     [](auto&, auto& s) { set(s.nodes.blocks, 0, SurfaceNodes::Ball{0, 0, 0, -1}); }},
    {"last node", [](auto&, auto& s) { set(s.nodes.nodes, 31, SurfaceNodes::Node{0, 0, 0, 0}); }},
};

TEST(TemplateCheck, AWrongValueUnderARightChecksumIsFoundAndNamed) {
    for (const Case& c : wrong) {
        TemplateFile content = sample::file();
        ParticleTemplate& t = content.shapes[1];
        c.change(t, std::get<SrShape>(t.shape));
        const std::string message = reading(content);
        EXPECT_NE(message.find(c.expected), std::string::npos)
            << "expected: " << c.expected << "\nfound:    " << message;
        EXPECT_EQ(message.rfind("x.tpl: shape 1 '", 0), 0U) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST(TemplateCheck, AWrongClumpIsFoundAndNamed) {
    struct ClumpCase {
        const char* expected;
        std::function<void(ParticleTemplate&, Clump&)> change;
    };
    const auto sphere = [](auto& clump, const std::function<void(ClumpSphere&)>& change) {
        ClumpSphere s = clump.spheres[5];
        change(s);
        set(clump.spheres, 5, s);
    };
    const ClumpCase cases[] = {
        {"has no spheres", [](auto&, auto& c) { c.spheres = {}; }},
        {"radius of a sphere is nan",
         [&](auto&, auto& c) { sphere(c, [](auto& s) { s.radius = nan; }); }},
        {"radius of a sphere is -",
         [&](auto&, auto& c) { sphere(c, [](auto& s) { s.radius = -1e-4; }); }},
        {"volume share of a sphere is inf",
         [&](auto&, auto& c) { sphere(c, [](auto& s) { s.volume_share = inf; }); }},
        {"do not add up", [&](auto&, auto& c) { sphere(c, [](auto& s) { s.volume_share = 0; }); }},
        {"outside the bounding radius",
         [&](auto&, auto& c) { sphere(c, [](auto& s) { s.x = nan; }); }},
        {"outside the bounding radius",
         [&](auto&, auto& c) { sphere(c, [](auto& s) { s.radius *= 1.001; }); }},
        {"outside its bounding ball",
         [](auto&, auto& c) {
             set(c.balls, 0, Clump::Ball{0, 0, 0, nan});
         }},
        {"outside its bounding ball",
         [](auto&, auto& c) {
             set(c.balls, 2, Clump::Ball{0, 0, 0, 1.4e-3});
         }},
        {"in number", [](auto&, auto& c) { drop_last(c.balls); }},
        {"in number", [](auto&, auto& c) { c.balls = {}; }},
    };
    for (const ClumpCase& c : cases) {
        TemplateFile content = sample::file();
        ParticleTemplate& t = content.shapes[2];
        c.change(t, std::get<Clump>(t.shape));
        const std::string message = reading(content);
        EXPECT_NE(message.find(c.expected), std::string::npos)
            << "expected: " << c.expected << "\nfound:    " << message;
    }
}

TEST(TemplateCheck, AWrongConvexShapeIsFoundAndNamed) {
    struct ConvexCase {
        const char* expected;
        std::function<void(ConvexShape&)> change;
    };
    using Core = ConvexShape::Core;
    const ConvexCase cases[] = {
        {"unknown kind", [](auto& c) { c.core = static_cast<Core>(7); }},
        {"has vertices", [](auto& c) { c.core = Core::ellipsoid; }},
        {"rounding of a convex shape is -", [](auto& c) { c.rounding = -1e-6; }},
        {"lower end of a convex shape is nan", [](auto& c) { c.low = nan; }},
        {"vertex of a polyhedron is inf", [](auto& c) { set(c.vertices, 1, Vec3(0, inf, 0)); }},
        {"beyond the bounding radius", [](auto& c) { c.rounding = 1e-3; }},
        {"is not that of the convex shape", [](auto& c) { c.rounding *= 0.99; }},
        {"not convex", [](auto& c) { set(c.vertices, 0, Vec3(-0.4 * c.vertices[0])); }},
        {"fewer than three", [](auto& c) { set(c.face_begin, 1, 2U); }},
        {"fewer than three", [](auto& c) { set(c.face_begin, 1, 4000000000U); }},
        {"use up", [](auto& c) { drop_last(c.face_vertices); }},
        {"does not exist", [](auto& c) { set(c.face_vertices, 2, 4U); }},
        {"do not close", [](auto& c) { set(c.face_vertices, 0, c.face_vertices[1]); }},
        {"do not close",
         [](auto& c) {
             c.face_begin = {};
             c.face_vertices = {};
         }},
    };
    for (const ConvexCase& c : cases) {
        TemplateFile content = sample::file();
        c.change(std::get<ConvexShape>(content.shapes[3].shape));
        const std::string message = reading(content);
        EXPECT_NE(message.find(c.expected), std::string::npos)
            << "expected: " << c.expected << "\nfound:    " << message;
    }
}

TEST(TemplateCheck, ABoundingRadiusOutOfProportionIsFound) {
    TemplateFile content = sample::file();
    content.shapes[3].bounding_radius *= 3.0;
    EXPECT_NE(reading(content).find("more than twice the reach"), std::string::npos)
        << reading(content);
    content.shapes[3].bounding_radius = 1e243;
    EXPECT_NE(reading(content).find("larger than 1e6 m"), std::string::npos) << reading(content);
}

TEST(TemplateCheck, AWrongSphereIsFound) {
    for (const double radius : {0.0, -1e-3, nan, inf, 2e-3}) {
        TemplateFile content = sample::file();
        std::get<Sphere>(content.shapes[0].shape).radius = radius;
        EXPECT_NE(reading(content), "") << radius;
    }
    TemplateFile content = sample::file();
    content.shapes[0].is_convex = false;
    EXPECT_NE(reading(content), "");
    content.shapes.clear();
    EXPECT_EQ(reading(content), "x.tpl: holds no shape, expected at least one; make it again");
}

TEST(TemplateCheck, ANonConvexShapeNeedsNodesAndNoSupportMap) {
    TemplateFile content = sample::file();
    ParticleTemplate& t = content.shapes[1];
    auto& sr = std::get<SrShape>(t.shape);
    t.is_convex = sr.is_convex = false;
    sr.support = {};
    EXPECT_EQ(reading(content), "");
    sr.nodes = {};
    EXPECT_NE(reading(content).find("has no surface nodes"), std::string::npos);
}

std::string reading_payload(flatbuffers::FlatBufferBuilder& fbb) {
    const sample::Bytes file =
        sample::sealed(std::as_bytes(std::span(fbb.GetBufferPointer(), fbb.GetSize())));
    return message_of<Error>([&] { read_template(file.memory, file.bytes, "x.tpl"); });
}

/// A template whose only shape is of `kind` with `data`.
std::string reading_shape(flatbuffers::FlatBufferBuilder& fbb, int kind,
                          flatbuffers::Offset<void> data,
                          flatbuffers::Offset<flatbuffers::Vector<double>> values = 0) {
    const schema::MassProperties mass(1e-9, {0, 0, 0}, {1, 0, 0, 0}, {1e-15, 1e-15, 1e-15});
    const auto name = fbb.CreateString("x");
    const auto shape = schema::CreateShape(fbb, name, &mass, 1e-3, 1e-6, true, 0, 0, values,
                                           static_cast<schema::ShapeData>(kind), data);
    const auto shapes = fbb.CreateVector(&shape, 1);
    fbb.Finish(schema::CreateTemplateFile(fbb, name, 0, name, shapes));
    return reading_payload(fbb);
}

TEST(TemplateCheck, AContentOfAnotherMakeIsRefused) {
    flatbuffers::FlatBufferBuilder good;
    EXPECT_EQ(reading_shape(good, schema::ShapeData_SphereShape,
                            schema::CreateSphereShape(good, 1e-3).Union()),
              "");
    flatbuffers::FlatBufferBuilder unknown;
    EXPECT_NE(reading_shape(unknown, 77, schema::CreateSphereShape(unknown, 1e-3).Union())
                  .find("a kind that this program does not know"),
              std::string::npos);
    flatbuffers::FlatBufferBuilder mistaken;
    EXPECT_NE(reading_shape(mistaken, schema::ShapeData_SrShape,
                            schema::CreateSphereShape(mistaken, 1e-3).Union()),
              "");
    flatbuffers::FlatBufferBuilder unpaired;
    const auto values = unpaired.CreateVector(std::vector<double>{1.0});
    EXPECT_NE(reading_shape(unpaired, schema::ShapeData_SphereShape,
                            schema::CreateSphereShape(unpaired, 1e-3).Union(), values)
                  .find("differ in number"),
              std::string::npos);
    flatbuffers::FlatBufferBuilder text;
    text.Finish(text.CreateString("no template"));
    EXPECT_NE(reading_payload(text), "");
    EXPECT_NE(message_of<Error>([] {
                  const sample::Bytes file = sample::sealed({});
                  read_template(file.memory, file.bytes, "x.tpl");
              }),
              "");
}

}  // namespace
}  // namespace dem
