# SPDX-License-Identifier: BSD-3-Clause
"""Packing of 150 tablets in a cylinder ([SR] Sec. 3.3)."""
import sys

from packing import arguments, pack, report
from validation import Page, cook


def main():
    options = arguments()
    page = Page("packing_tablets", "Packing of 150 tablets")
    page.text("""
The vessel, the particles, the material and the time step are those of [SR] Table 3; the case is
[data/cases/packing_tablets.ini](../../data/cases/packing_tablets.ini). How a vessel is filled moves the height more than any shape model:
particles are dropped a few at a time, at rest, with random orientation, as the paper does.""")
    runs = pack("packing_tablets", cook("tablet"), options)
    report(page, runs, experiment=66.87, tolerance=2.0, paper="68.5 +- 2.0 mm", total=150)
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
