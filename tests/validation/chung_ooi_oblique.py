# SPDX-License-Identifier: BSD-3-Clause
"""Oblique impacts and impacts with spin of spheres, tests 4-8 of Chung & Ooi (2011), Granular Matter 13."""
import sys

import numpy as np

from oblique_impact_theory import one_spring, slip_kept
from validation import Page, Run, plt, write_bodies

# name: Young's modulus [Pa], Poisson's ratio, density [kg/m^3]; the page says where they come from
MATERIALS = {"aluminium oxide": (3.8e11, 0.23, 4000.0), "aluminium alloy": (7.0e10, 0.33, 2700.0), "steel": (2.08e11, 0.30, 7850.0),
             "polyethylene": (1.0e9, 0.40, 1400.0), "nylon": (2.5e9, 0.40, 1000.0), "copper": (1.2e11, 0.35, 8900.0)}
YADE, PYSPH = "Yade, `Test4.py` (Angelidakis, Chareyre, Caulk 2023)", "PySPH (github.com/dineshadepu/pysph, `examples/dem/discontinuous_dem/chung_test_*.py`)"
SOURCES = [("aluminium oxide", "4", YADE), ("aluminium alloy", "4, 6, 7, 8", f"{YADE}; PySPH"), ("steel", "5", PYSPH), ("polyethylene", "5", PYSPH),
           ("nylon", "6", PYSPH), ("copper", "7", PYSPH)]
ANGLES = np.array([2.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0])  # [deg]
# Read from the paper's figure for aluminium oxide; the page says by whom.
PAPER_E_T = {5: 0.950, 10: 0.693, 15: 0.626, 20: 0.619, 25: 0.638, 30: 0.684, 35: 0.742, 40: 0.784, 50: 0.843, 60: 0.895, 70: 0.934, 80: 0.968, 85: 0.986}

CASE = """
[run]
end_time = {end} s
time_step = {step} s
gravity = 0 0 0
[material.m]
density = {density}
youngs_modulus = {modulus}
poissons_ratio = {ratio}
[material.partner]
density = {partner_density}
youngs_modulus = {partner_modulus}
poissons_ratio = {ratio}
[contact]
restitution = {restitution}
friction = {friction}
tangential = {tangential}
[particles.spheres]
radius = {radius} m
material = m
insert = file
file = {bodies}
{more}
[output]
picture = no
frames_every = {end} s
"""
# So stiff that only the sphere deforms.
RIGID = 1e20
PLANE = """
[wall.plane]
shape = plane
point = 0 0 0
normal = 0 0 1
material = partner
"""
PARTNERS = """
[particles.partners]
radius = {radius} m
material = partner
insert = file
file = {bodies}
"""


def contact_time(material, radius, speed, reduced=1.0):
    """Of a sphere on a rigid plane; `reduced` by a partner: mass, radius and modulus all halved by its like."""
    modulus, ratio, density = MATERIALS[material]
    mass, stiffness = density * 4 / 3 * np.pi * radius**3, modulus / (1 - ratio**2)
    return 2.8683 * ((reduced * mass)**2 / (reduced * radius * (reduced * stiffness)**2 * speed))**0.2


def impacts(name, material, radius, rows, speed, restitution, friction, partners=None, partner=(1.0, RIGID), tangential="mindlin",
            reduced=1.0):
    """Velocities and spins of spheres side by side after each has met the plane, or its partner."""
    modulus, ratio, density = MATERIALS[material]
    duration = contact_time(material, radius, speed, reduced)
    more = PLANE if partners is None else PARTNERS.format(radius=partners[0], bodies=write_bodies(f"{name}_partners", partners[1]))
    run = Run(name, CASE.format(
        end=3 * duration, step=duration / 1000, density=density, modulus=modulus, ratio=ratio, restitution=restitution, friction=friction,
        partner_density=partner[0], partner_modulus=partner[1], radius=radius, bodies=write_bodies(name, rows), more=more,
        tangential=tangential))
    final, count = run.final, len(rows)
    return {column: np.asarray(final[column])[:count] for column in ("vx", "vy", "vz", "wx", "wy", "wz")}


