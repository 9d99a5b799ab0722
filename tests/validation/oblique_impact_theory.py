# SPDX-License-Identifier: BSD-3-Clause
"""Oblique impact of a sphere on a rigid plane, twice: of an elastic sphere after Maw, Barber and Fawcett (1976), Wear 38, whose contact is a set
of rings that stick or slip each for itself (`slip_kept`), and by the law of docs/contact.md with its one spring, integrated apart from
demrun (`one_spring`).

Notation of the first: a radius of the contact, p pressure, q tangential traction, u displacement along the surface under it. On concentric discs of radii
a_i the tractions sqrt(1 - r^2/a_i^2) make, by Hertz for the normal direction, the displacements C pi/(4 a_i) (2 a_i^2 - r^2) inside and
C/(2 a_i) ((2 a_i^2 - r^2) asin(a_i/r) + r sqrt(r^2 - a_i^2) a_i/r) outside; along the surface, without its small unlikeness in the two
directions, the same times (2 - nu)/(2 - 2 nu)."""
import numpy as np


def shape_of_displacement(r, a):
    outside = np.maximum(r, a)
    return np.where(r <= a, np.pi / 4 * (2 * a - r**2 / a),
                    ((2 * a**2 - outside**2) * np.arcsin(a / outside) + a * np.sqrt(outside**2 - a**2)) / (2 * a))


def tractions(influence, pressure, inside, friction, before, shift):
    """Tangential tractions on rings when the body has moved by `shift`: sticking rings follow, slipping ones carry friction times the pressure
    against their slip."""
    stick, sign = inside.copy(), np.zeros(len(pressure))
    for _ in range(4 * len(pressure)):
        slip = ~stick
        q = np.where(slip, sign * friction * pressure, 0.0)
        if stick.any():
            q[stick] = np.linalg.solve(influence[np.ix_(stick, stick)], (before + shift - influence @ q)[stick])
        too_much = stick & (np.abs(q) > friction * pressure * (1 + 1e-9))
        backwards = slip & inside & (sign * (influence @ q - before - shift) > 1e-12 * abs(shift))
        if too_much.any():
            sign[too_much] = np.sign(q[too_much])
            stick &= ~too_much
        elif backwards.any():
            stick |= backwards
        else:
            break
    return q


def slip_kept(psi, poissons_ratio, rings=40, steps=600):
    """Slip velocity after an impact over that before it, of a solid sphere; psi = 2 (1 - nu) / (mu (2 - nu)) tan(angle of incidence of the
    surface). Units in which mass, radius, normal speed and friction are 1."""
    modulus = 1e6  # any that makes the overlap small
    duration = 2.8683 * modulus**-0.4
    deepest = (15 / (16 * modulus))**0.4
    friction, compliance = 1.0, (2 - poissons_ratio) / (2 - 2 * poissons_ratio) / modulus
    before_impact = psi * friction * (2 - poissons_ratio) / (2 - 2 * poissons_ratio)
    radii = 1.02 * np.sqrt(deepest) * np.arange(1, rings + 1) / rings
    r = radii - 0.5 * radii[0]
    basis = np.sqrt(np.maximum(0, 1 - (r[:, None] / radii)**2))
    influence = compliance * shape_of_displacement(r[:, None], radii) @ np.linalg.inv(basis)
    force_of = 2 / 3 * np.pi * radii**2 @ np.linalg.inv(basis)
    dt = duration / steps
    overlap, approach, slip, moved = 0.0, 1.0, before_impact, np.zeros(rings)
    while True:
        overlap += 0.5 * dt * approach
        approach -= dt * 4 / 3 * modulus * max(overlap, 0)**1.5
        overlap += 0.5 * dt * approach
        if overlap <= 0:
            return slip / before_impact
        a = np.sqrt(overlap)
        pressure = 2 * modulus / np.pi * a * np.sqrt(np.maximum(0, 1 - (r / a)**2))
        q = tractions(influence, pressure, r < a, friction, moved, slip * dt)
        moved = influence @ q
        slip -= dt * 3.5 * force_of @ q


def one_spring(material, radius, normal, sliding, spin, restitution, friction, steps=5000):
    """Speed along the plane and spin after impacts at speeds `normal` and `sliding` and with `spin` (arrays) by docs/contact.md, "Force law", with Mindlin's
    spring; explicit steps, of first order."""
    modulus, ratio, density = material
    mass = density * 4 / 3 * np.pi * radius**3
    stiffness, shear = modulus / (1 - ratio**2), modulus / (2 * (1 + ratio)) / (2 - ratio)
    damping = np.sqrt(5) * -np.log(restitution) / np.hypot(np.pi, np.log(restitution))
    dt = 3.3 * (mass**2 / (radius * stiffness**2 * normal.min()))**0.2 / steps
    overlap, approach = np.zeros_like(normal), normal.copy()
    speed, spin = sliding.copy(), spin.copy()
    spring, k_t, dissipated = np.zeros_like(normal), np.zeros_like(normal), np.zeros_like(normal)
    for step in range(steps):
        overlap = overlap + 0.5 * dt * approach
        inside = overlap > 0
        if step > 0 and not inside.any():
            break
        d = np.where(inside, overlap, 0.0)
        root, before = np.sqrt(radius * d), k_t
        k_n, k_t = 4 / 3 * stiffness * root, 8 * shear * root
        divisor = np.where(inside, k_t, 1.0)
        gamma = damping * np.sqrt(mass * k_n)
        # A spring that would gain more by stiffening than was dissipated keeps its force instead of its length.
        gain, softer = 0.5 * (k_t - before) * spring**2, before / divisor
        is_shorter = gain > dissipated
        gain = np.where(is_shorter, 0.5 * before * (softer - 1) * spring**2, gain)
        spring = np.where(is_shorter, softer * spring, spring)
        lever = radius - 0.5 * d
        slip = speed - lever * spin
        spring = spring + dt * slip
        force = -k_t * spring - 0.5 * gamma * slip
        limit = friction * k_n * d
        cut = np.clip(force, -limit, limit)
        pull = cut + 0.5 * gamma * slip
        kept = np.where(cut == force, spring, np.where(pull * cut > 0, -pull / divisor, 0.0))
        dissipated = dissipated - gain + gamma * approach**2 * dt + 0.5 * gamma * slip**2 * dt + np.abs(cut * (spring - kept))
        spring = kept
        speed = speed + dt * cut / mass
        spin = spin - dt * cut * lever / (0.4 * mass * radius**2)
        approach = approach - dt * (k_n * d + gamma * approach) / mass
        overlap = overlap + 0.5 * dt * approach
    return speed, spin
