# SPDX-License-Identifier: BSD-3-Clause
"""Elastic and damped impacts of spheres, tests 1-3 of Chung & Ooi (2011), Granular Matter 13."""
import sys

import numpy as np

from validation import BIN, Page, Run, cook, plt, subprocess, table, write_bodies

# name, Young's modulus, Poisson's ratio, density, largest overlap [m], force [N], contact time [s]
TEST_1 = [("glass", 4.8e10, 0.20, 2800.0, 274.11e-6, 10.697e3, 40.34e-6),
          ("limestone", 2.0e10, 0.25, 2500.0, 368.30e-6, 7.108e3, 54.20e-6)]
TEST_2 = [("aluminium alloy", 7.0e10, 0.30, 2699.0, 49.717e-6, 11.370e3, 731.7e-6),
          ("magnesium alloy", 4.0e10, 0.35, 1800.0, 52.123e-6, 7.233e3, 767.1e-6)]
RESTITUTIONS = np.array([0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0])

CASE = """
[run]
end_time = {end} s
time_step = {step} s
gravity = 0 0 0
[material.m]
density = {density}
youngs_modulus = {modulus}
poissons_ratio = {ratio}
[contact]
model = hertz
restitution = {restitution}
friction = 0
contact = {contact}
multi_contact = {multi_contact}
[particles.spheres]
template = {template}
material = m
insert = file
file = {bodies}
{wall}
[output]
frames_every = {frame} s
"""
# The papers' walls are rigid, and so stiff that only the sphere deforms.
WALL = """
[material.rigid]
youngs_modulus = 1e20
poissons_ratio = 0.3
[wall.floor]
shape = plane
point = 0 0 0
normal = 0 0 1
material = rigid
"""


def sphere(radius, kind):
    """A template of a sphere in meters: as `sphere`, as `sr` (continuous, all nodes or the deepest), or as a clump of one sphere."""
    options = {"sphere": ("--sphere",), "sr": (), "clump": ("--clump-spheres", "1"), "sr nodes": ("--nodes", "20000"),
               "sr nodes deepest": ("--nodes", "20000")}[kind]
    return cook(f"units = m\nshape = sphere\nradius = {radius!r}\n", *options)


def contact_of(kind):
    return {"sphere": "auto", "clump": "auto", "sr": "continuous"}.get(kind, "nodes")


def touching_radius(template, radius, kind):
    """Where the surface is that touches [m]: of a clump that of its sphere, which has the volume of a revolved mesh."""
    if kind != "clump":
        return radius
    spheres = template.with_suffix(".csv")
    subprocess.run([BIN / "shapegen", "export", template, "-o", spheres], check=True, capture_output=True)
    return table(spheres)["radius"][0]


def impact(kind, test, material, radius, speed, restitution=1.0, steps=500):
    """Largest overlap [m], largest force [N], contact time [s], speed after / before."""
    _, modulus, ratio, density, *_ = material
    mass = density * 4 / 3 * np.pi * radius**3
    pair = test == 1
    reduced = 0.5 * mass if pair else mass
    r_eff = 0.5 * radius if pair else radius
    y_eff = modulus / (1 - ratio**2) * (0.5 if pair else 1.0)
    closing = 2 * speed if pair else speed
    hertz = 2.8683 * (reduced**2 / (r_eff * y_eff**2 * closing)) ** 0.2
    step, gap = hertz / steps, 0.02 * hertz * closing
    name = f"chung_ooi_{test}_{kind}_{material[0]}_{restitution}".replace(" ", "_")
    rows = ([{"x": -radius - 0.5 * gap, "vx": speed}, {"x": radius + 0.5 * gap, "vx": -speed}] if pair
            else [{"z": radius + gap, "vz": -speed}])
    template = sphere(radius, kind)
    run = Run(name, CASE.format(
        end=2 * hertz, step=step, density=density, modulus=modulus, ratio=ratio, frame=step if test < 3 else hertz,
        restitution=restitution, contact=contact_of(kind),
        multi_contact="deepest" if kind.endswith("deepest") else "norm", template=template,
        bodies=write_bodies(name, rows), wall="" if pair else WALL))
    times, frames = run.frames()
    position, velocity = frames["position"], frames["velocity"]
    surface = touching_radius(template, radius, kind)
    overlap = (2 * surface - (position[:, 1, 0] - position[:, 0, 0]) if pair
               else surface - position[:, 0, 2])
    v = velocity[:, 0, 0 if pair else 2]
    if test == 3:
        return None, None, None, abs(v[-1] / v[0])
    force = np.abs(np.gradient(v, times)) * mass
    inside = np.flatnonzero(overlap > 0)
    a, b = inside[0], inside[-1]
    enter = times[a] - (times[a] - times[a - 1]) * overlap[a] / (overlap[a] - overlap[a - 1])
    leave = times[b] + (times[b + 1] - times[b]) * overlap[b] / (overlap[b] - overlap[b + 1])
    return overlap.max(), force.max(), leave - enter, abs(v[-1] / v[0])


def compare(page, kind):
    """Adds tests 1 to 3 with spheres of one kind to a page; returns the largest deviations."""
    rows, worst = [], 0.0
    for test, materials, radius, speed in ((1, TEST_1, 0.01, 10.0), (2, TEST_2, 0.1, 0.2)):
        for material in materials:
            overlap, force, time, _ = impact(kind, test, material, radius, speed)
            expected = material[4:]
            rows.append([test, material[0], f"{overlap * 1e6:.2f}", f"{expected[0] * 1e6:.2f}",
                         f"{force / 1e3:.3f}", f"{expected[1] / 1e3:.3f}", f"{time * 1e6:.2f}",
                         f"{expected[2] * 1e6:.2f}"])
            found = np.array([overlap, force, time])
            worst = max(worst, np.abs(found / np.array(expected) - 1).max())
    page.table(["test", "material", "overlap [um]", "expected", "force [kN]", "expected",
                "contact time [us]", "expected"], rows)
    oxide = ("oxide", 3.8e11, 0.23, 4000.0)
    found = np.array([impact(kind, 3, oxide, 2.5e-3, 3.9, e)[3] for e in RESTITUTIONS])
    page.table(["restitution given", *(f"{e:g}" for e in RESTITUTIONS)],
               [["restitution found", *(f"{e:.4f}" for e in found)]])
    return worst, np.abs(found - RESTITUTIONS).max(), found


def main():
    page = Page("chung_ooi", "Impacts of spheres: Chung and Ooi (2011), tests 1 to 3")
    page.text("""
Test 1: two spheres of 10 mm radius meet at 10 m/s each. Test 2: a sphere of 100 mm radius falls on a rigid plane with 0.2 m/s.
Both are elastic; the expected values are Hertz theory's as printed there. Test 3: a sphere of 2.5 mm radius hits a rigid
plane with 3.9 m/s; the restitution found must be the one given. Time step: contact time / 500.""")
    worst, worst_e, found = compare(page, "sphere")
    page.claim(f"tests 1-2 within 0.1 % of the printed values (worst {100 * worst:.4f} %)", worst < 1e-3)
    page.claim(f"test 3: restitution within 0.001 (worst {worst_e:.5f})", worst_e < 1e-3)
    figure, axes = plt.subplots(figsize=(4.5, 4))
    axes.plot([0, 1], [0, 1], "k-", lw=1, label="expected")
    axes.plot(RESTITUTIONS, found, "o", mfc="none", label="demrun")
    axes.set(xlabel="restitution given", ylabel="restitution found")
    axes.legend()
    page.plot(figure, "", "Test 3")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
