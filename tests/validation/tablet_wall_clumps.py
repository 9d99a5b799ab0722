# SPDX-License-Identifier: BSD-3-Clause
"""A tablet as clumps of spheres hits a flat wall at 20 angles ([MS] Sec. 4.2, Fig. 12)."""
import sys

import numpy as np

from tablet_wall import ANGLES, BAND_RADIUS, SPEED, Tablet, rebound, states_after
from validation import Page, cook, inspect, plt

COUNTS = (96, 456, 500, 2466)
PROTRUSION = {96: "1%", 456: "0.3%", 500: "0.3%", 2466: "0.2%"}
GAP = 0.2e-3  # fitted spheres stand out of the tablet


def clump_options(count):
    resolution = 60 if count < 400 else 100
    return ("--clump-spheres", str(count), "--protrusion", PROTRUSION[count], "--resolution", str(resolution))


def contact_restitution(name, tablet, restitution):
    """Of the tablet that falls on its cap, at the point that touches: a sphere beside the axis turns a central impact into one
    with a lever arm r, known from the impulse m (v + V) = I |w| / r."""
    velocity, spin = states_after(name, tablet, GAP, restitution=restitution)
    v, w2 = velocity[0], (spin[0]**2).sum()
    return (v + tablet.moment * w2 / (tablet.mass * (v + SPEED))) / SPEED


def main():
    page = Page("tablet_wall_clumps", "A tablet of spheres hits a wall")
    page.text("""
The impact of [tablet_wall](tablet_wall.md) with the tablet made of spheres ([MS] Sec. 4.2). All touching spheres act as one contact
(`multi_contact = norm`); mass and moments are the tablet's own. The spheres' bumps turn the normal a little at each place, which shows in
the spin; the more spheres, the less. `multi_contact = sum` gives every touching sphere a spring and a dashpot of its own, as the paper
does: stiffness and damping grow with their number.""")
    clumps = {count: Tablet(cook("tablet", *clump_options(count)), 0.0) for count in COUNTS}
    runs = {f"{count} spheres": (count, {}) for count in COUNTS} | {
        f"{count} spheres, radius = equivalent": (count, {"radius": "equivalent"}) for count in (456, 2466)} | {
        f"{count} spheres, multi_contact = sum (paper)": (count, {"more": "multi_contact = sum"}) for count in (96, 2466)}
    rows, results, deviation = [], {}, {}
    for k, (label, (count, options)) in enumerate(runs.items()):
        tablet = clumps[count]
        v, w = results[label] = rebound(f"tablet_wall_clumps_{k}", tablet, gap=GAP, **options)
        v_exact, w_exact = tablet.closed_form(ANGLES)
        dv, dw = np.abs(v - v_exact) / SPEED, np.abs(w - w_exact) / np.abs(w_exact).max()
        deviation[label] = 100 * np.array([dv.mean(), dv.max(), dw.mean(), dw.max()])
        certificate = inspect(tablet.template)["shapes"][0]["certificate"]
        rows.append([label, f"{100 * certificate['coverage']:.2f}", f"{100 * certificate['rms_deviation']:.3f}",
                     *(f"{d:.2f}" for d in deviation[label])])
    page.text("Deviation from the closed form over the 20 angles, velocity in % of the impact velocity, spin in % of the largest spin:")
    page.table(["run", "coverage [%]", "RMS deviation [% d_eq]", "velocity, mean", "velocity, worst", "spin, mean", "spin, worst"], rows)
    for label, velocity, spin in (("2466 spheres", 1.2, 1.4), ("456 spheres", 3.0, 4.0)):
        d = deviation[label]
        page.claim(f"{label}: velocity within {velocity:g} % and spin within {spin:g} % on average ({d[0]:.2f}, {d[2]:.2f})",
                   d[0] <= velocity and d[2] <= spin)

    page.text("""
Restitution at the contact point of the tablet that falls on its cap (tilt 0), as given and as found:""")
    given = (0.3, 0.6, 0.9)
    found = {count: [contact_restitution(f"tablet_wall_clumps_e_{count}_{e:g}", clumps[count], e) for e in given]
             for count in COUNTS}
    page.table(["spheres", *(f"e = {e:g}" for e in given)], [[count, *(f"{e:.4f}" for e in found[count])] for count in COUNTS])
    worst = {count: max(abs(f - e) for f, e in zip(found[count], given)) for count in COUNTS}
    page.claim(f"restitution on the cap within 0.003 for any number of spheres (worst {max(worst.values()):.4f}); exactly central impacts, one to "
               "1450 spheres, are a fast test (tests/physics/clump_collision_test.cpp)", max(worst.values()) <= 0.003)
    page.lines.append("")

    figure, axes = plt.subplots(1, 2, figsize=(9.5, 4))
    fine = np.radians(np.linspace(0, 89.8, 400))
    velocity, spin = clumps[COUNTS[0]].closed_form(fine)
    axes[0].plot(np.degrees(fine), -velocity / SPEED, "k-", lw=1, label="closed form")
    axes[1].plot(np.degrees(fine), spin * BAND_RADIUS / SPEED, "k-", lw=1)
    for marker, label in zip("o^sx", ("96 spheres", "456 spheres", "2466 spheres", "2466 spheres, multi_contact = sum (paper)")):
        v, w = results[label]
        axes[0].plot(np.degrees(ANGLES), -v / SPEED, marker, ms=5, mfc="none", label=label)
        axes[1].plot(np.degrees(ANGLES), w * BAND_RADIUS / SPEED, marker, ms=5, mfc="none")
    axes[0].set(xlabel="tilt of the axis [deg]", ylabel="velocity after / before")
    axes[1].set(xlabel="tilt of the axis [deg]", ylabel="spin after x band radius / speed before")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncols=3, fontsize=8, frameon=False)
    figure.subplots_adjust(bottom=0.25, wspace=0.25)
    page.plot(figure, "", "Velocity and spin after the impact against the tilt of the tablet's axis")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
