# SPDX-License-Identifier: BSD-3-Clause
"""Ten bunnies dropped one by one into a box ([MS] Sec. 5.2, Fig. 16)."""
import argparse
import sys

import numpy as np

from validation import ROOT, Page, Run, cook_mesh, inspect, plt


def main():
    argparse.ArgumentParser().parse_args()
    template = cook_mesh(ROOT / "data/meshes/bunny.ply", "--scale", "0.1", "--clump-spheres", "400")
    shape = inspect(template)["shapes"][0]
    certificate = shape["certificate"]
    text = (ROOT / "data/cases/ten_bunnies.ini").read_text()
    runs = [Run(f"ten_bunnies_{threads}", text, "--threads", str(threads), "--set", f"particles.bunnies.template={template}")
            for threads in (1, 2)]
    run = runs[0]
    page = Page("ten_bunnies", "Ten bunnies in a box")
    page.text(f"""
[data/cases/ten_bunnies.ini](../../data/cases/ten_bunnies.ini): bunnies of {shape["counts"]["spheres"]} spheres ({100 * certificate["coverage"]:.2f} % of the mesh inside them,
surface {100 * certificate["rms_deviation"]:.2f} % of the equivalent diameter off, root mean square), dropped one by one from the top of a box, as
[MS] does with 3000 spheres. The paper shows pictures and asks for plausible behavior; what can be claimed is this:""")
    history, mass, g = run.history, shape["volume"] * 1377.0, 9.81
    total = history["inserted"] + history["wall_work"]
    held = sum(history[c] for c in ("kinetic_translational", "kinetic_rotational", "elastic", "potential", "dissipated"))
    residual = np.abs(held - total).max() / total.max()
    page.claim(f"the energy ledger closes to 1e-3 of what was put in ({residual:.1e})", residual < 1e-3)
    kinetic = (history["kinetic_translational"] + history["kinetic_rotational"])[-1] / (10 * mass * g * 0.0113)
    page.claim(f"at the end the bunnies rest: kinetic energy below 1e-3 of their weight times their diameter ({kinetic:.1e})", kinetic < 1e-3)
    page.claim(f"no bunny left the box, none sank in (largest overlap below 5 % of the radius: {history['largest_relative_overlap'].max():.4f})",
               len(run.final["x"]) == 10 and history["largest_relative_overlap"].max() < 0.05)
    page.claim("the same bits with one thread and with two", runs[0].summary["state_hash"] == runs[1].summary["state_hash"])
    figure, axes = plt.subplots()
    for column, label in {"kinetic_translational": "translation", "kinetic_rotational": "rotation", "elastic": "elastic",
                          "dissipated": "dissipated"}.items():
        axes.semilogy(history["time"], np.maximum(history[column], 1e-9), lw=1, label=label)
    axes.set(xlabel="time [s]", ylabel="energy [J]")
    axes.legend()
    page.plot(figure, "", "Energies while the bunnies fall")
    page.picture(run.directory / "final.png", "The bunnies at the end")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
