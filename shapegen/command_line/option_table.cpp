// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/shapes/clump.hpp"
#include "shapegen/command_line/option.hpp"
#include "shapegen/pipeline/cook.hpp"
#include "shapegen/profile/shape_parameters.hpp"

namespace dem::shapegen {

namespace {

using enum OptionType;

// Ways to make a shape, of which a command line takes one.
constexpr OtherOptions other_modes{"sr|sphere|clump|clump-spheres|clump-error|convex|wall"};

constexpr OtherOptions a_revolution{"sr",
                                    "with a shape of another kind, expected it with --sr only"};
constexpr OtherOptions a_clump{
    "clump|clump-spheres|clump-error",
    "without --clump, --clump-spheres or --clump-error, expected one of them"};
constexpr OtherOptions a_wall{"wall", "without --wall, expected both"};
constexpr OtherOptions a_convex_shape{"convex", "without --convex, expected both"};

constexpr OptionRange cells{fewest_base_cells, most_cells};
constexpr OptionRange above_zero{.low_allowed = false};
constexpr OptionRange between_zero_and_one{0.0, 1.0, false, false};
constexpr OptionRange up_to_half{.high = 0.5, .high_allowed = false};

constexpr Option common_options[] = {
    {.name = "threads",
     .value = "N",
     .type = count,
     .range = {0, 4096},
     .standard = "0",
     .help = "at most so many; 0: one per core; never changes a result"},
    {.name = "help", .letter = 'h', .help = "print this and stop"},
    {.name = "man", .help = "print the manual page and stop: shapegen --man | man -l -"},
    {.name = "version", .help = "print the version and stop"},
};

constexpr Option cook_options[] = {
    {.name = "output",
     .letter = 'o',
     .value = "OUT.tpl",
     .type = text,
     .help = "the template to write; default: INPUT's name with .tpl, here"},
    {.name = "scale",
     .value = "S",
     .type = number,
     .range = above_zero,
     .standard = "1",
     .expected = "a number above 0",
     .help = "multiply all lengths of INPUT"},
    {.name = "quiet", .letter = 'q', .help = "print nothing but errors"},
};

constexpr Option revolution_options[] = {
    {.name = "sr",
     .excludes = other_modes,
     .help = "as a surface of revolution: the default for a profile"},
    {.name = "sphere",
     .excludes = other_modes,
     .help = "as an exact sphere; the profile must be one"},
    {.name = "nodes",
     .value = "N",
     .type = count,
     .range = {fewest_nodes, most_nodes},
     .standard = "2000",
     .needs = a_revolution,
     .help = "surface nodes"},
    {.name = "base-cells",
     .value = "N",
     .type = count,
     .range = cells,
     .standard = "50",
     .needs = a_revolution,
     .help = "distance-field cells per major axis: everywhere"},
    {.name = "interface-cells",
     .value = "N",
     .type = count,
     .range = cells,
     .standard = "200",
     .needs = a_revolution,
     .help = "... near the surface; a power of two times the base cells"},
    {.name = "corner-cells",
     .value = "N",
     .type = count,
     .range = cells,
     .standard = "800",
     .needs = a_revolution,
     .help = "... at sharp edges; a power of two times the interface cells"},
};

constexpr Option clump_options[] = {
    {.name = "clump",
     .value = "C",
     .type = fraction,
     .range = between_zero_and_one,
     .expected = "a coverage above 0 and below 1 (0.95 or 95%)",
     .excludes = other_modes,
     .help = "spheres that cover this much of the volume"},
    {.name = "clump-spheres",
     .value = "N",
     .type = count,
     .range = {1, Clump::most_spheres},
     .excludes = other_modes,
     .help = "this many spheres"},
    {.name = "clump-error",
     .value = "E%",
     .type = percents,
     .range = between_zero_and_one,
     .expected = "an RMS deviation above 0% and below 100% of the equivalent diameter (0.5%)",
     .excludes = other_modes,
     .help = "as few spheres as keep the RMS deviation of the surface below E % of the equivalent "
             "diameter d_eq"},
    {.name = "inscribed",
     .needs = a_clump,
     .excludes = {"protrusion"},
     .help = "no sphere leaves the body: leaves out the fit"},
    {.name = "protrusion",
     .value = "P%",
     .type = fraction,
     .range = up_to_half,
     .standard = "1%",
     .expected = "0 or more and below 50 % of the equivalent diameter (1%)",
     .needs = a_clump,
     .help = "how far a fitted sphere may stand out, of d_eq"},
    {.name = "min-radius",
     .value = "R",
     .type = text,
     .expected = "a length with its unit (0.2 mm) or a percentage of the equivalent diameter (2%)",
     .needs = a_clump,
     .help = "no smaller spheres"},
    {.name = "skeleton",
     .value = "KIND",
     .type = choice,
     .standard = "surface",
     .words = "surface|curve",
     .needs = a_clump,
     .help = "where spheres are sought first; curve for long thin bodies"},
    {.name = "resolution",
     .value = "N",
     .type = count,
     .range = {10, 500},
     .needs = a_clump,
     .help = "voxels per d_eq for the skeleton; default: 60, for a --clump of 0.9 or more 100, "
             "which is good for more than a few hundred spheres in the other modes, too"},
    {.name = "convergence",
     .value = "FILE",
     .type = text,
     .expected = ".csv or .svg",
     .needs = a_clump,
     .help = "also write what 1, 2, 3, 4, 6, ... spheres reach: a table or a plot"},
};

constexpr Option convex_options[] = {
    {.name = "convex",
     .excludes = other_modes,
     .help = "the hull of a mesh, or a profile that is a sphere, spheroid, cylinder, cone or "
             "spherocylinder; not needed for a .convex file"},
    {.name = "vertices",
     .value = "N",
     .type = count,
     .range = {4, 100'000},
     .needs = a_convex_shape,
     .for_meshes = true,
     .help = "of a mesh's hull keep N vertices, those that matter most"},
    {.name = "keep-volume",
     .needs = a_convex_shape,
     .for_meshes = true,
     .help = "scale what the hull, --vertices and the rounding leave to the volume of the mesh"},
    {.name = "rounding",
     .value = "R",
     .type = text,
     .expected = "a length with its unit (0.1 mm) or a percentage of the equivalent diameter (1%)",
     .needs = a_convex_shape,
     .help = "radius of edges and corners; default: 1%, less for thin bodies"},
};

constexpr Option wall_options[] = {
    {.name = "wall",
     .excludes = other_modes,
     .help = "the triangles of a mesh as a wall for [wall.NAME] with shape = mesh: open or closed, "
             "touched from both sides; nothing is repaired"},
    {.name = "crease",
     .value = "ANGLE",
     .type = quantity,
     .range = {0.0, 2.0, true, true},
     .dimension = Dimension::angle,
     .standard = "25 deg",
     .expected = "an angle from 0 to 114 degrees (25 deg)",
     .needs = a_wall,
     .help = "faces that bend by no more are parts of one curved wall, others two walls that meet"},
};

constexpr Option mesh_options[] = {
    {.name = "unit",
     .value = "UNIT",
     .type = text,
     .expected = "m, mm, um, cm or in",
     .for_meshes = true,
     .help = "of the file's coordinates; default: mm, m for glTF"},
    {.name = "repair-limit",
     .value = "F",
     .type = fraction,
     .range = {.high = 1.0, .high_allowed = false},
     .standard = "1%",
     .expected = "0 or more and below 1 (0.01 or 1%)",
     .excludes = {"wall"},
     .for_meshes = true,
     .help = "largest part of the volume that repairs may put at stake"},
    {.name = "largest",
     .excludes = {"wall"},
     .for_meshes = true,
     .help = "of several bodies in a file keep the largest"},
    {.name = "union",
     .excludes = {"wall"},
     .for_meshes = true,
     .help = "make one body of parts that cross, touch or hold each other"},
};

constexpr Option generate_options[] = {
    {.name = "count",
     .value = "N",
     .type = count,
     .range = {1, 1e9},
     .required = true,
     .help = "how many shapes, no two alike"},
    {.name = "output",
     .letter = 'o',
     .value = "OUT.tpl",
     .type = text,
     .required = true,
     .help = "the library to write"},
    {.name = "seed",
     .value = "S",
     .type = count,
     .standard = "1",
     .help = "another seed, other shapes; a longer library begins with the shapes of a shorter "
             "one"},
    {.name = "template",
     .value = "BASE",
     .type = choice,
     .words = "sphere|ellipsoid",
     .help = "sand: what the corners lie on; default: sphere"},
    {.name = "size",
     .value = "D",
     .type = quantity,
     .range = {least_length, most_length},
     .dimension = Dimension::length,
     .expected = "a length above 0, from 1e-12 to 1e6 m",
     .help = "sand: diameter of the sphere, or of the sphere of the ellipsoid's volume; default: "
             "5 mm; woodchips: mean length; default: 6 mm"},
    {.name = "rounding",
     .value = "R",
     .type = text,
     .expected = "a length with its unit (0.1 mm) or a percentage of the equivalent diameter (1%)",
     .help = "radius of edges and corners; default: 1%"},
    {.name = "quiet", .letter = 'q', .help = "print nothing but errors"},
};

constexpr Option inspect_options[] = {{.name = "json", .help = "print JSON"}};

constexpr Option export_options[] = {
    {.name = "output",
     .letter = 'o',
     .value = "FILE",
     .type = text,
     .required = true,
     .help = "the file to write, in the frame and the unit of the input. Clump: .csv spheres; .stl "
             "spheres as triangles; .vtu or .obj body and clump; .svg picture of both, colored by "
             "deviation. Other shapes: .stl, .vtu or .obj display mesh; .svg picture. Surface of "
             "revolution: .csv surface nodes. Library: .svg of the first 25 shapes"},
    {.name = "unit",
     .value = "UNIT",
     .type = text,
     .expected = "m, mm, um, cm or in",
     .excludes = {"format", "expected it without: such files are in SI units"},
     .help = "of lengths in tables and surfaces; default: the input's, a --scale included; m where "
             "there was none (generate)"},
    {.name = "format",
     .value = "CODE",
     .type = text,
     .expected = "liggghts, lammps, yade, mercurydpm (a folder) or dem-engine",
     .help = "a clump as a file of this code"},
    {.name = "density",
     .value = "D",
     .type = quantity,
     .range = above_zero,
     .dimension = Dimension::density,
     .standard = "1000 kg/m^3",
     .expected = "a density above 0",
     .needs = {"format", "without --format, expected it with one"},
     .help = "for the masses that such files hold"},
    {.name = "shape",
     .value = "NAME|INDEX",
     .type = text,
     .help = "which shape of a template that holds several"},
};

constexpr OptionGroup common_group{"Everywhere", common_options};
constexpr OptionGroup cook_groups[] = {
    {"Cooking", cook_options},
    {"Surfaces of revolution (docs/profile-file.md)", revolution_options},
    {"Clumps of spheres (docs/clumps.md)", clump_options},
    {"Convex shapes (docs/convex-file.md)", convex_options},
    {"Walls (docs/mesh-walls.md)", wall_options},
    {"Meshes (docs/mesh-import.md)", mesh_options},
    common_group};
constexpr OptionGroup generate_groups[] = {{"Generating", generate_options}, common_group};
constexpr OptionGroup inspect_groups[] = {{"Inspecting", inspect_options}, common_group};
constexpr OptionGroup export_groups[] = {{"Exporting", export_options}, common_group};

}  // namespace

const CommandOptions cook_command{"", cook_groups};
const CommandOptions generate_command{"generate", generate_groups};
const CommandOptions inspect_command{"inspect", inspect_groups};
const CommandOptions export_command{"export", export_groups};

}  // namespace dem::shapegen