def on_plane(name, material, radius, normal, sliding, spin, restitution, friction, tangential="mindlin"):
    """Spheres that fly along x at `sliding` and at the plane at `normal`, with `spin` about y; arrays or numbers. Speeds and spins after, slip
    over what it was, and by how much of mu (1 + e) v_n the speed along the plane or 2/5 r w differ from an integration of the law apart from demrun."""
    sliding, spin, normal = np.broadcast_arrays(*(np.asarray(v, float) for v in (sliding, spin, normal)))
    gap = 0.02 * contact_time(material, radius, normal.max()) * normal
    rows = [{"x": 0.0, "y": 20 * radius * k, "z": radius + g, "vx": v, "vz": -n, "wy": w}
            for k, (v, n, w, g) in enumerate(zip(sliding, normal, spin, gap))]
    out = impacts(name, material, radius, rows, normal.min(), restitution, friction, tangential=tangential)
    slip = (out["vx"] - radius * out["wy"]) / (sliding - radius * spin)
    apart = np.nan
    if tangential == "mindlin":
        speed, turn = one_spring(MATERIALS[material], radius, normal, sliding, spin, restitution, friction)
        off = np.maximum(np.abs(out["vx"] - speed), 0.4 * radius * np.abs(out["wy"] - turn))
        apart = (off / (friction * (1 + restitution) * normal)).max()
    return {"vx": out["vx"], "wy": out["wy"], "slip": slip, "apart": apart}


def claim_apart(page, material, found):
    page.claim(f"{material}, all {len(found['vx'])} impacts: speed along the plane and spin within 0.1 % of mu (1 + e) v_n of the law integrated apart from "
               f"demrun (worst {100 * found['apart']:.3f} %)", found["apart"] < 1e-3)


def worst_sliding(found, normal, sliding, spin, radius, restitution, friction):
    """Of the impacts that slide all the while, by how much the change of speed and of spin differ from mu (1 + e) v_n and 5/2 of it, relative."""
    change = friction * (1 + restitution) * normal
    slides = np.abs(sliding - radius * spin) > 3.6 * change
    sign = np.sign(sliding - radius * spin)
    speed = np.abs(sign * (sliding - found["vx"]) / change - 1)[slides].max()
    turn = np.abs(sign * radius * (found["wy"] - spin) / (2.5 * change) - 1)[slides].max()
    return slides, speed, turn


def psi(material, friction, tangent):
    ratio = MATERIALS[material][1]
    return 2 * (1 - ratio) / (friction * (2 - ratio)) * tangent


