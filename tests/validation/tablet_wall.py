# SPDX-License-Identifier: BSD-3-Clause
"""A tablet hits a flat wall at 20 angles ([SR] Sec. 3.1): rebound against the closed form."""
import sys

import numpy as np

import validation
from validation import Page, Run, cook, plt, write_bodies

BAND_RADIUS, BAND_HEIGHT, CAP_HEIGHT = 5.675e-3, 4.0e-3, 1.23e-3
RESTITUTION, SPEED, DENSITY = 0.6, 1.0, 1191.3
ANGLES = np.radians([*range(0, 90, 5), 87.5, 90])
CAP_RADIUS = 0.5 * (BAND_RADIUS**2 + CAP_HEIGHT**2) / CAP_HEIGHT
CAP_OFFSET = CAP_RADIUS - (CAP_HEIGHT + 0.5 * BAND_HEIGHT)
ON_CAP = np.arcsin(BAND_RADIUS / CAP_RADIUS)
GAP = 20e-6
# Exact volume and moment of the sharp tablet, METHODS of the SR-DEM paper, Eqs. 1-4.
VOLUME, MOMENT = 5.311042e-7, 6.228876e-9

CASE = """
[run]
end_time = 0.8 ms
time_step = 1e-7 s
gravity = 0 0 0
[material.tablet]
density = 1191.3
youngs_modulus = 2.99 GPa
poissons_ratio = 0.3
[contact]
model = hertz
restitution = 0.6
friction = 0
damping_mass = {damping_mass}
contact = {contact}
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


def closed_form(theta):
    """Velocity and spin after the impact of the sharp tablet, [SR] Eqs. 24-26 corrected."""
    mass = VOLUME * DENSITY
    radius = np.hypot(BAND_RADIUS, 0.5 * BAND_HEIGHT)
    alpha = np.arctan(0.5 * BAND_HEIGHT / BAND_RADIUS)
    lever = np.where(theta < ON_CAP, CAP_OFFSET * np.sin(theta), radius * np.cos(alpha + theta))
    lever[theta > np.radians(89.9)] = 0.0  # the band meets the wall along a line
    spin = mass * SPEED * (1 + RESTITUTION) * lever / (MOMENT + mass * lever**2)
    return spin * lever - RESTITUTION * SPEED, spin


def height(theta):
    """Centre's height above the lowest point of the sharp tablet."""
    cap = CAP_RADIUS - CAP_OFFSET * np.cos(theta)
    edge = BAND_RADIUS * np.sin(theta) + 0.5 * BAND_HEIGHT * np.cos(theta)
    return np.where(theta < ON_CAP, cap, edge)


def rebound(name, template, contact, damping_mass):
    """Velocity [m/s] (down positive) and spin [rad/s] at the end of the first contact."""
    bodies = write_bodies(name, [
        {"x": 0.02 * k, "z": height(t) + GAP, "qw": np.cos(t / 2), "qy": np.sin(t / 2), "vz": -SPEED}
        for k, t in enumerate(ANGLES)])
    run = Run(name, CASE.format(template=template, bodies=bodies, contact=contact,
                                damping_mass=damping_mass))
    _, frames = run.frames()
    velocity, spin = frames["velocity"][:, :, 2], frames["angular_velocity"][:, :, 1]
    first = []
    for k in range(len(ANGLES)):
        changed = velocity[:, k] != velocity[0, k]
        steady = changed[1:] & (np.diff(velocity[:, k]) == 0)
        first.append(1 + np.argmax(steady) if steady.any() else -1)
    rows = np.arange(len(ANGLES))
    return -velocity[first, rows], spin[first, rows]


