// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/wall/make_wall.hpp"

#include "common/error.hpp"
#include "common/format.hpp"
#include "common/math/elementary.hpp"
#include "shapegen/wall/wall_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

// Steps: what cannot touch is refused and what repeats left out; triangles are put into the order
// of the tree; half edges of the same ends become rings; fronts are made to agree from triangle to
// triangle; angles, patches and widths of blending follow.

namespace dem::shapegen {

namespace {

using Triangle = WallMesh::Triangle;

std::string place(const Vec3& p) {
    return format("(%.6g %.6g %.6g) m", p.x(), p.y(), p.z());
}

/// Below this share of the coordinates the height of a triangle is rounding, and its normal chance.
constexpr double least_height = 1e-13;

void check_triangle(const TriangleSoup& soup, std::size_t t) {
    const Vec3& a = soup.points[soup.triangles[t][0]];
    const Vec3& b = soup.points[soup.triangles[t][1]];
    const Vec3& c = soup.points[soup.triangles[t][2]];
    const std::string name = "triangle " + std::to_string(t) + " of the surface";
    if (!a.allFinite() || !b.allFinite() || !c.allFinite())
        throw Error("found a corner of " + name + " that is not a number, expected coordinates");
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const double height = longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0;
    const double size = std::max(
        {a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff(), longest});
    if (height > least_height * size) return;
    throw Error("found no area in " + name + ", with a corner at " + place(a) +
                ", expected triangles that have one");
}

/// The triangles but those with the corners of an earlier one.
std::vector<Triangle> without_repetitions(const TriangleSoup& soup, WallReport& report) {
    std::vector<std::pair<Triangle, std::size_t>> sorted;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        check_triangle(soup, t);
        Triangle corners = soup.triangles[t];
        std::sort(corners.begin(), corners.end());
        sorted.emplace_back(corners, t);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint8_t> repeats(sorted.size(), 0);
    for (std::size_t k = 1; k < sorted.size(); ++k)
        repeats[sorted[k].second] = sorted[k].first == sorted[k - 1].first ? 1 : 0;
    std::vector<Triangle> kept;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        if (repeats[t] == 0) kept.push_back(soup.triangles[t]);
    report.repeated = soup.triangles.size() - kept.size();
    return kept;
}

/// Sets of triangles that are joined one by one.
class Sets {
  public:
    explicit Sets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t of(std::uint32_t t) {
        while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
        return t;
    }
    /// The lower one stays the name of both.
    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a);
        b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    /// Numbers of the sets, in the order of their first triangles, one per triangle.
    std::vector<std::uint32_t> numbers(std::uint32_t& count) {
        std::vector<std::uint32_t> number(parent_.size());
        count = 0;
        for (std::uint32_t t = 0; t < parent_.size(); ++t)
            number[t] = of(t) == t ? count++ : number[of(t)];
        return number;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

class Maker {
  public:
    Maker(const TriangleSoup& soup, double crease_angle) : points_(soup.points) {
        made_.mesh.crease_angle = crease_angle;
        triangles_ = without_repetitions(soup, made_.report);
        if (triangles_.empty()) throw Error("found no triangles, expected a surface");
        made_.mesh.boxes = sort_into_tree(points_, triangles_);
    }

    MadeWall make() {
        link();
        agree_on_fronts();
        WallMesh& mesh = made_.mesh;
        mesh.vertices = points_;
        mesh.triangles = triangles_;
        mesh.twins = twins_;
        index_wall(mesh);  // the normals
        mesh.bends = bends();
        mesh.patches = patches();
        mesh.blends = blends();
        index_wall(mesh);
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const Vec3& a = mesh.corner(t, 0);
            made_.report.area += 0.5 * (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
        }
        return std::move(made_);
    }

  private:
    std::uint32_t half_edges() const { return static_cast<std::uint32_t>(3 * triangles_.size()); }
    std::uint32_t start(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
    std::uint32_t end(std::uint32_t h) const { return triangles_[h / 3][(h + 1) % 3]; }
    std::uint32_t opposite(std::uint32_t h) const { return triangles_[h / 3][(h + 2) % 3]; }
    bool is_pair(std::uint32_t h) const { return twins_[h] != h && twins_[twins_[h]] == h; }

    /// Rings of the half edges with the same ends.
    void link() {
        std::vector<std::array<std::uint32_t, 3>> sorted;  // lower end, upper end, half edge
        for (std::uint32_t h = 0; h < half_edges(); ++h)
            sorted.push_back({std::min(start(h), end(h)), std::max(start(h), end(h)), h});
        std::sort(sorted.begin(), sorted.end());
        twins_.resize(half_edges());
        for (std::size_t begin = 0; begin < sorted.size();) {
            std::size_t stop = begin + 1;
            while (stop < sorted.size() && sorted[stop][0] == sorted[begin][0] &&
                   sorted[stop][1] == sorted[begin][1])
                ++stop;
            for (std::size_t k = begin; k < stop; ++k)
                twins_[sorted[k][2]] = sorted[k + 1 < stop ? k + 1 : begin][2];
            if (stop == begin + 1) ++made_.report.rim_edges;
            if (stop > begin + 2) ++made_.report.joints;
            begin = stop;
        }
    }

    /// Turns triangles round, from the first of each piece on, so that those that share an edge in
    /// pairs run along it in opposite directions.
    void agree_on_fronts() {
        std::vector<std::uint8_t> seen(triangles_.size(), 0);
        std::vector<std::uint8_t> turned(triangles_.size(), 0);
        std::vector<std::uint32_t> queue;
        Sets pieces(triangles_.size());
        for (std::uint32_t seed = 0; seed < triangles_.size(); ++seed) {
            if (seen[seed] != 0) continue;
            seen[seed] = 1;
            queue.assign(1, seed);
            for (std::size_t n = 0; n < queue.size(); ++n) {
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const std::uint32_t h = 3 * queue[n] + k;
                    pieces.join(queue[n], twins_[h] / 3);
                    if (!is_pair(h)) continue;
                    const std::uint32_t other = twins_[h] / 3;
                    if (seen[other] != 0) continue;
                    const bool runs_along = start(h) == start(twins_[h]);
                    turned[other] = runs_along == (turned[queue[n]] == 0) ? 1 : 0;
                    seen[other] = 1;
                    queue.push_back(other);
                }
            }
        }
        static_cast<void>(pieces.numbers(piece_count_));
        made_.report.pieces = piece_count_;
        turn(turned);
    }

    /// Half edges keep their edges: corners 0 and 1 change places, and so do edges 1 and 2.
    void turn(const std::vector<std::uint8_t>& turned) {
        const auto now = [&](std::uint32_t h) {
            if (turned[h / 3] == 0 || h % 3 == 0) return h;
            return h % 3 == 1 ? h + 1 : h - 1;
        };
        std::vector<std::uint32_t> twins(twins_.size());
        for (std::uint32_t h = 0; h < half_edges(); ++h) twins[now(h)] = now(twins_[h]);
        twins_ = std::move(twins);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (turned[t] == 0) continue;
            std::swap(triangles_[t][0], triangles_[t][1]);
            ++made_.report.turned;
        }
    }

    double bend(std::uint32_t h) const {
        if (!is_pair(h) || start(h) == start(twins_[h])) return WallMesh::sharp;
        const Vec3& n = made_.mesh.normals[h / 3];
        const Vec3& m = made_.mesh.normals[twins_[h] / 3];
        const double angle = math::atan2(n.cross(m).norm(), n.dot(m));
        const Vec3 beyond = points_[opposite(twins_[h])] - points_[start(h)];
        return beyond.dot(n) <= 0.0 ? angle : -angle;
    }

    std::vector<double> bends() {
        std::vector<double> result(half_edges());
        WallReport& report = made_.report;
        for (std::uint32_t h = 0; h < half_edges(); ++h) {
            // Both half edges of an edge say the same, to the bit.
            result[h] = is_pair(h) && twins_[h] < h ? result[twins_[h]] : bend(h);
            if (!is_pair(h) || twins_[h] < h) continue;
            if (start(h) == start(twins_[h])) {
                ++report.seams;
                continue;
            }
            if (std::abs(result[h]) < level_bend) continue;
            ++(result[h] > 0.0 ? report.convex : report.concave);
            if (std::abs(result[h]) > made_.mesh.crease_angle) ++report.creases;
        }
        return result;
    }

    bool is_smooth(std::uint32_t h) const {
        return is_pair(h) && start(h) != start(twins_[h]) && made_.mesh.is_smooth(h);
    }

    std::vector<std::uint32_t> patches() {
        Sets sets(triangles_.size());
        for (std::uint32_t h = 0; h < half_edges(); ++h)
            if (is_smooth(h)) sets.join(h / 3, twins_[h] / 3);
        return sets.numbers(patch_count_);
    }

    double height_over(std::uint32_t h) const {
        const Vec3 edge = points_[end(h)] - points_[start(h)];
        const Vec3 up = points_[opposite(h)] - points_[start(h)];
        return edge.cross(up).norm() / edge.norm();
    }

    /// Planes that bend by an angle differ by it times the distance from their edge: half of the
    /// lowest height over an edge is the middle of the triangle there.
    std::vector<double> blends() const {
        const WallMesh& mesh = made_.mesh;
        std::vector<double> result(patch_count_, std::numeric_limits<double>::max());
        for (std::uint32_t h = 0; h < half_edges(); ++h) {
            const double angle = std::abs(mesh.bends[h]);
            if (!is_smooth(h) || angle < level_bend) continue;
            double& blend = result[mesh.patches[h / 3]];
            blend = std::min(blend, 0.5 * angle * height_over(h));
        }
        for (double& blend : result)
            if (blend == std::numeric_limits<double>::max()) blend = 0.0;
        return result;
    }

    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> twins_;
    std::uint32_t patch_count_ = 0;
    std::uint32_t piece_count_ = 0;
    MadeWall made_;
};

}  // namespace

MadeWall make_wall(const TriangleSoup& soup, double crease_angle) {
    return Maker(soup, crease_angle).make();
}

}  // namespace dem::shapegen
