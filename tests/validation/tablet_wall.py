# SPDX-License-Identifier: BSD-3-Clause
"""A tablet hits a flat wall at 20 angles ([SR] Sec. 3.1): rebound against the closed form."""
import sys

import numpy as np

from validation import Page, Run, cook, inspect, plt, write_bodies

BAND_RADIUS, BAND_HEIGHT, CAP_HEIGHT = 5.675e-3, 4.0e-3, 1.23e-3
RESTITUTION, SPEED, DENSITY = 0.6, 1.0, 1191.3
ANGLES = np.radians([*range(0, 90, 5), 87.5, 90])
GAP = 20e-6

CASE = """
[run]
end_time = 0.8 ms
time_step = {step} s
gravity = 0 0 0
[material.tablet]
density = 1191.3
youngs_modulus = {modulus}
poissons_ratio = 0.3
[contact]
model = hertz
restitution = {restitution}
friction = 0
damping_mass = {damping_mass}
contact = {contact}
radius = {radius}
{more}
[particles.tablets]
template = {template}
material = tablet
insert = file
file = {bodies}
[wall.floor]
shape = plane
point = 0 0 0
normal = 0 0 1
material = tablet
[output]
frames_every = 2e-6 s
"""


class Tablet:
    """Geometry of a tablet whose edge between cap and band is rounded with `edge` [m]; 0: sharp."""

    def __init__(self, template, edge):
        shape = inspect(template)["shapes"][0]
        self.template, self.edge = template, edge
        self.mass = DENSITY * shape["volume"]
        self.moment = DENSITY * shape["principal_moments_per_density"][0]
        self.cap_radius = 0.5 * (BAND_RADIUS**2 + CAP_HEIGHT**2) / CAP_HEIGHT
        self.cap_offset = self.cap_radius - (CAP_HEIGHT + 0.5 * BAND_HEIGHT)
        # Center of the edge's arc: `edge` inside the band and inside the cap's sphere.
        self.edge_r = BAND_RADIUS - edge
        self.edge_z = -self.cap_offset + np.sqrt((self.cap_radius - edge)**2 - self.edge_r**2)
        self.on_cap = np.arcsin(self.edge_r / (self.cap_radius - edge))

    def height(self, theta):
        """Of the center above the lowest point of the tablet tilted by theta."""
        cap = self.cap_radius - self.cap_offset * np.cos(theta)
        edge = self.edge + self.edge_r * np.sin(theta) + self.edge_z * np.cos(theta)
        return np.where(theta < self.on_cap, cap, edge)

    def closed_form(self, theta):
        """Velocity (down positive) and spin after the impact, [SR] Eqs. 24-26 corrected: the lever
        arm is where the surface that touches has its center of curvature."""
        lever = np.where(theta < self.on_cap, self.cap_offset * np.sin(theta),
                         self.edge_r * np.cos(theta) - self.edge_z * np.sin(theta))
        lever[theta > np.radians(89.9)] = 0.0  # the band meets the wall along a line
        spin = self.mass * SPEED * (1 + RESTITUTION) * lever / (self.moment + self.mass * lever**2)
        return spin * lever - RESTITUTION * SPEED, spin


def rebound(name, tablet, gap=GAP, **options):
    """Velocity [m/s] (down positive) and spin [rad/s] at the end of the first contact."""
    velocity, spin = states_after(name, tablet, gap, **options)
    return -velocity, -spin[:, 1]  # the tablet is tilted about -y


def states_after(name, tablet, gap=GAP, **options):
    """Upward velocity [m/s] and angular velocity (n, 3) [rad/s] at the end of the first contact."""
    bodies = write_bodies(name, [
        {"x": 0.02 * k, "z": tablet.height(t) + gap, "qw": np.cos(t / 2), "qy": np.sin(t / 2), "vz": -SPEED}
        for k, t in enumerate(ANGLES)])
    settings = {"modulus": 2.99e9, "step": 1e-7, "contact": "continuous", "damping_mass": "contact",
                "radius": "onset", "restitution": RESTITUTION, "more": ""} | options
    run = Run(name, CASE.format(template=tablet.template, bodies=bodies, **settings))
    _, frames = run.frames()
    velocity = frames["velocity"][:, :, 2]
    first = []
    for k in range(len(ANGLES)):
        changed = velocity[:, k] != velocity[0, k]
        steady = changed[1:] & (np.diff(velocity[:, k]) == 0)
        first.append(1 + np.argmax(steady) if steady.any() else -1)
    rows = np.arange(len(ANGLES))
    return velocity[first, rows], frames["angular_velocity"][first, rows]


