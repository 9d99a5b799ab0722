// SPDX-License-Identifier: GPL-3.0-or-later
// Scan lines run through the centers of the rows, along x. A line that meets an edge or a corner of
// the mesh would cross several triangles there or none; so it is moved by (e, e^2) in y and z, e
// being smaller than any positive number (Edelsbrunner & Muecke 1990). The moved line crosses
// triangles inside only and is never parallel to one, and where it is inside, the centers of
// the row are inside or on the surface. Centers on the surface are inserted one by one, so it
// does not matter what the moved line says about them.
#include "shapegen/voxel/voxelize.hpp"

#include "shapegen/voxel/exact_orientation.hpp"

#include <algorithm>
#include <tuple>

namespace dem::shapegen {

namespace {

struct IndexRange {
    int begin, end;
};

/// Indices with low <= coordinate <= high, border left out. Empty ranges begin where the first
/// coordinate above `high` is.
IndexRange indices_between(const VoxelGrid& grid, int axis, double low, double high) {
    const int end = grid.size[static_cast<std::size_t>(axis)] - 1;
    const auto first_not_below = [&](double value, auto is_below) {
        const double guess = (value - grid.origin[axis]) / grid.spacing;
        int i = static_cast<int>(std::clamp(guess, 1.0, static_cast<double>(end)));
        while (i > 1 && !is_below(grid.coordinate(axis, i - 1), value)) --i;
        while (i < end && is_below(grid.coordinate(axis, i), value)) ++i;
        return i;
    };
    return {first_not_below(low, [](double x, double value) { return x < value; }),
            first_not_below(high, [](double x, double value) { return x <= value; })};
}

/// From voxel `first` of the row on, the surface has been crossed once more: inwards (+1) or
/// outwards (-1).
struct Crossing {
    int k, j, first, inwards;

    bool operator<(const Crossing& b) const {
        return std::tie(k, j, first) < std::tie(b.k, b.j, b.first);
    }
};

class Triangle {
  public:
    Triangle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners)
        : a_(mesh.vertices[corners[0]]),
          b_(mesh.vertices[corners[1]]),
          c_(mesh.vertices[corners[2]]) {}

    /// Finds where the rows cross the triangle and inserts the centers that lie on it.
    void scan(VoxelImage& image, std::vector<Crossing>& crossings) const {
        const VoxelGrid& grid = image.grid();
        const IndexRange js = range(grid, 1);
        const IndexRange ks = range(grid, 2);
        if (js.begin == js.end || ks.begin == ks.end) return;
        const int facing = orientation(yz(a_), yz(b_), yz(c_));
        const IndexRange is = range(grid, 0);
        for (int k = ks.begin; k < ks.end; ++k) {
            for (int j = js.begin; j < js.end; ++j) {
                if (facing == 0)
                    insert_points_on_edge_on_triangle(is, j, k, image);
                else
                    cross_row(facing, is, j, k, image, crossings);
            }
        }
    }

  private:
    static Vec2 xy(const Vec3& p) { return {p.x(), p.y()}; }
    static Vec2 xz(const Vec3& p) { return {p.x(), p.z()}; }
    static Vec2 yz(const Vec3& p) { return {p.y(), p.z()}; }

    IndexRange range(const VoxelGrid& grid, int axis) const {
        return indices_between(grid, axis, std::min({a_[axis], b_[axis], c_[axis]}),
                               std::max({a_[axis], b_[axis], c_[axis]}));
    }

    /// The side of the edge on which p lies once it is moved by (e, e^2), for a p on the edge's
    /// line.
    static int side_when_moved(const Vec2& from, const Vec2& to) {
        if (from.y() != to.y()) return to.y() < from.y() ? 1 : -1;
        return to.x() > from.x() ? 1 : -1;
    }

    /// `facing`: 1 when the normal has a positive x, -1 when negative.
    void cross_row(int facing, IndexRange is, int j, int k, VoxelImage& image,
                   std::vector<Crossing>& crossings) const {
        const VoxelGrid& grid = image.grid();
        const Vec2 line{grid.coordinate(1, j), grid.coordinate(2, k)};
        const std::array<Vec2, 4> corners{yz(a_), yz(b_), yz(c_), yz(a_)};
        bool crosses = true;
        for (std::size_t n = 0; n < 3; ++n) {
            const int side = orientation(corners[n], corners[n + 1], line);
            if (side == -facing) return;
            if (side == 0)
                crosses = crosses && side_when_moved(corners[n], corners[n + 1]) == facing;
        }
        const auto side_of_plane = [&](int i) {
            return facing * orientation(a_, b_, c_, grid.center({i, j, k}));
        };
        int first = is.begin;  // voxel behind the plane
        for (int end = is.end; first < end;) {
            const int middle = first + (end - first) / 2;
            if (side_of_plane(middle) > 0)
                end = middle;
            else
                first = middle + 1;
        }
        if (first > is.begin && side_of_plane(first - 1) == 0) image.insert({first - 1, j, k});
        if (crosses) crossings.push_back({k, j, first, -facing});
    }

    /// The rows are parallel to the triangle: moved, they never meet it.
    void insert_points_on_edge_on_triangle(IndexRange is, int j, int k, VoxelImage& image) const {
        const VoxelGrid& grid = image.grid();
        if (!is_on_line(yz(a_), yz(b_), yz(c_), yz(grid.center({0, j, k})))) return;
        const bool along_y = orientation(xy(a_), xy(b_), xy(c_)) != 0;
        const auto project = along_y ? xy : xz;
        for (int i = is.begin; i < is.end; ++i) {
            if (is_in_triangle(project(a_), project(b_), project(c_),
                               project(grid.center({i, j, k}))))
                image.insert({i, j, k});
        }
    }

    /// For a, b, c on a line or in one point, p in the box around them.
    static bool is_on_line(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
        return orientation(a, b, p) == 0 && orientation(b, c, p) == 0 && orientation(c, a, p) == 0;
    }

    /// False for triangles without area, whose points belong to their neighbors as well.
    static bool is_in_triangle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
        const int turn = orientation(a, b, c);
        return turn != 0 && orientation(a, b, p) != -turn && orientation(b, c, p) != -turn &&
               orientation(c, a, p) != -turn;
    }

    Vec3 a_, b_, c_;
};

/// Inserts what lies between crossings; of a row they follow each other in the order of x.
void fill(const std::vector<Crossing>& crossings, VoxelImage& image) {
    int winding = 0;
    for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
        const Crossing& from = crossings[n];
        const Crossing& to = crossings[n + 1];
        winding += from.inwards;
        if (from.k != to.k || from.j != to.j)
            winding = 0;  // it is: the mesh is closed
        else if (winding > 0)
            image.insert_run(from.first, to.first, from.j, from.k);
    }
}

}  // namespace

VoxelImage voxelize(const TriangleMesh& mesh, const VoxelGrid& grid) {
    VoxelImage image(grid);
    std::vector<Crossing> crossings;
    for (const auto& corners : mesh.triangles) Triangle(mesh, corners).scan(image, crossings);
    std::sort(crossings.begin(), crossings.end());
    fill(crossings, image);
    return image;
}

VoxelImage voxelize(const TriangleMesh& mesh, double spacing) {
    return voxelize(mesh, enclosing_grid(bounding_box(mesh), spacing));
}

}  // namespace dem::shapegen