def test_4(page):
    page.text("""
## Test 4: constant speed, angles from 2 to 85 degrees

A sphere of 2.5 mm radius hits a rigid plane with 3.9 m/s; e = 0.98, friction 0.092. e_t is the speed along the plane after the impact over that before.
""")
    theta = np.radians(ANGLES)
    normal, sliding = 3.9 * np.cos(theta), 3.9 * np.sin(theta)
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
    columns, rows = {}, []
    for material in ("aluminium oxide", "aluminium alloy"):
        theory = np.array([1 - (1 - slip_kept(psi(material, 0.092, t), MATERIALS[material][1])) / 3.5 for t in np.tan(theta)])
        for tangential in ("mindlin", "ratio"):
            name = f"chung_ooi_4_{material}_{tangential}".replace(" ", "_")
            found = on_plane(name, material, 2.5e-3, normal, sliding, 0.0, 0.98, 0.092, tangential)
            columns[material, tangential] = found["vx"] / sliding
            if tangential == "mindlin":
                slides, speed, turn = worst_sliding(found, normal, sliding, 0.0, 2.5e-3, 0.98, 0.092)
                page.claim(f"{material}, {slides.sum()} angles from {ANGLES[slides][0]:g} degrees on, which slide: v_t' = v_t - mu (1 + e) v_n within "
                           f"0.1 % of the change (worst {100 * speed:.3f} %)", speed < 1e-3)
                page.claim(f"{material}, the same: w' = 5/2 mu (1 + e) v_n / r within 0.3 %, lower by overlap / 2r (worst {100 * turn:.3f} %)", turn < 3e-3)
                claim_apart(page, material, found)
                axes[1].plot(ANGLES, found["wy"], "o" if material == "aluminium oxide" else "s", mfc="none", label=material)
        columns[material, "theory"] = theory
    for material in ("aluminium oxide", "aluminium alloy"):
        columns_of = [columns[material, kind] for kind in ("theory", "mindlin", "ratio")]
        printed = PAPER_E_T if material == "aluminium oxide" else {}
        rows += [[material, f"{angle:g}", *(f"{c[k]:.3f}" for c in columns_of), f"{printed[angle]:.3f}" if angle in printed else ""]
                 for k, angle in enumerate(ANGLES) if angle <= 40]
    page.table(["material", "angle [deg]", "e_t, elastic theory", "mindlin", "ratio", "paper's figure"], rows)
    oxide = "aluminium oxide"
    read = max(abs(columns[oxide, "mindlin"][np.flatnonzero(ANGLES == angle)[0]] - e_t) for angle, e_t in PAPER_E_T.items())
    page.claim(f"aluminium oxide, {len(PAPER_E_T)} angles from 5 to 85 degrees: e_t within 0.01 of the paper's figure (worst {read:.3f})", read < 0.01)
    gap = np.abs(columns[oxide, "mindlin"] - columns[oxide, "theory"])
    page.claim(f"aluminium oxide from 15 degrees on: e_t within 0.04 of the elastic theory (worst {gap[ANGLES >= 15].max():.3f})", gap[ANGLES >= 15].max() < 0.04)
    few = [columns[oxide, kind][:3] for kind in ("mindlin", "theory")]
    page.shortfall("aluminium oxide at 2, 5 and 10 degrees: e_t within 0.04 of the elastic theory ("
                   + " and ".join(", ".join(f"{e:.2f}" for e in values) for values in few) + "): in the theory rings at the rim slip while "
                   "others stick, one spring of Mindlin's stiffness slips as a whole or not at all", gap[:3].max() < 0.04)
    for kind, style in (("theory", "k-"), ("mindlin", "o"), ("ratio", "x")):
        axes[0].plot(ANGLES, columns[oxide, kind], style, mfc="none", lw=1, label=kind)
    axes[0].plot(PAPER_E_T.keys(), PAPER_E_T.values(), "r+", label="paper's figure")
    axes[0].set(xlabel="angle of incidence [deg]", ylabel="e_t, aluminium oxide")
    axes[1].set(xlabel="angle of incidence [deg]", ylabel="spin after the impact [rad/s]")
    for a in axes:
        a.legend()
    page.plot(figure, "_4", "Test 4")


def test_5(page):
    page.text("""
## Test 5: constant normal speed, different speeds along the plane

A sphere of 10 um radius hits a rigid plane with 5 m/s; e = 1, friction 0.3. The paper's curve for steel, read likewise, has r w' / (mu v_n) = 1.3, 2.5 and
3.9 at v_t / (mu v_n) = 1, 2 and 3, above both the law and the theory here, and 5 where impacts slide, as here. Why is not known; a parameter may differ.
""")
    tangents = np.array([0.1, 0.35, 0.7, 1.0, 1.35, 1.7, 2.0, 2.35, 3.0, 3.35, 4.0, 5.0, 6.0, 10.0, 20.0])  # v_t / (mu v_n)
    sliding = 0.3 * 5.0 * tangents
    figure, axes = plt.subplots(figsize=(5.5, 3.8))
    for material, style in (("steel", "o"), ("polyethylene", "s")):
        found = on_plane(f"chung_ooi_5_{material}", material, 1e-5, 5.0, sliding, 0.0, 1.0, 0.3)
        slides, speed, turn = worst_sliding(found, 5.0, sliding, 0.0, 1e-5, 1.0, 0.3)
        page.claim(f"{material}, {slides.sum()} impacts that slide: v_t' = v_t - 2 mu v_n within 0.1 % of the change (worst {100 * speed:.3f} %)", speed < 1e-3)
        # The soft sphere sinks in by a few percent of its radius.
        limit = 0.003 if material == "steel" else 0.03
        page.claim(f"{material}, the same: r w' / (mu v_n) = 5 within {100 * limit:g} % (worst {100 * turn:.3f} %)", turn < limit)
        claim_apart(page, material, found)
        axes.plot(tangents, 1e-5 * found["wy"] / 1.5, style, mfc="none", label=material)
        theory = [(1 - slip_kept(psi(material, 0.3, 0.3 * t), MATERIALS[material][1])) / 1.4 * t for t in tangents]
        axes.plot(tangents, theory, lw=1, label=f"{material}, elastic theory")
    axes.set(xlabel="v_t / (mu v_n)", ylabel="r w' / (mu v_n)")
    axes.legend()
    page.plot(figure, "_5", "Test 5")


