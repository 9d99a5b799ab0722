# SPDX-License-Identifier: BSD-3-Clause
"""Packing of 150 tablets in a cylinder ([SR] Sec. 3.3)."""
import sys

from packing import MEASURES, arguments, heights, pack, report
from validation import Page, cook

# The same vessel filled otherwise, with the automatic time step (some 30 times the paper's).
VARIANTS = {
    "as above": ("_auto", []),
    "one at a time": ("_single", ["particles.tablet.batch=1", "particles.tablet.every=60 ms", "run.end_time=12 s"]),
    "half the friction": ("_slippery", ["contact.friction=0.19", "contact.coating.wall.friction=0.11"]),
}


def main():
    options = arguments()
    template = cook("tablet")
    page = Page("packing_tablets", "Packing of 150 tablets")
    page.text("""
The vessel, the particles, the material and the time step are those of [SR] Table 3; the case is
[data/cases/packing_tablets.ini](../../data/cases/packing_tablets.ini). How a vessel is filled moves the height more than any shape model:
particles are dropped a few at a time, at rest, with random orientation, as the paper does. The experiment reports 66.87 +- 2.0 mm, the
paper's own simulation 68.5 +- 2.0 mm ("average filling height"); neither says how the top of the bed was measured.""")
    runs = pack("packing_tablets", template, options)
    report(page, runs, experiment=66.87, tolerance=2.0, total=150)
    highest, top_ten, surface = heights(runs).mean(axis=0)
    page.shortfall(f"highest point, mean over {len(runs)} seeds, within the experiment's 66.87 +- 2.0 mm ({highest:.1f} mm)",
                   abs(highest - 66.87) <= 2.0)
    page.claim(f"the experiment's interval lies between the mean surface ({surface:.1f} mm) and the ten highest ({top_ten:.1f} mm)",
               surface < 66.87 + 2.0 and top_ten > 66.87 - 2.0)
    page.text("""
The highest point belongs to one tablet that stands on its band, most often against the wall: it reaches some 6 mm, half a tablet's
diameter, above its neighbors. A ruler held against a real bed does not look at that one tablet, nor into the gaps that lower the mean
surface. What the program can be asked is how much the filling and the friction matter:""")
    rows = []
    for label, (variant, settings) in VARIANTS.items():
        variant_heights = heights(pack("packing_tablets", template, options, variant, ["run.time_step=auto", *settings]))
        rows.append([label, *(f"{m:.2f} +- {s:.2f}" for m, s in zip(variant_heights.mean(axis=0), variant_heights.std(axis=0, ddof=1)))])
    page.table(["filling (mean and standard deviation over the seeds, automatic time step)", *(f"{m} [mm]" for m in MEASURES)], rows)
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
