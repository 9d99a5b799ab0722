# SPDX-License-Identifier: BSD-3-Clause
"""Binary collisions of convex shapes without dissipation ([GC] Sec. 6.2): what they do to the energy."""
import csv
import io

import numpy as np

from validation import BIN, Page, plt, subprocess

# [GC] Table 6, per cent.
PAPER = {"sphere - sphere": 0.09, "ellipsoid - ellipsoid": 0.32, "cylinder - cylinder": 0.29, "tetrahedron - tetrahedron": 0.20,
         "cube - cube": 0.37, "cube - sphere": 0.17, "cube - cylinder": 0.27, "ellipsoid - tetrahedron": 0.15}
LIMITS = {"100": 3e-4, "1000": 1e-5}


def collisions(method, count):
    text = subprocess.run([BIN / "convex_collisions", method, str(count)], check=True, capture_output=True, text=True).stdout
    return list(csv.DictReader(io.StringIO(text)))


def value(rows, combination, approach, fraction, column="mean", friction="0"):
    return next(float(r[column]) for r in rows if (r["combination"], r["approach"], r["fraction"], r["friction"])
                == (combination, approach, fraction, friction))


def plot(page, features, centroid):
    figure, axes = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
    places = np.arange(len(PAPER))
    series = [("features, random, t_c/1000", features, "random", "1000", "C0", "o"),
              ("features, near-parallel, t_c/1000", features, "parallel", "1000", "C0", "^"),
              ("features, random, t_c/100", features, "random", "100", "C2", "o"),
              ("features, near-parallel, t_c/100", features, "parallel", "100", "C2", "^"),
              ("centroid, random, t_c/1000", centroid, "random", "1000", "C3", "o"),
              ("centroid, near-parallel, t_c/1000", centroid, "parallel", "1000", "C3", "^")]
    for label, rows, approach, fraction, color, marker in series:
        axes.semilogy(places, [value(rows, c, approach, fraction) for c in PAPER], marker, color=color, label=label)
    for fraction, color in (("1000", "C0"), ("100", "C2")):
        axes.axhline(LIMITS[fraction], color=color, lw=1, ls="--")
    axes.set_xticks(places, [c.replace(" - ", " -\n") for c in PAPER], rotation=30)
    axes.set_ylim(top=50.0)
    axes.set_ylabel("mean |E / E0 - 1|")
    axes.legend(fontsize=7, ncol=2)
    page.plot(figure, "", "Mean relative error of the kinetic energy over a frictionless elastic collision; dashed: the aims")


def main():
    page = Page("binary_collisions", "Binary collisions of convex shapes without dissipation")
    features = collisions("features", 1000)
    centroid = collisions("centroid", 200)
    page.text("Bodies of about 10 mm and 1000 kg/m^3, flat ones rounded by 0.1 mm; linear law, k_n = 1e4 N/m, e_n = 1, about 0.2 m/s. Random: "
              "attitude, velocities and spins are; nearly parallel: faces towards each other, tilted by 3e-8 to 0.03. 1000 collisions each "
              "(`centroid`: 200). t_c is the contact time of a central collision.\n\n## Frictionless: mean (largest) relative error of the kinetic "
              "energy, `features`")
    rows = []
    for c in PAPER:
        row = [c]
        for fraction in ("1000", "100"):
            for approach in ("random", "parallel"):
                mean, worst = (value(features, c, approach, fraction, k) for k in ("mean", "worst"))
                row.append(f"{mean:.1e} ({worst:.1e})")
        rows.append(row)
    page.table(["pair", "random, t_c/1000", "near-parallel, t_c/1000", "random, t_c/100", "near-parallel, t_c/100"], rows)
    for fraction, limit in LIMITS.items():
        for approach in ("random", "parallel"):
            values = {c: value(features, c, approach, fraction) for c in PAPER}
            above = [c for c in PAPER if values[c] > limit]
            statement = f"t_c/{fraction}, {approach}: mean error at most {limit:.0e} (largest {max(values.values()):.1e})"
            page.claim(statement, not above)
    page.text("\nLargest is a cube nearly parallel to the end of a cylinder: while it rocks, the deepest point of the end jumps from one "
              "corner of the patch to another, and where such a corner lies near a corner of the cube the force jumps a little with it."
              "\n\n## The same by the rule of [GC], `contact = centroid`")
    page.table(["pair", "random, t_c/1000", "near-parallel, t_c/1000"],
               [[c, *(f"{value(centroid, c, a, '1000'):.1e} ({value(centroid, c, a, '1000', 'worst'):.1e})"
                      for a in ("random", "parallel"))] for c in PAPER])
    plot(page, features, centroid)
    page.text("## The measure of [GC] Table 6\n\nCollisions with e_n = e_t = 1, random attitudes, velocities and spins. The paper reports what the "
              "tangential springs still hold in the last step of a contact, over the kinetic energy before it, \"with no Coulomb friction\", which is read "
              "here as friction without limit. Off-center contacts then end with stretched springs: the normal force ends after the time of the effective "
              "mass at the contact point, the tangential spring of [GC] Eq. 13 swings with a mean one. Here a contact without slip gives that energy back before "
              "it ends (docs/contact.md, \"Without slip\"), so that the whole change of the kinetic energy can be compared with the paper's measure, which is a "
              "part of it. With the friction of the packings (0.1, [GC] Table 7) the springs slip as the normal force ends and hold nothing; what slipping "
              "dissipates is not counted.")
    def percent(column, friction, fraction="1000"):
        return {c: 100 * value(features, c, "random", fraction, column, friction) for c in PAPER}
    slipping = percent("spring_share", "0.1")
    held, change = (percent(column, "1e+09") for column in ("spring_share", "mean"))
    coarse = {fraction: percent("mean", "1e+09", fraction) for fraction in ("100", "50")}
    page.table(["pair", "friction 0.1: left in springs, t_c/1000 [%]", "no slip: left in springs, t_c/1000 [%]", "no slip: mean change of the kinetic energy, t_c/1000 [%]",
                "the same, t_c/100 [%]", "the same, t_c/50 [%]", "[GC] [%]"],
               [[c, f"{slipping[c]:.1e}", f"{held[c]:.4f}", f"{change[c]:.4f}", f"{coarse['100'][c]:.3f}", f"{coarse['50'][c]:.3f}", PAPER[c]] for c in PAPER])
    page.claim("friction 0.1, left in springs: below the paper's value for every pair", all(slipping[c] < PAPER[c] for c in PAPER))
    page.claim("no slip, left in springs: below the paper's value for every pair", all(held[c] < PAPER[c] for c in PAPER))
    page.claim("no slip, whole change of the kinetic energy: below the paper's value for every pair", all(change[c] < PAPER[c] for c in PAPER))
    return page.finish()


if __name__ == "__main__":
    raise SystemExit(main())