def spins(radius, normal):
    return normal / radius * np.tan(np.radians(np.arange(5.0, 90.0, 5.0)))


def test_6(page):
    page.text("""
## Test 6: constant normal speed, different spins

A sphere of 100 mm radius hits a rigid plane with 0.2 m/s; e = 0.5, friction 0.4.
""")
    spin = spins(0.1, 0.2)
    results = {}
    for material in ("aluminium alloy", "nylon"):
        found = on_plane(f"chung_ooi_6_{material}".replace(" ", "_"), material, 0.1, 0.2, 0.0, spin, 0.5, 0.4)
        slides, speed, turn = worst_sliding(found, 0.2, 0.0, spin, 0.1, 0.5, 0.4)
        page.claim(f"{material}, {slides.sum()} impacts that slide: v_x' = mu (1 + e) v_n within 0.1 % (worst {100 * speed:.3f} %), the change of spin 5/2 of "
                   f"that over r within 0.3 % (worst {100 * turn:.3f} %)", speed < 1e-3 and turn < 3e-3)
        claim_apart(page, material, found)
        page.claim(f"{material}: the slip is never longer after the impact than before it (largest share kept {np.abs(found['slip']).max():.3f})",
                   np.abs(found["slip"]).max() < 1)
        results[material] = found
    page.table(["spin before [rad/s]", *(f"slip kept, {m}" for m in results)],
               [[f"{w:.3f}", *(f"{f['slip'][k]:.4f}" for f in results.values())] for k, w in enumerate(spin)])
    return results["aluminium alloy"]


def test_7(page):
    page.text("""
## Test 7: two equal spheres that roll on each other

Spheres of 100 mm radius meet at 0.2 m/s each and spin against each other, so that their surfaces meet without slip: nothing along the surface and no
spin may change. e = 0.5, friction 0.4.
""")
    spin = spins(0.1, 0.2)
    for material in ("aluminium alloy", "copper"):
        modulus, _, density = MATERIALS[material]
        gap = 1e-6
        rows = [{"x": -0.1 - gap, "y": k, "vx": 0.2, "wy": w} for k, w in enumerate(spin)]
        others = [{"x": 0.1 + gap, "y": k, "vx": -0.2, "wy": -w} for k, w in enumerate(spin)]
        out = impacts(f"chung_ooi_7_{material}".replace(" ", "_"), material, 0.1, rows, 0.4, 0.5, 0.4, (0.1, others), (density, modulus), reduced=0.5)
        turned = np.abs(out["wy"] / spin - 1).max()
        drift = np.hypot(out["vy"], out["vz"]).max()
        page.claim(f"{material}: spins within 1e-12 of what they were (worst {turned:.1e}), speed across below 1e-12 m/s ({drift:.1e})",
                   turned < 1e-12 and drift < 1e-12)
        page.claim(f"{material}: restitution within 0.001 (worst {np.abs(-out['vx'] / 0.2 - 0.5).max():.5f})", np.abs(-out["vx"] / 0.2 - 0.5).max() < 1e-3)


