# SPDX-License-Identifier: BSD-3-Clause
"""Clumps of the candy, the tablet and the bunny: how few inscribed spheres reach a coverage, how well fitted ones follow the body, what it costs."""
import argparse
import json
import os
import subprocess
import sys
import time

from validation import BIN, ROOT, WORK, Page

FULL_BUNNY = ROOT / "data/meshes/full/stl-models/objects/bunny.bin.stl"
# The open base of the full bunny puts 4 % of its volume at stake (docs/mesh-import.md).
BUNNY = [FULL_BUNNY, "--unit", "m", "--repair-limit", "5%"] if FULL_BUNNY.exists() else [ROOT / "data/meshes/bunny.ply"]
SOURCES = {"candy": [ROOT / "data/profiles/candy.profile"], "tablet": [ROOT / "data/profiles/tablet.profile"], "bunny": BUNNY}

# body, coverage, spheres of a plain greedy cover, goal
INSCRIBED = [("candy", 0.95, "45", 42), ("candy", 0.99, "230", 205), ("tablet", 0.95, "92", 87), ("tablet", 0.99, "-", 660),
             ("bunny", 0.95, "264", 250), ("bunny", 0.99, "2100", 1900)]
# body, spheres, uncovered + outside [%] of the best other generator measured, goal; goal of the RMS deviation [% d_eq]
FITTED = [("candy", 48, "4.4", 2.2, 0.40), ("candy", 181, "1.5", 0.60, 0.11), ("tablet", 96, "-", 2.6, 0.50), ("tablet", 250, "-", 1.3, 0.245),
          ("bunny", 255, "6.9", 2.8, 0.41), ("bunny", 1147, "3.6", 0.9, 0.11)]


def make(body, *options):
    """The certificate of a clump, its spheres, wall seconds and peak memory [MB]."""
    WORK.mkdir(parents=True, exist_ok=True)
    template = WORK / "clump.tpl"
    start = time.monotonic()
    process = subprocess.Popen([BIN / "shapegen", *SOURCES[body], *options, "-q", "-o", template])
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.monotonic() - start
    if status != 0:
        sys.exit(f"shapegen failed for {body} {options}")
    shape = json.loads(subprocess.run([BIN / "shapegen", "inspect", template, "--json"], check=True, capture_output=True, text=True).stdout)
    shape = shape["shapes"][0]
    return shape["certificate"], shape["counts"]["spheres"], seconds, usage.ru_maxrss / 1024.0


def verdict(found, goal):
    return "met" if found <= goal else "**not met**"


def inscribed_rows(resolution, bodies):
    for body, coverage, greedy, goal in INSCRIBED:
        if body not in bodies:
            continue
        certificate, spheres, seconds, memory = make(body, "--clump", str(coverage), "--inscribed", "--resolution", resolution)
        row = [body, f"{100 * coverage:g} %", spheres, greedy, goal, verdict(spheres, goal), f"{100 * certificate['coverage']:.3f} %",
               f"{seconds:.1f} s", f"{memory:.0f} MB"]
        print(*row, sep=", ", flush=True)
        yield row


def fitted_rows(resolution, bodies):
    for body, spheres, other, goal, rms_goal in FITTED:
        if body not in bodies:
            continue
        certificate, _, seconds, _ = make(body, "--clump-spheres", str(spheres), "--protrusion", "5%", "--resolution", resolution)
        difference = 100 * (1 - certificate["coverage"] + certificate["outside"])
        rms = 100 * certificate["rms_deviation"]
        moments = 100 * max(abs(error) for error in certificate["moment_errors"])
        row = [body, spheres, f"{difference:.2f}", other, goal, verdict(difference, goal), f"{rms:.3f}", rms_goal, verdict(rms, rms_goal),
               f"{moments:.2f}", f"{100 * certificate['mass_tolerance']:.2g}", f"{seconds:.1f} s"]
        print(*row, sep=", ", flush=True)
        yield row


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--resolution", default="100", help="voxels per equivalent diameter")
    parser.add_argument("--bodies", nargs="+", default=list(SOURCES), choices=list(SOURCES))
    options = parser.parse_args()
    page = Page("clump_shapes", "Clumps of three bodies")
    page.text(f"""
Candy and tablet are those of [MS], the bunny has {"69 451" if FULL_BUNNY.exists() else "11 998"} triangles. All with `--resolution {options.resolution}`. Every
coverage is that of the independent judge (docs/clumps.md). Times are wall times on a virtual machine with two hardware threads of one core.

## Inscribed spheres

The fewest spheres inside the body that cover a part of its volume; beside them those of a plain greedy cover.""")
    page.table(["body", "coverage", "spheres", "plain greedy", "goal", "", "judged", "wall", "memory"],
               list(inscribed_rows(options.resolution, options.bodies)))
    page.text("""
## Fitted spheres

Spheres may stand out by 5 % of d_eq. First the volume that is not covered or covered outside, in % of the body's, beside the best other generator measured;
then the RMS deviation of the surface in % of d_eq; the largest error of a principal moment of the union; and by how much, in %, the moments of the spheres'
masses had to differ from the body's (0: a code that sums spheres has the exact body).""")
    page.table(["body", "spheres", "off, %", "other", "goal", "", "RMS, %", "goal", "", "moments, %", "masses, %", "wall"],
               list(fitted_rows(options.resolution, options.bodies)))
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
