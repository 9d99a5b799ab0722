# SPDX-License-Identifier: BSD-3-Clause
"""A sphere as a clump of one sphere: the same numbers."""
import sys

import chung_ooi
from validation import Page, inspect


def main():
    page = Page("sphere_as_clump", "A sphere as a clump of one sphere")
    radius = 0.01
    template = chung_ooi.sphere(radius, "clump")
    own = chung_ooi.touching_radius(template, radius, "clump")
    certificate = inspect(template)["shapes"][0]["certificate"]
    page.text(f"""
The tests of [Chung and Ooi](chung_ooi.md) with the sphere made into a clump (`shapegen sphere.profile --clump-spheres 1`). A named sphere is its own
clump and needs no fit: the radius is {radius - own:.2g} m less than the {radius:g} m asked for, and the RMS deviation {100 * certificate['rms_deviation']:.2g} % of the diameter.""")
    worst, worst_e, _ = chung_ooi.compare(page, "clump")
    page.claim(f"tests 1-2 within 0.1 % of the printed values (worst {100 * worst:.4f} %)", worst < 1e-3)
    page.claim(f"test 3: restitution within 0.001 (worst {worst_e:.5f})", worst_e < 1e-3)
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