def test_8(page, on_the_plane):
    page.text("""
## Test 8: two different spheres, one at rest

A sphere of 100 mm radius with spin meets, at 0.2 m/s, one of 500 mm that rests and is a thousand times as dense and stiff, so
that the impact is that of test 6; and one of 500 mm
of its own material (aluminium alloy, e = 0.5, friction 0.4).
""")
    spin = spins(0.1, 0.2)
    modulus, _, density = MATERIALS["aluminium alloy"]
    gap = 1e-6
    rows = [{"x": -0.1 - gap, "y": 2.0 * k, "vx": 0.2, "wy": w} for k, w in enumerate(spin)]
    others = [{"x": 0.5 + gap, "y": 2.0 * k} for k in range(len(spin))]
    heavy = impacts("chung_ooi_8_heavy", "aluminium alloy", 0.1, rows, 0.2, 0.5, 0.4, (0.5, others), (1e3 * density, 1e3 * modulus))
    slip = (heavy["vz"] - 0.1 * heavy["wy"]) / (-0.1 * spin)
    gap_to_plane = np.abs(slip - on_the_plane["slip"]).max()
    page.claim(f"the heavy one: slip kept as on the plane of test 6 within 0.01 (worst {gap_to_plane:.4f}; R* is 5/6 of that on a plane)", gap_to_plane < 0.01)
    own = impacts("chung_ooi_8_own", "aluminium alloy", 0.1, rows, 0.2, 0.5, 0.4, (0.5, others), (density, modulus))
    impulse = (1 + 0.5) * 0.2 / (1 + 0.2**3)  # normal, over the mass of the small one
    slides = 0.1 * spin > 3.6 * 0.4 * impulse * (1 + 0.2**3)
    speed = np.abs(np.hypot(own["vz"], 0.0)[slides] / (0.4 * impulse) - 1).max()
    turn = np.abs(0.1 * np.abs(own["wy"] - spin)[slides] / (2.5 * 0.4 * impulse) - 1).max()
    page.claim(f"its own material, {slides.sum()} impacts that slide: v_t' = mu (1 + e) v_n m_2 / (m_1 + m_2) within 0.2 % (worst {100 * speed:.3f} %), the change "
               f"of spin 5/2 of that over r within 0.3 % (worst {100 * turn:.3f} %)", speed < 2e-3 and turn < 3e-3)


def main():
    page = Page("chung_ooi_oblique", "Oblique impacts of spheres: Chung and Ooi (2011), tests 4 to 8")
    page.text("""
Impacts that slide from touch to parting have closed forms, whatever the materials: friction gives mu times the normal impulse. All impacts on the plane
are compared with an integration of docs/contact.md's law apart from demrun, and those of tests 4 and 5 with the theory of elastic spheres in partial slip (Maw,
Barber and Fawcett 1976, for e = 1), both in `tests/validation/oblique_impact_theory.py`. Kharaz, Gorham and Salman (2001), who measured test 4 with
aluminium oxide on glass, report very close agreement with that theory. The plane is rigid; time step: contact time / 1000. `tangential = mindlin`, the default,
unless the table says otherwise.

**Parameters.** The paper's tables were not at hand; these are those of scripts of other codes that repeat its tests. The e_t of test 4 was read
from the paper's figure by the author of those of PySPH (a file beside them, whose vertical axis begins at 0 where that of the figure begins at 0.4: right
again for the angles that slide).""")
    page.table(["material", "E [GPa]", "nu", "density [kg/m^3]", "tests", "taken from"],
               [[name, f"{MATERIALS[name][0] / 1e9:g}", f"{MATERIALS[name][1]:g}", f"{MATERIALS[name][2]:g}", tests, source] for name, tests, source in SOURCES])
    page.text("""
Radius, speed, e and friction of each test are stated with it: of test 4 from Yade, where the plane is a thousand times stiffer than the sphere, of 5, 7 and 8
from PySPH, where the plane of test 5 is as stiff as the sphere; here both are rigid. Test 6 takes sphere and materials of test 8. PySPH's test 7 has
700 GPa for the alloy, its test 8, as Yade, 70.""")
    test_4(page)
    test_5(page)
    plane = test_6(page)
    test_7(page)
    test_8(page, plane)
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())
