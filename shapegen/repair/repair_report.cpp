// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/repair/repair_report.hpp"

#include <iomanip>
#include <sstream>

namespace dem::shapegen {

void RepairReport::add(const Finding& finding) {
    if (finding.count == 0) return;
    for (Finding& other : findings)
        if (other.what == finding.what && other.treatment == finding.treatment) {
            other.count += finding.count;
            other.volume += finding.volume;
            return;
        }
    findings.push_back(finding);
}

double RepairReport::changed_fraction() const {
    double sum = 0.0;
    for (const Finding& finding : findings) sum += finding.volume;
    return volume > 0.0 ? sum / volume : 0.0;
}

std::string percentage(double fraction) {
    std::ostringstream out;
    constexpr double most = 10.0;  // beyond, the volume itself means nothing
    if (fraction > most) return "more than 1000 %";
    if (fraction >= 0.1) {
        out << std::fixed << std::setprecision(0);
    } else {
        out << std::setprecision(2);
    }
    out << 100.0 * fraction << " %";
    return out.str();
}

std::string describe(const Finding& finding, double file_unit, double volume) {
    std::ostringstream out;
    const Vec3 place = finding.place / file_unit;
    out << finding.what << ": " << finding.count << (finding.count > 1 ? ", one at (" : " at (")
        << std::setprecision(6) << place.x() << ", " << place.y() << ", " << place.z() << "), ";
    if (finding.volume > 0.0 && volume > 0.0)
        out << percentage(finding.volume / volume) << " of the volume, ";
    out << finding.treatment;
    return out.str();
}

std::vector<std::string> describe(const RepairReport& report, double file_unit) {
    std::vector<std::string> lines;
    for (const Finding& finding : report.findings)
        lines.push_back(describe(finding, file_unit, report.volume));
    if (report.changed_fraction() > 0.0)
        lines.push_back("repairs may have changed " + percentage(report.changed_fraction()) +
                        " of the volume");
    return lines;
}

}  // namespace dem::shapegen
