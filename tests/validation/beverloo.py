# SPDX-License-Identifier: BSD-3-Clause
"""Discharge of spheres from hoppers of triangles against Beverloo's law (1961)."""
import argparse
import concurrent.futures
import math
import sys

import numpy as np

from validation import WORK, Page, Run, plt, shapegen

DIAMETER = 4.0  # of the spheres [mm]
VESSEL = 80.0  # diameter [mm]
ORIFICES = [20.0, 22.0, 24.0, 26.0, 29.0, 32.0]  # [mm]
CONE = 30.0  # half angle of the conical hopper [deg]
DENSITY = 1200.0  # [kg/m^3]
GRAVITY = 9.81

COMMON = """
[run]
gravity = 0 0 -9.81
end_time = {end} s
stop = {stop}
overlap_limit = 0.15
domain = box -50 -50 -30 50 50 600 mm
domain_exit = remove
[material.grain]
density = 1200
youngs_modulus = 5 MPa
poissons_ratio = 0.3
[contact]
restitution = 0.6
friction = 0.5
{bodies}
[output]
picture = {picture}
frames_every = 100 s
history_every = 5 ms
wall_forces = whole
[wall.hopper]
shape = mesh
template = {hopper}
material = grain
"""

LATTICE = """
[particles.grains]
radius = 2 mm
material = grain
count = {count}
insert = lattice
jitter = 0.1
region = cylinder 0 0 {low} mm  0 0 {high} mm  39 mm
[wall.gate]
shape = plane
point = 0 0 {gate} mm
normal = 0 0 1
material = grain
"""

BED = """
[particles.grains]
radius = 2 mm
material = grain
insert = file
file = {table}
overlaps = allow
[outlet.orifice]
kind = flow
point = 0 0 -2 mm
normal = 0 0 -1
"""


def ring(radius, z, facets):
    return [(radius * math.cos(2 * math.pi * k / facets), radius * math.sin(2 * math.pi * k / facets), z) for k in range(facets)]


def hopper(name, orifice, half_angle):
    """A tube over a flat floor (90 degrees) or a cone with a round opening at z = 0, as a wall template."""
    facets = 128
    top = 0.0 if half_angle == 90 else (VESSEL - orifice) / 2 / math.tan(math.radians(half_angle))
    rings = [ring(orifice / 2, 0.0, facets), ring(VESSEL / 2, top, facets), ring(VESSEL / 2, 500.0, facets)]
    WORK.mkdir(parents=True, exist_ok=True)
    path = WORK / f"{name}.obj"
    with open(path, "w") as file:
        for points in rings:
            file.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in points)
        for band in range(2):
            for k in range(facets):
                a, b = band * facets + k + 1, band * facets + (k + 1) % facets + 1
                file.write(f"f {a} {b} {b + facets} {a + facets}\n")
    return shapegen(name, path, "--wall", "--unit", "mm")


def fill(kind, half_angle, orifice, reuse):
    """A bed at rest over a closed opening; returns its table of bodies."""
    name = f"beverloo_{kind}_{orifice:g}_fill"
    low = 1.0 if half_angle == 90 else 70.0
    bodies = LATTICE.format(count=7000, low=low, high=low + 190.0, gate=-0.1)
    case = COMMON.format(end=0.8, stop="at_rest", bodies=bodies, hopper=hopper(name, orifice, half_angle), picture="no")
    return Run(name, case, "--threads", "1", reuse=reuse).directory / "final.csv"


class Discharge:
    """What runs out of one orifice: the mean rate while the flow is steady."""

    def __init__(self, kind, half_angle, orifice, table, reuse):
        name = f"beverloo_{kind}_{orifice:g}"
        bodies = BED.format(table=table)
        case = COMMON.format(end=0.9, stop="end_time", bodies=bodies, hopper=hopper(name, orifice, half_angle), picture="yes")
        self.run = Run(name, case, "--threads", "1", reuse=reuse)
        history = self.run.history
        self.time, self.mass = history["time"], history["orifice_mass"]
        grain = DENSITY * math.pi / 6 * (1e-3 * DIAMETER) ** 3
        whole = history["particles"][0] * grain
        steady = (self.time > 0.2) & (self.mass < 0.4 * whole)
        t, m = self.time[steady], self.mass[steady]
        self.rate = np.polyfit(t, m, 1)[0]
        parts = [np.polyfit(a, b, 1)[0] for a, b in zip(np.array_split(t, 5), np.array_split(m, 5))]
        self.error = np.std(parts, ddof=1) / math.sqrt(5)
        self.orifice = orifice


