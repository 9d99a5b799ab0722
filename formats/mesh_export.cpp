// SPDX-License-Identifier: BSD-3-Clause
#include "formats/mesh_export.hpp"

#include "common/atomic_file.hpp"
#include "formats/number_text.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace dem {

namespace {

static_assert(std::endian::native == std::endian::little, "STL is a little-endian format");

template <class T>
void append_bytes(std::string& out, const T& value) {
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(T));
    out.append(bytes.data(), bytes.size());
}

void append_bytes(std::string& out, const Vec3& v) {
    for (const double x : {v.x(), v.y(), v.z()}) append_bytes(out, static_cast<float>(x));
}

void append_text(std::string& out, const Vec3& v, char separator) {
    out += number_text(v.x()) + separator + number_text(v.y()) + separator + number_text(v.z());
}

void open_array(std::string& out, const std::string& type, const std::string& name) {
    out += "        <DataArray type=\"" + type + "\" Name=\"" + name + "\"" +
           (name == "Points" ? " NumberOfComponents=\"3\"" : "") + " format=\"ascii\">\n";
}

}  // namespace

void write_stl(const std::filesystem::path& path, const DisplayMesh& mesh,
               const std::string& name) {
    // The header must not begin with "solid", which marks the text variant.
    std::string header = "binary STL, unit m: " + name;
    header.resize(80, ' ');
    std::string out = header;
    append_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3& p = mesh.vertices[a];
        const Vec3 area = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p);
        append_bytes(out, Vec3(area.normalized()));
        append_bytes(out, p);
        append_bytes(out, mesh.vertices[b]);
        append_bytes(out, mesh.vertices[c]);
        append_bytes(out, std::uint16_t{0});
    }
    write_file(path, out);
}

void write_vtu(const std::filesystem::path& path, const DisplayMesh& mesh) {
    constexpr int triangle_type = 5;  // VTK_TRIANGLE
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <UnstructuredGrid>\n"
        "    <Piece NumberOfPoints=\"" +
        std::to_string(mesh.vertices.size()) + "\" NumberOfCells=\"" +
        std::to_string(mesh.triangles.size()) + "\">\n      <Points>\n";
    open_array(out, "Float64", "Points");
    for (const Vec3& p : mesh.vertices) {
        append_text(out, p, ' ');
        out += '\n';
    }
    out += "        </DataArray>\n      </Points>\n      <Cells>\n";
    open_array(out, "Int64", "connectivity");
    for (const auto& [a, b, c] : mesh.triangles) {
        out += std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    }
    out += "        </DataArray>\n";
    open_array(out, "Int64", "offsets");
    for (std::size_t i = 1; i <= mesh.triangles.size(); ++i) out += std::to_string(3 * i) + '\n';
    out += "        </DataArray>\n";
    open_array(out, "UInt8", "types");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        out += std::to_string(triangle_type) + '\n';
    }
    out +=
        "        </DataArray>\n      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
    write_file(path, out);
}

void write_nodes_csv(const std::filesystem::path& path, const SurfaceNodes& nodes) {
    std::string out = "x,y,z,mean_curvature\n";
    for (std::uint32_t i = 0; i < nodes.count; ++i) {
        const SurfaceNodes::Node& node = nodes.nodes[i];
        append_text(out, Vec3(node.x, node.y, node.z), ',');
        out += ',';
        out += number_text(node.mean_curvature);
        out += '\n';
    }
    write_file(path, out);
}

}  // namespace dem
