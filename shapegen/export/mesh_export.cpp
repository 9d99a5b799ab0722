// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/export/mesh_export.hpp"

#include "common/atomic_file.hpp"
#include "formats/number_text.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace dem::shapegen {

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

// The header must not begin with "solid", which marks the text variant.
std::string stl(const ColoredMesh& mesh, std::string header) {
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
    return out;
}

std::string vtu_head(std::size_t points, std::size_t cells) {
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "  <UnstructuredGrid>\n"
           "    <Piece NumberOfPoints=\"" +
           std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n";
}

constexpr const char* array_end = "        </DataArray>\n";

void append_points_and_cells(std::string& out, std::span<const ColoredMesh> meshes) {
    constexpr int triangle_type = 5;  // VTK_TRIANGLE
    out += "      <Points>\n";
    open_array(out, "Float64", "Points");
    for (const ColoredMesh& mesh : meshes) {
        for (const Vec3& p : mesh.vertices) {
            append_text(out, p, ' ');
            out += '\n';
        }
    }
    out += std::string(array_end) + "      </Points>\n      <Cells>\n";
    open_array(out, "Int64", "connectivity");
    std::size_t first = 0;
    std::size_t count = 0;
    for (const ColoredMesh& mesh : meshes) {
        for (const auto& [a, b, c] : mesh.triangles)
            out += std::to_string(first + a) + ' ' + std::to_string(first + b) + ' ' +
                   std::to_string(first + c) + '\n';
        first += mesh.vertices.size();
        count += mesh.triangles.size();
    }
    out += array_end;
    open_array(out, "Int64", "offsets");
    for (std::size_t i = 1; i <= count; ++i) out += std::to_string(3 * i) + '\n';
    out += array_end;
    open_array(out, "UInt8", "types");
    for (std::size_t i = 0; i < count; ++i) out += std::to_string(triangle_type) + '\n';
    out += std::string(array_end) + "      </Cells>\n";
}

void append_values(std::string& out, std::span<const ColoredMesh> parts, const std::string& name) {
    out += "      <PointData Scalars=\"" + name + "\">\n";
    open_array(out, "Float64", name);
    for (const ColoredMesh& mesh : parts)
        for (const double value : mesh.values) out += number_text(value) + '\n';
    out += std::string(array_end) + "      </PointData>\n";
}

void append_part_numbers(std::string& out, std::span<const ColoredMesh> parts) {
    out += "      <CellData>\n";
    open_array(out, "UInt8", "part");
    for (std::size_t part = 0; part < parts.size(); ++part)
        for (std::size_t i = 0; i < parts[part].triangles.size(); ++i)
            out += std::to_string(part) + '\n';
    out += std::string(array_end) + "      </CellData>\n";
}

constexpr const char* vtu_tail = "    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";

}  // namespace

void write_stl(const std::filesystem::path& path, const ColoredMesh& mesh, const std::string& name,
               const std::string& unit) {
    write_file(path, stl(mesh, "binary STL, unit " + unit + ": " + name));
}

void write_vtu(const std::filesystem::path& path, std::span<const ColoredMesh> parts,
               const std::string& value_name) {
    std::size_t points = 0;
    std::size_t cells = 0;
    for (const ColoredMesh& mesh : parts) {
        points += mesh.vertices.size();
        cells += mesh.triangles.size();
    }
    std::string out = vtu_head(points, cells);
    append_points_and_cells(out, parts);
    if (!value_name.empty()) append_values(out, parts, value_name);
    if (parts.size() > 1) append_part_numbers(out, parts);
    write_file(path, out + vtu_tail);
}

void write_obj(const std::filesystem::path& path, std::span<const ColoredMesh> parts,
               std::span<const std::string> names, const std::string& unit) {
    std::string out = "# unit " + unit + '\n';
    std::size_t first = 1;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const ColoredMesh& mesh = parts[part];
        out += "o " + names[part] + '\n';
        for (const Vec3& p : mesh.vertices) {
            out += "v ";
            append_text(out, p, ' ');
            out += '\n';
        }
        for (const auto& [a, b, c] : mesh.triangles)
            out += "f " + std::to_string(first + a) + ' ' + std::to_string(first + b) + ' ' +
                   std::to_string(first + c) + '\n';
        first += mesh.vertices.size();
    }
    write_file(path, out);
}

void write_nodes_csv(const std::filesystem::path& path, const SurfaceNodes& nodes,
                     const InputFrame& frame) {
    std::string out = "x,y,z,mean_curvature\n";
    for (std::uint32_t i = 0; i < nodes.count; ++i) {
        const SurfaceNodes::Node& node = nodes.nodes[i];
        append_text(out, frame.point({node.x, node.y, node.z}), ',');
        out += ',';
        out += number_text(frame.unit() * node.mean_curvature);
        out += '\n';
    }
    write_file(path, out);
}

}  // namespace dem::shapegen
