# SPDX-License-Identifier: BSD-3-Clause
"""Loose packings of sand and of woodchips ([GC] Sec. 8): solid fractions."""
import concurrent.futures
import sys

import numpy as np

from packing import GRAINS, RAIN, arguments
from validation import Page, Run, plt, shapegen

SAND = {"count": 500, "radius": 25, "inner": 24, "low": 50, "high": 75, "batch": 40}
CHIPS = {"count": 300, "radius": 10, "inner": 9.8, "low": 60, "high": 100, "batch": 30}
SEEDS = 1  # the three packings take an hour together
PACKINGS = {"sand_sphere": (("sand",), SAND, 0.546), "sand_ellipsoid": (("sand", "--template", "ellipsoid"), SAND, 0.550),
            "woodchips": (("woodchips",), CHIPS, 0.382)}


def pack(name, seed, reuse):
    kind, vessel, _ = PACKINGS[name]
    template = shapegen(f"granular_{name}_{seed}", "generate", *kind, "--count", str(vessel["count"]), "--seed", str(seed))
    return Run(f"granular_{name}_{seed}", RAIN.format(template=template, seed=seed, end=4, divisor=20, every=60, frames=20, **vessel), "--threads", "1", reuse=reuse)


LOOK = GRAINS + """
[run]
end_time = 1 us
time_step = 1 us
gravity = 0 0 0
[contact]
model = linear
normal_stiffness = 1e-9
restitution = 1
tangential_restitution = 1
friction = 0
[particles.grains]
template = {template}
material = grain
insert = file
file = {final}
overlaps = allow
[output]
picture = no
[measure.whole]
kind = solid_fraction
[measure.bulk]
kind = solid_fraction
bottom = {bottom} mm
top = {top} mm
"""


def look(name, seed, run):
    """Solid fractions of the bed at rest: up to its highest point, and of the layer that leaves out a quarter of the height of its mean
    surface at the bottom and at the top. By one step of a run that begins with its end, without any force to speak of."""
    surface = 1e3 * run.history["height_surface"][-1]
    case = LOOK.format(template=run.directory.with_suffix(".tpl"), final=run.directory / "final.csv", radius=PACKINGS[name][1]["radius"],
                       bottom=0.25 * surface, top=0.75 * surface)
    return Run(f"granular_{name}_{seed}_look", case, "--threads", "1").history


def main():
    options = arguments()
    jobs = [(name, seed) for name in PACKINGS for seed in range(1, SEEDS + 1)]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = dict(zip(jobs, pool.map(lambda job: pack(*job, options.reuse), jobs)))
    looks = {job: look(*job, run) for job, run in runs.items()}
    seeds = range(1, SEEDS + 1)
    page = Page("granular_packings", "Loose packings of sand and of woodchips")
    page.text("""
Grains as [GC] Section 8 makes them (`shapegen generate`), no two alike, with its contact parameters: k_n = 1e4 N/m, e_n = 0.8, e_t = 0.6,
friction 0.1; the density, which the paper does not give, 2500 kg/m^3. They rain into vessels of 25 mm (sand) and 10 mm radius (woodchips) and come to
rest together; the paper froze each batch before the next one fell. Solid fractions are shares of 40 000 points that lie in a grain by its exact
shape (`kind = solid_fraction`): of the middle half of the bed's height, and from the floor up to the highest point. The paper does not say where its bed
begins and ends; the beds are a few grains deep. With a friction of 0.1 and every grain free to move until all lie still, grains pack more densely than
the paper's; up to the highest point, the air over a rough surface included, woodchips fill about what the paper states.""")
    rows = []
    figure, axes = plt.subplots()
    for k, (name, (_, vessel, paper)) in enumerate(PACKINGS.items()):
        group = [runs[name, seed] for seed in seeds]
        def column(key):
            return [looks[name, seed][key][-1] for seed in seeds]
        bulk, whole = column("bulk_solid_fraction"), column("whole_solid_fraction")
        rows.append([name.replace("_", ", "), len(group[0].final["x"]), paper, f"{np.mean(bulk):.3f}", f"{np.mean(column('bulk_near_wall')):.3f}",
                     f"{np.mean(column('bulk_core')):.3f}", f"{np.mean(whole):.3f}",
                     ", ".join(f"{1e3 * r.history['height_surface'][-1]:.1f}" for r in group),
                     ", ".join(f"{1e3 * r.history['height_highest'][-1]:.1f}" for r in group),
                     sum(r.summary["core_overlaps"] for r in group), ", ".join(f"{r.summary['end'].replace('_', ' ')}, {r.summary['time']:.2f} s" for r in group)])
        axes.plot([k - 0.1] * len(bulk), bulk, "o", color="C0", label=None if k else "middle half of the height")
        axes.plot([k - 0.1] * len(whole), whole, "s", color="C1", label=None if k else "up to the highest point")
        axes.plot([k + 0.1], [paper], "k_", ms=20, label=None if k else "[GC] Table 8")
        placed = min(len(r.final["x"]) for r in group)
        label = name.replace("_", ", ")
        page.claim(f"{label}: no grain was lost in {len(group)} run{'s' if len(group) > 1 else ''} ({placed} of {vessel['count']})",
                   placed == vessel["count"])
        page.shortfall(f"{label}: solid fraction of the middle half within 0.03 of the paper's {paper} ({np.mean(bulk):.3f})",
                       abs(np.mean(bulk) - paper) < 0.03)
    page.table(["grains", "number", "[GC]", "middle half of the height", "the same near the wall", "the same in the core", "up to the highest point",
                "mean surface [mm]", "highest point [mm]", "contacts with overlapping cores", "ended"], rows)
    axes.set(xticks=range(len(PACKINGS)), xticklabels=[n.replace("_", ", ") for n in PACKINGS], ylabel="solid fraction")
    axes.legend()
    page.plot(figure, "", "Solid fractions")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