def main():
    page = Page("tablet_wall", "A tablet hits a wall")
    page.text("""
A bi-convex tablet falls on a frictionless flat wall with 1 m/s and no spin, its axis tilted by 0 to 90 degrees
([SR] Sec. 3.1; time step 1e-7 s, restitution 0.6 at the contact point). Rigid-body impact theory gives velocity and spin
after it ([SR] Eqs. 24-26 with the lever arms corrected). The time step, the material and the angles are the paper's.""")
    velocity, spin = closed_form(ANGLES)
    spin_scale = BAND_RADIUS / SPEED
    runs = {
        "sharp edge, continuous": ("tablet", "continuous", "contact"),
        "sharp edge, nodes": ("tablet", "nodes", "contact"),
        "rounded edge, continuous": ("rounded_tablet", "continuous", "contact"),
        "sharp edge, continuous, reduced mass (paper)": ("tablet", "continuous", "reduced"),
    }
    results = {}
    for k, (label, (profile, contact, damping)) in enumerate(runs.items()):
        options = ("--nodes", "6000") if contact == "nodes" else ()
        results[label] = rebound(f"tablet_wall_{k}", cook(profile, *options), contact, damping)

    def errors(label):
        v, w = results[label]
        dv = np.abs(v - velocity) / np.abs(velocity).max()
        dw = np.abs(w + spin if np.sign(w[1]) != np.sign(spin[1]) else w - spin) / np.abs(spin).max()
        return dv, dw

    rows = []
    for label in runs:
        dv, dw = errors(label)
        rows.append([label, *(f"{100 * x:.3f}" for x in (dv.mean(), dv.max(), dw.mean(), dw.max()))])
    page.text("Deviation from the closed form of the sharp tablet in % of the largest value over the angles:")
    page.table(["run", "velocity, mean", "velocity, worst", "spin, mean", "spin, worst"], rows)

    dv, dw = errors("sharp edge, continuous")
    page.claim(f"sharp tablet: velocity within 0.4 % on average ({100 * dv.mean():.3f} %) and 1 % at worst "
               f"({100 * dv.max():.3f} %)", dv.mean() < 4e-3 and dv.max() < 1e-2)
    page.claim(f"sharp tablet: spin within 0.4 % on average ({100 * dw.mean():.3f} %) and 1 % at worst "
               f"({100 * dw.max():.3f} %)", dw.mean() < 4e-3 and dw.max() < 1e-2)

    figure, axes = plt.subplots(1, 2, figsize=(9.5, 4))
    fine = np.radians(np.linspace(0, 89.8, 400))
    fine_velocity, fine_spin = closed_form(fine)
    markers = iter("o^sx")
    axes[0].plot(np.degrees(fine), -fine_velocity / SPEED, "k-", lw=1, label="closed form")
    axes[1].plot(np.degrees(fine), fine_spin * spin_scale, "k-", lw=1, label="closed form")
    for label, (v, w) in results.items():
        marker = next(markers)
        sign = np.sign(w[1]) * np.sign(spin[1])
        axes[0].plot(np.degrees(ANGLES), -v / SPEED, marker, ms=4, mfc="none", label=label)
        axes[1].plot(np.degrees(ANGLES), sign * w * spin_scale, marker, ms=4, mfc="none", label=label)
    axes[0].set(xlabel="tilt of the axis [deg]", ylabel="velocity after / before")
    axes[1].set(xlabel="tilt of the axis [deg]", ylabel="spin after x band radius / speed before")
    axes[0].legend(fontsize=7)
    page.plot(figure, "", "Velocity and spin after the impact against the tilt of the tablet's axis")

    page.text("Every angle, sharp edge, continuous contact:")
    v, w = results["sharp edge, continuous"]
    sign = np.sign(w[1]) * np.sign(spin[1])
    page.table(["tilt [deg]", "velocity [m/s]", "closed form", "spin [rad/s]", "closed form"],
               [[f"{np.degrees(t):g}", f"{-a:.5f}", f"{-b:.5f}", f"{sign * c:.3f}", f"{d:.3f}"]
                for t, a, b, c, d in zip(ANGLES, v, velocity, w, spin)])
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
