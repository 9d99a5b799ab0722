// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/shells.hpp"

#include "shapegen/surface/surface_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

namespace dem {
namespace {

constexpr std::size_t no_shell = ~std::size_t{0};

struct Shell {
    TriangleMesh surface;
    double volume = 0.0;  ///< as the file orients it; negative: inside out [m^3]
    Aabb box;
    std::size_t depth = 0;          ///< number of shells around it
    std::size_t parent = no_shell;  ///< the smallest shell around it

    bool is_hollow() const { return depth % 2 == 1; }
};

void turn(TriangleMesh& mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

/// The lowest vertex connected with each vertex.
std::vector<std::uint32_t> connected_roots(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&root](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const auto& [i, j, k] : mesh.triangles)
        for (const std::uint32_t other : {j, k}) {
            const std::uint32_t a = find(i);
            const std::uint32_t b = find(other);
            root[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = find(v);
    return root;
}

/// In falling order of volume.
std::vector<Shell> split(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> root = connected_roots(mesh);
    std::vector<std::size_t> shell_of(mesh.vertices.size(), no_shell);
    std::vector<std::uint32_t> position(mesh.vertices.size());
    std::vector<Shell> shells;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (shell_of[root[v]] == no_shell) {
            shell_of[root[v]] = shells.size();
            shells.emplace_back();
        }
        shell_of[v] = shell_of[root[v]];
        TriangleMesh& surface = shells[shell_of[v]].surface;
        position[v] = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.push_back(mesh.vertices[v]);
    }
    for (const auto& [i, j, k] : mesh.triangles)
        shells[shell_of[i]].surface.triangles.push_back({position[i], position[j], position[k]});
    for (Shell& shell : shells) {
        shell.volume = enclosed_volume(shell.surface);
        shell.box = bounding_box(shell.surface);
    }
    std::stable_sort(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) {
        return std::abs(a.volume) > std::abs(b.volume);
    });
    return shells;
}

/// Depth and parent of every shell. Shells do not cross, so one point of a shell that is not on the
/// other decides.
void nest(std::vector<Shell>& shells) {
    for (std::size_t outer = 0; outer < shells.size(); ++outer) {
        std::vector<std::size_t> candidates;
        for (std::size_t inner = outer + 1; inner < shells.size(); ++inner)
            if (shells[outer].box.contains(shells[inner].box.lower) &&
                shells[outer].box.contains(shells[inner].box.upper))
                candidates.push_back(inner);
        if (candidates.empty()) continue;
        TriangleMesh outward = shells[outer].surface;
        if (shells[outer].volume < 0.0) turn(outward);
        const SurfaceQuery query(std::move(outward));
        for (const std::size_t inner : candidates) {
            const auto& points = shells[inner].surface.vertices;
            const auto decisive = std::find_if(points.begin(), points.end(), [&](const Vec3& p) {
                return query.distance(p) > 0.0;
            });
            if (decisive == points.end() || !query.is_inside(*decisive)) continue;
            ++shells[inner].depth;
            shells[inner].parent = outer;  // the last one to come is the smallest
        }
    }
}

/// Bodies outward, hollows into themselves.
void orient(std::vector<Shell>& shells, RepairReport& report) {
    Finding inside_out{.what = "shells turned inside out", .treatment = "turned"};
    Finding ambiguous{.what = "inner shells facing like the shell around them",
                      .treatment = "taken as hollows"};
    const auto note = [](Finding& finding, const Shell& shell, double volume) {
        if (finding.count++ == 0) finding.place = shell.surface.vertices.front();
        finding.volume += volume;
    };
    for (const Shell& shell : shells) {
        if (!shell.is_hollow()) {
            if (shell.volume < 0.0) note(inside_out, shell, 0.0);
        } else if ((shell.volume < 0.0) == (shells[shell.parent].volume < 0.0)) {
            // Or a part of the solid drawn twice: what is at stake is the hollow.
            note(ambiguous, shell, std::abs(shell.volume));
        }
    }
    for (Shell& shell : shells)
        if ((shell.volume < 0.0) != shell.is_hollow()) {
            turn(shell.surface);
            shell.volume = -shell.volume;
        }
    for (Finding& finding : {std::ref(inside_out), std::ref(ambiguous)})
        if (finding.count > 0) report.findings.push_back(finding);
}

/// The body that each shell belongs to: itself or the one around the hollow.
std::size_t body_of(const std::vector<Shell>& shells, std::size_t shell) {
    return shells[shell].is_hollow() ? shells[shell].parent : shell;
}

TriangleMesh put_together(const std::vector<Shell>& shells, std::size_t body) {
    TriangleMesh mesh;
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (body_of(shells, s) != body) continue;
        const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
        const TriangleMesh& surface = shells[s].surface;
        mesh.vertices.insert(mesh.vertices.end(), surface.vertices.begin(), surface.vertices.end());
        for (const auto& [i, j, k] : surface.triangles)
            mesh.triangles.push_back({i + shift, j + shift, k + shift});
    }
    return mesh;
}

}  // namespace

std::vector<Finding> keep_one_body(TriangleMesh& mesh, const ShellOptions& options,
                                   RepairReport& report) {
    std::vector<Shell> shells = split(mesh);
    if (shells.size() > 1) nest(shells);
    orient(shells, report);

    std::vector<double> body_volume(shells.size(), 0.0);
    for (std::size_t s = 0; s < shells.size(); ++s)
        body_volume[body_of(shells, s)] += shells[s].volume;
    const auto largest = static_cast<std::size_t>(
        std::max_element(body_volume.begin(), body_volume.end()) - body_volume.begin());
    Finding others{.what = "separate bodies", .treatment = "left out"};
    Finding hollows{.what = "hollows", .treatment = "kept"};
    for (std::size_t s = 0; s < shells.size(); ++s) {
        Finding& finding = shells[s].is_hollow() ? hollows : others;
        const bool counts = shells[s].is_hollow() ? shells[s].parent == largest : s != largest;
        if (!counts) continue;
        if (finding.count++ == 0) finding.place = shells[s].surface.vertices.front();
        if (!shells[s].is_hollow()) finding.volume += body_volume[s];
    }
    report.volume = body_volume[largest];
    const bool are_small = others.volume <= options.limit * body_volume[largest];
    if (others.count > 0 && !are_small && !options.keep_largest) {
        others.what += " beside the largest";
        others.treatment = "expected one body; --largest keeps the largest only";
        return {others};
    }
    if (options.keep_largest && others.count > 0) {
        // Asked for: nothing that a limit is about.
        char words[64];
        std::snprintf(words, sizeof words, "left out, %.3g %% of the volume of the largest",
                      100.0 * others.volume / body_volume[largest]);
        others.treatment = words;
        others.volume = 0.0;
    }
    for (const Finding& finding : {hollows, others})
        if (finding.count > 0) report.findings.push_back(finding);
    if (shells.size() > 1 || !report.findings.empty()) mesh = put_together(shells, largest);
    return {};
}

}  // namespace dem
