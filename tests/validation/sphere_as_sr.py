# SPDX-License-Identifier: BSD-3-Clause
"""A sphere as `sphere` and as `sr`, continuous and by nodes: the same numbers."""
import sys

import chung_ooi
from validation import Page


def main():
    page = Page("sphere_as_sr", "A sphere as a surface of revolution")
    page.text("""
The tests of [Chung and Ooi](chung_ooi.md) with the sphere cooked as a surface of revolution. Continuous contact uses the
support map, which is exact for a sphere; nodes see the sphere through 20 000 surface nodes and the interpolated distance field.""")
    page.text("## Continuous")
    worst, worst_e, _ = chung_ooi.compare(page, "sr")
    page.claim(f"tests 1-2 within 0.1 % of the printed values (worst {100 * worst:.4f} %)", worst < 1e-3)
    page.claim(f"test 3: restitution within 0.001 (worst {worst_e:.5f})", worst_e < 1e-3)
    page.text("## The deepest node")
    worst, worst_e, _ = chung_ooi.compare(page, "sr nodes deepest")
    page.claim(f"tests 1-2 within 2 % of the printed values (worst {100 * worst:.4f} %)", worst < 2e-2)
    page.claim(f"test 3: restitution within 0.01 (worst {worst_e:.5f})", worst_e < 1e-2)
    page.text("""## All nodes, `multi_contact = norm`
The overlap of many nodes together is (sum d^16)^(1/16), more than the deepest one's as soon as several are nearly as deep: 16 equally
deep nodes count as 1.19 times one's overlap. In test 1 the overlap is 3 % of the radius and hundreds of the 20 000 nodes take part.""")
    worst, worst_e, _ = chung_ooi.compare(page, "sr nodes")
    page.claim(f"tests 1-2 within 25 % of the printed values (worst {100 * worst:.4f} %)", worst < 0.25)
    page.claim(f"test 3: restitution within 0.01 (worst {worst_e:.5f})", worst_e < 1e-2)
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