def bulk_density(table, low, high):
    """Mass over volume of a layer of the bed [kg/m^3]: shares of spheres between two heights [mm]."""
    z = 1e3 * np.loadtxt(table, delimiter=",", skiprows=1, usecols=5)
    r = DIAMETER / 2
    volume = 0.0
    for edge, sign in ((high, 1), (low, -1)):
        h = np.clip(edge - z, -r, r)  # of the plane above the center: the part of the sphere below it
        volume += sign * np.sum(math.pi * (r**3 * 2 / 3 + r**2 * h - h**3 / 3))
    return DENSITY * volume / (math.pi / 4 * VESSEL**2 * (high - low))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--reuse", action="store_true", help="keep finished runs")
    options = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        flat_bed = pool.submit(fill, "flat", 90, ORIFICES[0], options.reuse)
        cone_sizes = ORIFICES[1:2]
        cone_beds = [pool.submit(fill, "cone", CONE, d, options.reuse) for d in cone_sizes]
        table = flat_bed.result()
        flat = [pool.submit(Discharge, "flat", 90, d, table, options.reuse) for d in ORIFICES]
        cone = [pool.submit(Discharge, "cone", CONE, d, bed.result(), options.reuse) for d, bed in zip(cone_sizes, cone_beds)]
        flat, cone = [f.result() for f in flat], [c.result() for c in cone]
    bulk = bulk_density(table, 20.0, 60.0)
    d, sizes, rates = 1e-3 * DIAMETER, 1e-3 * np.array(ORIFICES), np.array([f.rate for f in flat])

    # W^(2/5) is a line over D: its root is k d, its slope C.
    slope, root = np.polyfit(sizes, rates**0.4, 1)
    k = -root / slope / d
    scale = bulk * math.sqrt(GRAVITY)
    c = slope**2.5 / scale
    exponent = np.polyfit(np.log(sizes - 1.4 * d), np.log(rates), 1)[0]
    c_fixed = np.exp(np.mean(np.log(rates / (scale * (sizes - 1.4 * d) ** 2.5))))

    page = Page("beverloo", "Discharge from hoppers")
    page.text(f"""
Spheres of {DIAMETER:g} mm run out of a flat-bottomed vessel of {VESSEL:g} mm through round openings of {ORIFICES[0]:g} to {ORIFICES[-1]:g} mm; vessel and floor
are one wall of triangles (128 facets around). {int(flat[0].run.history["particles"][0])} spheres, friction 0.5 everywhere, restitution 0.6, 5 MPa; they come to rest on a closed
opening first. Beverloo, Leniger and van de Velde (1961): W = C rho_b sqrt(g) (D - k d)^2.5 with C from 0.55 to 0.65 and k about 1.4 for spheres. Bulk density
of the bed at rest between 20 and 60 mm: {bulk:.0f} kg/m^3. Rates are slopes of the mass that has passed the opening, from 0.2 s on until 40 % are out, with the
standard error of five parts of that time.""")
    page.table(["opening [mm]", "D/d", "flat floor [g/s]", "with C = 0.58, k = 1.4 [g/s]", f"cone of {CONE:g} deg [g/s]", "cone over flat"],
               [[f"{f.orifice:g}", f"{f.orifice / DIAMETER:.2f}", f"{1e3 * f.rate:.1f} +- {1e3 * f.error:.1f}",
                 f"{1e3 * 0.58 * scale * (1e-3 * f.orifice - 1.4 * d) ** 2.5:.1f}",
                 next((f"{1e3 * q.rate:.1f} +- {1e3 * q.error:.1f}" for q in cone if q.orifice == f.orifice), ""),
                 next((f"{q.rate / f.rate:.2f}" for q in cone if q.orifice == f.orifice), "")] for f in flat])
    page.claim(f"with k = 1.4 the rate grows with the power 2.5 +- 0.1 of D - k d ({exponent:.2f})", abs(exponent - 2.5) < 0.1)
    page.shortfall(f"with k = 1.4, C lies between 0.55 and 0.65 ({c_fixed:.3f})", 0.55 < c_fixed < 0.65)
    page.claim(f"W^(2/5) is a straight line over D: k = {k:.2f}, C = {c:.3f}, no rate off it by more than 5 % "
               f"({max(abs(rates / (scale * c * (sizes - k * d) ** 2.5) - 1)):.3f})",
               max(abs(rates / (scale * c * (sizes - k * d) ** 2.5) - 1)) < 0.05)
    page.claim("a cone lets more out than a flat floor", all(q.rate > next(f.rate for f in flat if f.orifice == q.orifice) for q in cone))
    lost = [run.history["particles"] + run.history["domain_bodies"] - run.history["particles"][0] for run in (f.run for f in flat + cone)]
    page.claim("inserted, left and inside add up at every row", all(np.all(x == 0) for x in lost))

    figure, axes = plt.subplots()
    axes.errorbar(ORIFICES, [1e3 * f.rate for f in flat], [1e3 * f.error for f in flat], fmt="o", label="flat floor")
    axes.errorbar([q.orifice for q in cone], [1e3 * q.rate for q in cone], [1e3 * q.error for q in cone], fmt="s", label=f"cone of {CONE:g} deg")
    over = np.linspace(ORIFICES[0] - 2, ORIFICES[-1] + 2, 50)
    for value, style in ((0.55, "k:"), (0.65, "k--")):
        axes.plot(over, 1e3 * value * scale * (1e-3 * over - 1.4 * d) ** 2.5, style, lw=1, label=f"C = {value}, k = 1.4")
    axes.set(xlabel="opening [mm]", ylabel="rate [g/s]")
    axes.legend()
    page.plot(figure, "", "Rates of discharge")
    figure, axes = plt.subplots()
    for f in flat:
        force = f.run.history["hopper_force_z"]
        axes.plot(f.time, force / force[1], lw=0.8, label=f"{f.orifice:g} mm")
    axes.set(xlabel="time [s]", ylabel="vertical force on the vessel over that at the start")
    axes.legend()
    page.plot(figure, "_force", "The vessel feels its content less as it empties")
    page.picture(flat[-1].run.directory / "final.png", "The widest opening at the end")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
