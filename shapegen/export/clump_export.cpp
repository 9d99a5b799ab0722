// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/export/clump_export.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/text.hpp"
#include "formats/number_text.hpp"

#include <algorithm>

namespace dem::shapegen {

namespace {

const Clump& clump_of(const ParticleTemplate& shape) {
    if (const auto* clump = std::get_if<Clump>(&shape.shape)) return *clump;
    throw Error(shape.name,
                "found a shape of kind " + in_quotes(kind_name(shape)) + ", expected a clump");
}

std::string join(std::initializer_list<double> values, const char* separator) {
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += separator;
        text += number_text(value);
    }
    return text;
}

struct Body {
    const ParticleTemplate& shape;
    const Clump& clump;
    double density;

    double mass() const { return density * shape.mass_properties.volume; }
    Vec3 moments() const { return density * shape.mass_properties.principal_moments_per_density; }
    std::string title() const {
        return shape.name + ": clump of " + std::to_string(clump.spheres.size()) +
               " spheres, SI units, body frame, density " + number_text(density) + " kg/m^3";
    }
    std::string inertia(const char* separator) const {
        const Vec3 m = moments();
        return join({m.x(), m.y(), m.z()}, separator);
    }
};

/// `spheres file` of fix particletemplate/multisphere.
std::string liggghts(const Body& body) {
    const Vec3 m = body.moments();
    std::string text = "# " + body.title() +
                       "\n# fix ID all particletemplate/multisphere SEED atom_type TYPE" +
                       " density constant " + number_text(body.density) + " nspheres " +
                       std::to_string(body.clump.spheres.size()) +
                       " ntry 1000000 spheres file FILE scale 1 mass " + number_text(body.mass()) +
                       " inertia_tensor " + join({m.x(), 0.0, 0.0, m.y(), 0.0, m.z()}, " ") +
                       " use_volume type 1\n";
    for (const ClumpSphere& s : body.clump.spheres)
        text += join({s.x, s.y, s.z, s.radius}, " ") + '\n';
    return text;
}

/// A file for the molecule command: mass, center and inertia are given, as the spheres overlap.
std::string lammps(const Body& body) {
    const auto& spheres = body.clump.spheres;
    const Vec3 m = body.moments();
    std::string text = body.title() + "\n\n" + std::to_string(spheres.size()) + " atoms\n" +
                       number_text(body.mass()) + " mass\n0 0 0 com\n" +
                       join({m.x(), m.y(), m.z(), 0.0, 0.0, 0.0}, " ") + " inertia\n";
    const auto section = [&](const char* name, const auto& value) {
        text += std::string("\n") + name + "\n\n";
        for (std::size_t i = 0; i < spheres.size(); ++i)
            text += std::to_string(i + 1) + ' ' + value(spheres[i]) + '\n';
    };
    // No atom may be without mass; what is added is below the rounding of the sum.
    const double least = 1e-14 * body.mass();
    section("Coords", [](const ClumpSphere& s) { return join({s.x, s.y, s.z}, " "); });
    section("Types", [](const ClumpSphere&) { return std::string("1"); });
    section("Diameters", [](const ClumpSphere& s) { return number_text(2.0 * s.radius); });
    section("Masses", [&](const ClumpSphere& s) {
        return number_text(std::max(body.density * s.volume_share, least));
    });
    return text;
}

/// For ymport.textClumps, which reads x y z r clump. YADE adds masses up itself, as many times as
/// spheres overlap; the densities of the last column make the sums those of the body.
std::string yade(const Body& body) {
    std::string text =
        "# " + body.title() + "\n# geometry alone: ymport.textClumps(FILE)\n# with mass " +
        number_text(body.mass()) + " and inertia " + body.inertia(" ") +
        ", a material for each sphere:\n"
        "# O.bodies.appendClumped([utils.sphere(c[:3], c[3], material=FrictMat(density=c[5]))"
        " for c in numpy.loadtxt(FILE)])\n"
        "# x y z r clump density\n";
    for (const ClumpSphere& s : body.clump.spheres) {
        const double volume = 4.0 / 3.0 * pi * cube(s.radius);
        text += join({s.x, s.y, s.z, s.radius, 0.0, body.density * s.volume_share / volume}, " ") +
                '\n';
    }
    return text;
}

/// For LoadClumpType(mass, moments, FILE, material).
std::string dem_engine(const Body& body) {
    std::string text = "x,y,z,r\n";
    for (const ClumpSphere& s : body.clump.spheres)
        text += join({s.x, s.y, s.z, s.radius}, ",") + '\n';
    return text + "# " + body.title() + "\n# mass = " + number_text(body.mass()) +
           "\n# Ixx, Iyy, Izz = " + body.inertia(", ") + '\n';
}

/// The folder that MClump makes of a clump.
void write_mercurydpm(const std::filesystem::path& folder, const Body& body) {
    std::error_code problem;
    if (std::filesystem::exists(folder) &&
        !(std::filesystem::is_directory(folder) && std::filesystem::is_empty(folder)))
        throw Error(folder.string(), "exists, expected the name of a new folder");
    for (const char* name : {"clump", "inertia"}) {
        std::filesystem::create_directories(folder / name, problem);
        if (problem)
            throw Error((folder / name).string(), "cannot make this folder: " + problem.message() +
                                                      ", expected another place (-o)");
    }
    std::string pebbles;
    for (const ClumpSphere& s : body.clump.spheres)
        pebbles += join({s.x, s.y, s.z, s.radius}, ",") + '\n';
    const Vec3 m = body.moments();
    const auto matrix = [](const Vec3& diagonal) {
        std::string text;
        for (int i = 0; i < 3; ++i) {
            Vec3 row = Vec3::Zero();
            row[i] = diagonal[i];
            text += join({row.x(), row.y(), row.z()}, ",") + '\n';
        }
        return text;
    };
    write_file(folder / "clump" / "clump.txt", pebbles);
    write_file(folder / "inertia" / "mass.txt", number_text(body.mass()) + '\n');
    write_file(folder / "inertia" / "toi.txt", matrix(m));
    write_file(folder / "inertia" / "pd.txt", matrix(Vec3::Ones()));
}

}  // namespace

void write_clump_csv(const std::filesystem::path& path, const ParticleTemplate& shape,
                     const InputFrame& frame) {
    std::string text = "x,y,z,radius,mass\n";
    for (const ClumpSphere& s : clump_of(shape).spheres) {
        const Vec3 c = frame.point(s.center());
        text +=
            join({c.x(), c.y(), c.z(), frame.length(s.radius), s.volume_share / cube(frame.unit())},
                 ",") +
            '\n';
    }
    write_file(path, text);
}

const std::vector<std::string>& clump_formats() {
    static const std::vector<std::string> names{"liggghts", "lammps", "yade", "mercurydpm",
                                                "dem-engine"};
    return names;
}

void write_clump_file(const std::filesystem::path& path, const ParticleTemplate& shape,
                      const std::string& format, double density) {
    const Body body{shape, clump_of(shape), density};
    if (format == "liggghts") {
        write_file(path, liggghts(body));
    } else if (format == "lammps") {
        write_file(path, lammps(body));
    } else if (format == "yade") {
        write_file(path, yade(body));
    } else if (format == "dem-engine") {
        write_file(path, dem_engine(body));
    } else if (format == "mercurydpm") {
        write_mercurydpm(path, body);
    } else {
        throw UsageError("--format",
                         "found " + in_quotes(format) +
                             ", expected liggghts, lammps, yade, mercurydpm or dem-engine" +
                             suggestion(format, clump_formats()));
    }
}

}  // namespace dem::shapegen
