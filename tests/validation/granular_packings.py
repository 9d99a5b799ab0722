# SPDX-License-Identifier: BSD-3-Clause
"""Loose packings of sand and of woodchips ([GC] Sec. 8): solid fractions, by the paper's way of filling and with every grain free to move."""
import concurrent.futures
import sys

import numpy as np

from packing import GRAINS, RAIN, arguments, bed, deposit
from validation import Page, Run, plt, shapegen

SAND = {"radius": 25, "inner": 24, "batch": 60, "batches": 24, "count": 500, "rain": 40, "low": 50, "high": 75}
CHIPS = {"radius": 10, "inner": 9.8, "batch": 20, "batches": 40, "count": 300, "rain": 30, "low": 60, "high": 100}
PACKINGS = {"sand_sphere": (("sand",), SAND, 0.546), "sand_ellipsoid": (("sand", "--template", "ellipsoid"), SAND, 0.550),
            "woodchips": (("woodchips",), CHIPS, 0.382)}
WAYS = ("frozen", "free")

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
{bed}
[output]
picture = no
[measure.whole]
kind = solid_fraction
[measure.bulk]
kind = solid_fraction
bottom = {bottom} mm
top = {top} mm
"""


def grains(name, way, part, count):
    """A library of unique grains; of every batch its own."""
    kind = PACKINGS[name][0]
    return shapegen(f"granular_{name}_{way}_{part}", "generate", *kind, "--count", str(count), "--seed", str(part + 1))


class Packing:
    """A bed at rest: solid fractions up to its mean surface and of the layer that leaves out a quarter of the height of its mean surface at the
    bottom and at the top, by one step of a run that begins with its end."""

    def __init__(self, name, way, reuse):
        vessel = PACKINGS[name][1]
        if way == "frozen":
            templates = [grains(name, way, k, vessel["batch"]) for k in range(vessel["batches"])]
            self.runs, sections = deposit(f"granular_{name}_frozen", templates, vessel["batch"], 15, 1, reuse, radius=vessel["radius"], inner=vessel["inner"],
                                end=1.5, divisor=20)
        else:
            template = grains(name, way, 0, vessel["count"])
            case = RAIN.format(template=template, seed=1, end=4, divisor=20, every=60, frames=20, **(vessel | {"batch": vessel["rain"]}))
            self.runs = [Run(f"granular_{name}_free", case, "--threads", "1", reuse=reuse)]
            sections = bed(0, template, self.runs[0])
        last = self.runs[-1]
        self.surface, self.highest = (1e3 * last.history[c][-1] for c in ("height_surface", "height_highest"))
        case = LOOK.format(bed=sections, radius=vessel["radius"], bottom=0.25 * self.surface, top=0.75 * self.surface)
        look = Run(f"granular_{name}_{way}_look", case, "--threads", "1").history
        self.bulk, self.near_wall, self.core, self.whole = (look[c][-1] for c in ("bulk_solid_fraction", "bulk_near_wall", "bulk_core", "whole_solid_fraction"))
        self.count = len(last.final["x"])
        self.all_grains = vessel["batch"] * vessel["batches"] if way == "frozen" else vessel["count"]
        self.core_overlaps = sum(r.summary["core_overlaps"] for r in self.runs)
        self.at_rest = sum(r.summary["end"] == "at_rest" for r in self.runs)


def main():
    options = arguments()
    jobs = [(name, way) for way in WAYS for name in PACKINGS]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        beds = dict(zip(jobs, pool.map(lambda job: Packing(*job, options.reuse), jobs)))
    page = Page("granular_packings", "Loose packings of sand and of woodchips")
    page.text("""
Grains as [GC] Section 8 makes them (`shapegen generate`), no two alike, with its contact parameters: k_n = 1e4 N/m, e_n = 0.8, e_t = 0.6,
friction 0.1; the density, which the paper does not give, 2500 kg/m^3. Vessels of 25 mm (sand) and 10 mm radius (woodchips). They are filled in two ways:
as in the paper, batches of 60 grains (20 woodchips) that are frozen once they lie still, so that the next one falls onto a bed that does not
move; and as in nature, with every grain free to move until all lie still. Solid fractions are shares of 40 000 points that lie in a grain by its exact
shape (`kind = solid_fraction`): of the middle half of the bed's height, and from the floor up to the mean surface.""")
    rows = []
    for (name, way), bed in beds.items():
        rows.append([name.replace("_", ", "), way, bed.count, PACKINGS[name][2], f"{bed.bulk:.3f}", f"{bed.near_wall:.3f}", f"{bed.core:.3f}", f"{bed.whole:.3f}",
                     f"{bed.surface:.1f}", f"{bed.highest:.1f}", bed.core_overlaps, f"{bed.at_rest} of {len(bed.runs)}"])
    page.table(["grains", "bed", "number", "[GC]", "middle half of the height", "the same near the wall", "the same in the core", "up to the mean surface",
                "mean surface [mm]", "highest point [mm]", "contacts with overlapping cores", "runs that came to rest"], rows)
    for (name, way), bed in beds.items():
        label = f"{name.replace('_', ', ')}, {way}"
        page.claim(f"{label}: no grain was lost ({bed.count} of {bed.all_grains})", bed.count == bed.all_grains)
    for name, (_, _, paper) in PACKINGS.items():
        bulk = beds[name, "frozen"].bulk
        holds = abs(bulk - paper) < 0.03
        tell = page.claim if name == "sand_ellipsoid" else page.shortfall
        tell(f"{name.replace('_', ', ')}: filled as in the paper, solid fraction of the middle half within 0.03 of its {paper} ({bulk:.3f})", holds)
    denser = [beds[name, "free"].bulk - beds[name, "frozen"].bulk for name in PACKINGS]
    left = {name: beds[name, "frozen"].bulk - paper for name, (_, _, paper) in PACKINGS.items()}
    page.text(f"""
The paper gives one overall fraction of each bed and does not say where the bed begins and ends. Freezing the batches is what makes its beds loose: grains that
are free to move until all lie still fill {min(denser):.2f} to {max(denser):.2f} more. What is left is {left["sand_sphere"]:.2f} for spherical sand and
{left["woodchips"]:.2f} for woodchips; between wall and core the same beds differ by {beds["sand_sphere", "frozen"].core - beds["sand_sphere", "frozen"].near_wall:.2f}
and {beds["woodchips", "frozen"].core - beds["woodchips", "frozen"].near_wall:.2f}.""")
    figure, axes = plt.subplots()
    for k, (name, (_, _, paper)) in enumerate(PACKINGS.items()):
        for way, color, shift in (("frozen", "C0", -0.1), ("free", "C1", 0.0)):
            bed = beds[name, way]
            axes.plot([k + shift], [bed.bulk], "o", color=color, label=None if k else f"{way}, middle half of the height")
            axes.plot([k + shift], [bed.whole], "s", color=color, mfc="none", label=None if k else f"{way}, up to the mean surface")
        axes.plot([k + 0.1], [paper], "k_", ms=20, label=None if k else "[GC] Table 8")
    axes.set(xticks=range(len(PACKINGS)), xticklabels=[n.replace("_", ", ") for n in PACKINGS], ylabel="solid fraction")
    axes.legend()
    page.plot(figure, "", "Solid fractions")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
