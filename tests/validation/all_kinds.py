# SPDX-License-Identifier: BSD-3-Clause
"""Spheres, surfaces of revolution, clumps and convex shapes in one box that comes to rest: the energy ledger."""
import sys

import numpy as np

from packing import arguments
from validation import ROOT, Page, Run, cook, cook_mesh, plt, shapegen

TEMPLATES = {"candy": lambda: cook("candy"), "peanut": lambda: cook("peanut"),
             "bunny_100": lambda: cook_mesh(ROOT / "data/meshes/bunny.ply", "--scale", "0.08", "--clump-spheres", "100"),
             "cuboid": lambda: shapegen("cuboid", ROOT / "data/convex/cuboid.convex"),
             "rod": lambda: shapegen("rod", ROOT / "data/convex/cylinder.convex"),
             "sand_30": lambda: shapegen("sand_30", "generate", "sand", "--count", "30", "--seed", "1")}


def speed(bodies):
    return np.sqrt(sum(bodies["v" + axis]**2 for axis in "xyz"))


def main():
    options = arguments()
    case = (ROOT / "data/cases/all_kinds.ini").read_text()
    for name, make in TEMPLATES.items():
        case = case.replace(f"= {name}.tpl", f"= {make()}")
    run = Run("all_kinds_1", case, "--threads", "1", reuse=options.reuse)
    history = run.history
    energy = {name: history[name] for name in ("kinetic_translational", "kinetic_rotational", "elastic", "potential", "dissipated")}
    inside = sum(energy.values()) - history["wall_work"]
    gap = abs(inside - history["inserted"]).max() / history["dissipated"][-1]
    kinetic = energy["kinetic_translational"] + energy["kinetic_rotational"]
    page = Page("all_kinds", "All kinds in one box")
    page.text("""
Beads, candies, peanuts, bunnies of 100 spheres, dice, rods and grains of sand, [data/cases/all_kinds.ini](../../data/cases/all_kinds.ini):
sphere, convex and other surfaces of revolution, clump, cuboid, cylinder and polyhedra, every pair of kinds with the method of the table in
[contact](../contact.md).""")
    late = history["time"] > 0.9 * run.summary["time"]
    share = kinetic[late].max() / energy["dissipated"][-1]
    page.claim(f"all {len(run.final['x'])} bodies come to rest but for rolling and rocking: in the last tenth of {run.summary['time']:.1f} s the kinetic energy stays below {share:.1e} "
               "of what was dissipated (1e-6)", share < 1e-6 and len(run.final["x"]) == 140)
    speeds = speed(run.final)
    order = np.argsort(-speeds)
    moving = order[speeds[order] > 2e-5]
    names = ", ".join(f"{run.final['group'][i]} {run.final['id'][i]:.0f} with {1e3 * speeds[i]:.2g} mm/s" for i in moving)
    page.text(f"Still moving in the end: {names}. They roll or rock without sliding, which costs nothing: there is no rolling friction, and the kinetic "
              f"energy swings on. All others are slower than {1e6 * speeds[order[len(moving)]]:.2g} um/s.")
    page.claim(f"kinetic, elastic and potential energy and what was dissipated add up to what came in, within {100 * gap:.3f} % of the "
               "dissipated energy at any time", gap < 0.005)
    page.text(f"In {run.summary['core_overlaps']} contacts the cores of convex bodies overlapped (a rounding of 1 % is soon used up at the 2 m/s at which the "
              "last bodies arrive): the depth of the polytope took over, and the ledger shows no trace of it.")
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
    for name, values in energy.items():
        axes[0].plot(history["time"], 1e3 * values, label=name.replace("_", " "))
    axes[0].plot(history["time"], 1e3 * history["inserted"], "k:", label="came in")
    axes[0].set(xlabel="time [s]", ylabel="energy [mJ]")
    axes[0].legend()
    axes[1].semilogy(history["time"], np.maximum(1e3 * kinetic, 1e-12))
    axes[1].axhline(1e3 * 1e-6 * energy["dissipated"][-1], color="k", ls=":", label="rest")
    axes[1].legend()
    axes[1].set(xlabel="time [s]", ylabel="kinetic energy [mJ]")
    page.plot(figure, "", "Energies, and how the box comes to rest")
    page.picture(run.directory / "final.png", "The box at rest, one color per group")
    page.text(f"Time step {run.summary['time_step']:.3g} s.")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
