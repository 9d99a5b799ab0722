// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/shells.hpp"

#include "shapegen/repair/shell_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace dem::shapegen {
namespace {

bool is_hollow(const Shell& shell) {
    return shell.depth % 2 == 1;
}

/// Bodies outward, hollows into themselves.
void orient(std::vector<Shell>& shells, RepairReport& report) {
    Finding inside_out{.what = "shells turned inside out", .treatment = "turned"};
    Finding ambiguous{.what = "inner shells facing like the shell around them",
                      .treatment = "taken as hollows (--union: as parts)"};
    const auto note = [](Finding& finding, const Shell& shell, double volume) {
        if (finding.count++ == 0) finding.place = shell.surface.vertices.front();
        finding.volume += volume;
    };
    for (const Shell& shell : shells) {
        if (!is_hollow(shell)) {
            if (shell.is_turned()) note(inside_out, shell, 0.0);
        } else if (shell.is_turned() == shells[shell.parent].is_turned()) {
            // Or a part of the solid drawn twice: what is at stake is the hollow.
            note(ambiguous, shell, std::abs(shell.volume));
        }
    }
    for (Shell& shell : shells)
        if (shell.is_turned() != is_hollow(shell)) shell.turn();
    for (Finding& finding : {std::ref(inside_out), std::ref(ambiguous)})
        if (finding.count > 0) report.findings.push_back(finding);
}

/// The body that each shell belongs to: itself or the one around the hollow.
std::size_t body_of(const std::vector<Shell>& shells, std::size_t shell) {
    return is_hollow(shells[shell]) ? shells[shell].parent : shell;
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
    std::vector<Shell> shells = split_shells(mesh).list;
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
        Finding& finding = is_hollow(shells[s]) ? hollows : others;
        const bool counts = is_hollow(shells[s]) ? shells[s].parent == largest : s != largest;
        if (!counts) continue;
        if (finding.count++ == 0) finding.place = shells[s].surface.vertices.front();
        if (!is_hollow(shells[s])) finding.volume += body_volume[s];
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

}  // namespace dem::shapegen
