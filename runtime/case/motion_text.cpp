// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/motion_text.hpp"

#include "runtime/walls/pose_table.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace dem::runtime {

namespace {

std::string text(const Vec3& v) {
    std::ostringstream out;
    out << std::setprecision(4) << "(" << v.x() << " " << v.y() << " " << v.z() << ")";
    return out.str();
}

void describe(const MotionPiece& piece, std::ostringstream& out) {
    switch (piece.kind) {
        case MotionPiece::Kind::translate:
            out << "moves at " << text(piece.velocity) << " m/s";
            if (piece.ramp > 0.0) out << ", at first " << text(piece.initial_velocity) << " m/s";
            break;
        case MotionPiece::Kind::rotate:
            out << "turns at " << piece.rate << " rad/s about " << text(piece.axis) << " through "
                << text(piece.point) << " m";
            if (piece.ramp > 0.0) out << ", at first " << piece.initial_rate << " rad/s";
            break;
        case MotionPiece::Kind::oscillate:
            out << "swings by " << piece.amplitude << " m along " << text(piece.axis) << " at "
                << piece.frequency << " Hz";
            break;
        case MotionPiece::Kind::table:
            out << "goes through " << piece.table->size() << " poses";
            break;
    }
    if (piece.ramp > 0.0)
        out << ", " << (piece.is_ramp_smooth ? "smooth" : "linear") << " ramp of " << piece.ramp
            << " s";
    out << ", from " << piece.from << " s";
    if (!std::isinf(piece.until)) out << " until " << piece.until << " s";
}

void describe(const Motion& motion, std::ostringstream& out) {
    for (std::size_t k = 0; k < motion.pieces.size(); ++k) {
        if (k > 0) out << "; ";
        describe(motion.pieces[k], out);
    }
    if (motion.pieces.empty()) out << "stands";
    if (motion.from_settled) out << (motion.pieces.empty() ? "" : ", after the bodies settle");
    if (motion.start > 0.0) out << ", counted from " << motion.start << " s";
    if (!std::isinf(motion.period)) out << ", again every " << motion.period << " s";
    if (motion.within) out << ", within " << motion.within->name;
}

/// "drum" of the face "drum.top".
std::string section_of(const Wall& wall) {
    return wall.name.substr(0, wall.name.find('.'));
}

/// The sections of walls for which `fits`, each once.
template <class Fits>
std::vector<std::string> sections(const Scene& scene, const Fits& fits) {
    std::vector<std::string> names;
    for (const Wall& wall : scene.walls) {
        if (fits(wall) && (names.empty() || names.back() != section_of(wall)))
            names.push_back(section_of(wall));
    }
    return names;
}

/// Whether a motion carries others.
bool carries(const Scene& scene, const std::string& name) {
    return std::ranges::any_of(scene.motions, [&](const Motion& motion) {
        return motion.within && motion.within->name == name;
    });
}

void describe_named(const Scene& scene, const Motion& motion, std::ostringstream& out) {
    out << "motion " << motion.name << ": ";
    describe(motion, out);
    const auto walls =
        sections(scene, [&](const Wall& wall) { return wall.motion.name == motion.name; });
    for (std::size_t k = 0; k < walls.size(); ++k) out << (k == 0 ? " (" : ", ") << walls[k];
    out << (walls.empty() ? "\n" : ")\n");
    if (walls.empty() && !carries(scene, motion.name))
        out << "warning: no wall takes motion " << motion.name << "\n";
}

}  // namespace

std::string motion_text(const Scene& scene) {
    std::ostringstream out;
    out << std::setprecision(4);
    for (const Motion& motion : scene.motions) describe_named(scene, motion, out);
    std::string before;
    for (const Wall& wall : scene.walls) {
        const std::string section = section_of(wall);
        if (section == before) continue;
        before = section;
        if (wall.motion.name.empty() && wall.motion.moves()) {
            out << "motion of wall " << section << ": ";
            describe(wall.motion, out);
            out << "\n";
        }
    }
    const auto belts =
        sections(scene, [](const Wall& wall) { return !wall.surface_velocity.isZero(0.0); });
    for (const std::string& name : belts) out << "surface of wall " << name << " moves\n";
    return out.str();
}

}  // namespace dem::runtime
