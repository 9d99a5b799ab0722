// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/clump/convergence.hpp"

#include <array>
#include <cstdio>

namespace dem::shapegen {

std::vector<ConvergenceRow> convergence(ClumpMaker& maker, std::size_t most) {
    std::vector<std::size_t> counts;
    for (std::size_t power = 1; power < most; power *= 2) {
        counts.push_back(power);
        if (power > 1 && power + power / 2 < most) counts.push_back(power + power / 2);
    }
    counts.push_back(most);
    std::vector<ConvergenceRow> rows;
    for (const std::size_t count : counts) {
        CoverGoal goal;
        goal.count = count;
        const BuiltClump clump = maker.clump(goal);
        rows.push_back({clump.balls.size(), clump.quality});
        if (clump.balls.size() < count) break;  // more add nothing
    }
    return rows;
}

std::string convergence_csv(const std::vector<ConvergenceRow>& rows) {
    std::string text =
        "spheres,coverage,outside,volume_ratio,rms_deviation,max_deviation_in,max_deviation_out,"
        "moment_errors_x,moment_errors_y,moment_errors_z,slope_rms\n";
    for (const auto& [spheres, q] : rows) {
        std::array<char, 300> line{};
        std::snprintf(line.data(), line.size(),
                      "%zu,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", spheres,
                      q.coverage, q.outside, q.volume_ratio, q.rms_deviation, q.max_deviation_in,
                      q.max_deviation_out, q.moment_errors.x(), q.moment_errors.y(),
                      q.moment_errors.z(), q.slope_rms * 180.0 / pi);
        text += line.data();
    }
    return text;
}

}  // namespace dem::shapegen