def main():
    page = Page("tablet_wall", "A tablet hits a wall")
    page.text("""
A bi-convex tablet falls on a frictionless flat wall with 1 m/s and no spin, its axis tilted by 0 to 90 degrees ([SR] Sec. 3.1:
time step 1e-7 s, G = 1.15 GPa for tablet and wall, restitution 0.6 at the contact point). Rigid-body impact theory gives velocity
and spin after it ([SR] Eqs. 24-26 with the lever arms corrected), for an impact that takes no time. A real one takes time, in which
the tablet turns: the deviation falls in proportion to the contact time, down to none. So the effective radius R*, which sets the stiffness
at the sharp edge (its radius of curvature is zero and clamped to 1 % of the tablet's size), shows here, and the last two rows
make the material stiffer.""")
    sharp = Tablet(cook("tablet"), 0.0)
    fine_nodes = Tablet(cook("tablet", "--nodes", "6000"), 0.0)
    rounded = Tablet(cook("rounded_tablet"), BAND_RADIUS / 30)
    runs = {
        "sharp": (sharp, {}),
        "sharp, radius = equivalent": (sharp, {"radius": "equivalent"}),
        "rounded": (rounded, {}),
        "rounded, radius = equivalent": (rounded, {"radius": "equivalent"}),
        "sharp, contact = nodes (6000)": (fine_nodes, {"contact": "nodes"}),
        "sharp, damping_mass = reduced (paper)": (sharp, {"damping_mass": "reduced"}),
        "sharp, 10 times stiffer": (sharp, {"modulus": 2.99e10, "step": 5e-8}),
        "sharp, 100 times stiffer": (sharp, {"modulus": 2.99e11, "step": 2e-8}),
    }
    results, deviation = {}, {}
    for k, (label, (tablet, options)) in enumerate(runs.items()):
        v, w = results[label] = rebound(f"tablet_wall_{k}", tablet, **options)
        v_exact, w_exact = tablet.closed_form(ANGLES)
        dv, dw = np.abs(v - v_exact) / SPEED, np.abs(w - w_exact) / np.abs(w_exact).max()
        deviation[label] = 100 * np.array([dv.mean(), dv.max(), dw.mean(), dw.max()])
    page.text("""Deviation from the closed form over the 20 angles, velocity in % of the impact velocity, spin in % of the largest spin. Continuous
contact, `damping_mass = contact` and `radius = onset` (the defaults) unless the row says otherwise:""")
    page.table(["run", "velocity, mean", "velocity, worst", "spin, mean", "spin, worst"],
               [[label, *(f"{d:.3f}" for d in deviation[label])] for label in runs])
    page.text("""The aim is 0.4 % on average and 1 % at worst. The default misses it by what a real contact time costs at the sharp edge, where
R* is 50 times smaller than the equivalent radius and the contact 2.2 times longer; `radius = equivalent`, the papers' choice, meets it:""")

    def within(label, mean, worst):
        d = deviation[label]
        statement = (f"{label}: velocity and spin within {mean:g} % on average ({d[0]:.3f}, {d[2]:.3f}) and "
                     f"{worst:g} % at worst ({d[1]:.3f}, {d[3]:.3f})")
        return statement, max(d[0], d[2]) <= mean and max(d[1], d[3]) <= worst

    page.claim(*within("sharp, radius = equivalent", 0.4, 1.0))
    page.claim(*within("rounded, radius = equivalent", 0.4, 1.0))
    page.shortfall(*within("sharp", 0.4, 1.0))
    page.shortfall(*within("rounded", 0.4, 1.0))
    page.claim(*within("sharp", 0.6, 1.2))
    page.claim(*within("rounded", 0.5, 1.0))
    page.claim(*within("sharp, contact = nodes (6000)", 0.6, 1.2))
    page.claim(*within("sharp, 10 times stiffer", 0.25, 0.5))
    page.claim(*within("sharp, 100 times stiffer", 0.1, 0.2))
    page.lines.append("")

    figure, axes = plt.subplots(1, 2, figsize=(9.5, 4))
    fine = np.radians(np.linspace(0, 89.8, 400))
    velocity, spin = sharp.closed_form(fine)
    axes[0].plot(np.degrees(fine), -velocity / SPEED, "k-", lw=1, label="closed form, sharp")
    axes[1].plot(np.degrees(fine), spin * BAND_RADIUS / SPEED, "k-", lw=1, label="closed form, sharp")
    for marker, size, label in (("s", 8, "sharp, contact = nodes (6000)"), ("o", 5, "sharp"), ("^", 3, "rounded"),
                                ("x", 5, "sharp, damping_mass = reduced (paper)")):
        v, w = results[label]
        axes[0].plot(np.degrees(ANGLES), -v / SPEED, marker, ms=size, mfc="none", label=label)
        axes[1].plot(np.degrees(ANGLES), w * BAND_RADIUS / SPEED, marker, ms=size, mfc="none", label=label)
    axes[0].set(xlabel="tilt of the axis [deg]", ylabel="velocity after / before")
    axes[1].set(xlabel="tilt of the axis [deg]", ylabel="spin after x band radius / speed before")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncols=3, fontsize=8, frameon=False)
    figure.subplots_adjust(bottom=0.25, wspace=0.25)
    page.plot(figure, "", "Velocity and spin after the impact against the tilt of the tablet's axis")

    page.text("Every angle, sharp edge, `radius = equivalent`:")
    (v, w), (v_exact, w_exact) = results["sharp, radius = equivalent"], sharp.closed_form(ANGLES)
    page.table(["tilt [deg]", "velocity [m/s]", "closed form", "spin [rad/s]", "closed form"],
               [[f"{np.degrees(t):g}", f"{-a:.5f}", f"{-b:.5f}", f"{c:.3f}", f"{d:.3f}"]
                for t, a, b, c, d in zip(ANGLES, v, v_exact, w, w_exact)])
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
