# SPDX-License-Identifier: BSD-3-Clause
"""Two spheroids collide head-on and at 45 degrees ([SR] Sec. 3.2)."""
import sys

import numpy as np

from validation import Page, Run, cook, plt, write_bodies

LONG, SHORT = 5e-3, 2.5e-3
DENSITY, MODULUS, RATIO, RESTITUTION, SPEED = 2500.0, 1e10, 0.3, 0.6, 1.0
MASS = DENSITY * 4 / 3 * np.pi * LONG * SHORT**2
MOMENT = MASS / 5 * (LONG**2 + SHORT**2)  # about a short axis

CASE = """
[run]
end_time = 0.15 ms
time_step = 1e-7 s
gravity = 0 0 0
[material.m]
density = 2500
youngs_modulus = 10 GPa
poissons_ratio = 0.3
[contact]
model = hertz
restitution = 0.6
friction = 0
radius = {radius}
contact = {contact}
[particles.lower]
template = {template}
material = m
insert = file
fixed = yes
file = {lower}
[particles.upper]
template = {template}
material = m
insert = file
file = {upper}
[output]
frames_every = 1e-7 s
"""


def tilted(angle):
    """Quaternion that lays the long axis (body z) along x and turns it by `angle` about y."""
    half = 0.5 * (0.5 * np.pi + angle)
    return {"qw": np.cos(half), "qy": np.sin(half)}


def first_contact(angle):
    """Center distance along z at first contact, with the lever arm of the normal about the upper
    body's center, by brute force: support functions of both ellipses over all directions in the
    plane of the axes."""
    phi = np.linspace(0, np.pi, 2_000_001)
    n = np.array([np.cos(phi), np.sin(phi)])  # from lower to upper, (x, z)

    def support(along_x):
        axis = np.array([np.cos(along_x), -np.sin(along_x)])
        q = LONG**2 - SHORT**2
        a = axis @ n
        h = np.sqrt(SHORT**2 + q * a**2)
        return h, (SHORT**2 * n + q * a * axis[:, None]) / h

    h_lower, _ = support(0.0)
    h_upper, x_upper = support(angle)
    distance = (h_lower + h_upper) / np.maximum(n[1], 1e-9)
    k = distance[n[1] > 0.1].argmin() + np.flatnonzero(n[1] > 0.1)[0]
    r = -x_upper[:, k]  # contact point from the upper body's center
    lever = r[1] * n[0, k] - r[0] * n[1, k]  # (r x n) about y
    return distance[k], n[:, k], lever


def rebound(angle):
    """Velocity along z and spin about y after the impact, by rigid-body impulse."""
    _, n, lever = first_contact(angle)
    impulse = (1 + RESTITUTION) * SPEED * n[1] / (1 / MASS + lever**2 / MOMENT)
    return -SPEED + impulse * n[1] / MASS, impulse * lever / MOMENT


def collide(angle, radius, contact):
    name = f"spheroids_{int(np.degrees(angle))}_{radius}_{contact}"
    height = first_contact(angle)[0] + 2e-6
    template = cook(f"units = m\nshape = spheroid\na = {SHORT}\nc = {LONG}\n",
                    *(("--nodes", "20000") if contact == "nodes" else ()))
    run = Run(name, CASE.format(
        template=template, radius=radius, contact=contact,
        lower=write_bodies(name + "_lower", [tilted(0.0)]),
        upper=write_bodies(name + "_upper", [tilted(angle) | {"z": height, "vz": -SPEED}])))
    times, frames = run.frames()
    return times, frames["velocity"][:, 1, 2], frames["angular_velocity"][:, 1, 1]


def main():
    page = Page("spheroids", "Two spheroids collide")
    page.text("""
A spheroid (semi-axes 5, 2.5, 2.5 mm; E = 10 GPa, nu = 0.3, 2500 kg/m3, e = 0.6) falls with 1 m/s on a fixed one that lies
flat, itself flat (head-on) or turned by 45 degrees ([SR] Sec. 3.2, time step 1e-7 s). Rigid-body impulse at the first point of
contact, found by brute force over directions, gives velocity and spin afterwards; the curvature model may change how long
the contact lasts, not its outcome. Without friction (friction = 0): no tangential force acts, whichever law `tangential` names.""")
    figure, axes = plt.subplots(1, 2, figsize=(9.5, 4))
    rows = []
    for side, angle in enumerate((0.0, np.pi / 4)):
        v_expected, w_expected = rebound(angle)
        axes[side].axhline(v_expected, color="k", lw=0.8, ls="--", label="rigid-body impulse")
        for radius, contact in (("onset", "continuous"), ("equivalent", "continuous"), ("onset", "nodes")):
            times, velocity, spin = collide(angle, radius, contact)
            axes[side].plot(times * 1e6, velocity, label=f"radius = {radius}, {contact}")
            rows.append([f"{np.degrees(angle):g}", radius, contact, f"{velocity[-1]:.5f}", f"{v_expected:.5f}",
                         f"{spin[-1]:.3f}", f"{w_expected:.3f}"])
            scale = max(abs(w_expected) * LONG, SPEED)
            error = max(abs(velocity[-1] - v_expected) / SPEED, abs(spin[-1] - w_expected) * LONG / scale)
            limit = 5e-3 if contact == "continuous" else 2e-2
            page.claim(f"{np.degrees(angle):g} degrees, {radius}, {contact}: within {100 * limit:g} % of "
                       f"impulse theory ({100 * error:.3f} %)", error < limit)
        axes[side].set(xlabel="time [us]", ylabel="velocity of the upper spheroid [m/s]",
                       title=f"{np.degrees(angle):g} degrees")
        axes[side].legend(fontsize=7)
    page.lines.append("")
    page.table(["angle [deg]", "radius", "contact", "velocity after [m/s]", "theory", "spin after [rad/s]", "theory"], rows)
    page.plot(figure, "", "Velocity of the upper spheroid through the collision")
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
