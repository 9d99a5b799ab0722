#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Loads exported clumps into the codes they are written for and lets them fall.

usage: clump_files.py SHAPEGEN PROFILE. LIGGGHTS, LAMMPS and YADE each make a body of the file, step it under gravity without contact,
and must come out with the mass, the center, the inertia and the kinetic energy that the template promises. Exit code 77 (skipped) when
none of the three programs is installed.
"""
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

DENSITY = 1400.0
GRAVITY = 9.81
STEP, STEPS = 1e-6, 1000
SPEED = GRAVITY * STEP * STEPS


def run(command, folder):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    if result.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}")
    return result.stdout


def expect(what, found, wanted, tolerance):
    print(f"{what}: {found:.9g}, expected {wanted:.9g}")
    if abs(found - wanted) > tolerance * abs(wanted):
        sys.exit(f"{what}: found {found}, expected {wanted}")


def last_row(output):
    """The last row of LAMMPS' or LIGGGHTS' table."""
    rows = [line.split() for line in output.splitlines() if re.fullmatch(r"\s*\d+(\s+[-+.\deE]+)+\s*", line)]
    return [float(word) for word in rows[-1]]


def liggghts(folder, body):
    text = (folder / "clump.liggghts").read_text()
    command = next(line[2:] for line in text.splitlines() if line.startswith("# fix ID"))
    for word, value in {"ID": "pts", "SEED": "15485863", "TYPE": "1", "FILE": "clump.liggghts"}.items():
        command = re.sub(rf"\b{word}\b", value, command)
    (folder / "in.liggghts").write_text(f"""
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region reg block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 reg
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep {STEP}
fix gravity all gravity {GRAVITY} vector 0.0 0.0 -1.0
{command}
fix pdd all particledistribution/discrete 15485867 1 pts 1.0
region ins block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box
fix ins all insert/pack seed 32452843 distributiontemplate pdd maxattempt 200 insert_every once overlapcheck yes orientation random all_in yes vel constant 0. 0. 0. region ins particles_in_region 3
fix ms all multisphere
compute energy all ke/multisphere
thermo_style custom step atoms c_energy
thermo_modify norm no lost ignore
thermo {STEPS}
run {STEPS}
""")
    row = last_row(run(["liggghts", "-in", "in.liggghts"], folder))
    expect("LIGGGHTS, spheres of three clumps", row[1], 3 * body["spheres"], 0)
    # Inserted in the first step, the bodies have fallen for one step less at the least.
    expect("LIGGGHTS, kinetic energy", row[2], 1.5 * body["mass"] * SPEED**2, 0.01)


def lammps(folder, body):
    (folder / "in.lammps").write_text(f"""
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes cutoff 0.03
region box block -0.05 0.05 -0.05 0.05 -0.05 0.05
create_box 1 box
molecule body clump.lammps
fix props all property/atom mol ghost yes
create_atoms 0 single 0 0 0 mol body 4711
neigh_modify exclude molecule/intra all
pair_style gran/hertz/history 1e5 NULL 0 NULL 0.3 1
pair_coeff * *
fix rigid all rigid/small molecule mol body
fix gravity all gravity {GRAVITY} vector 0 0 -1
compute energy all ke/rigid rigid
variable mass equal mass(all)
timestep {STEP}
thermo_style custom step atoms v_mass c_energy
thermo {STEPS}
run {STEPS}
""")
    row = last_row(run(["lmp", "-in", "in.lammps"], folder))
    expect("LAMMPS, spheres", row[1], body["spheres"], 0)
    expect("LAMMPS, mass", row[2], body["mass"], 1e-6)
    # Forces act from the first step on, not from its beginning: half a step is missing.
    expect("LAMMPS, kinetic energy", row[3], 0.5 * body["mass"] * SPEED**2, 2e-3)


def yade(folder, body):
    (folder / "fall.py").write_text(f"""
import json, numpy, os
clump, members = O.bodies.appendClumped([utils.sphere(c[:3], c[3], material=FrictMat(density=c[5])) for c in numpy.loadtxt('clump.yade')])
state = O.bodies[clump].state
found = dict(spheres=len(members), mass=state.mass, center=list(state.pos), inertia=sorted(state.inertia))
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys()], [Law2_ScGeom_MindlinPhys_Mindlin()]),
             NewtonIntegrator(gravity=(0, 0, -{GRAVITY}), damping=0)]
O.dt = {STEP}
O.run({STEPS}, True)
found['speed'] = -state.vel[2]
json.dump(found, open('found.json', 'w'))
os._exit(0)
""")
    run(["yade", "-n", "-x", "fall.py"], folder)
    found = json.loads((folder / "found.json").read_text())
    expect("YADE, spheres", found["spheres"], body["spheres"], 0)
    expect("YADE, mass", found["mass"], body["mass"], 1e-6)
    offset = math.hypot(*found["center"]) / body["size"]
    expect("YADE, 1 + offset of the center", 1.0 + offset, 1.0, 1e-6)
    for axis, (moment, wanted) in enumerate(zip(found["inertia"], sorted(body["moments"]))):
        expect(f"YADE, moment {axis}", moment, wanted, body["tolerance"] + 1e-6)
    expect("YADE, speed", found["speed"], SPEED, 1e-3)


def main():
    shapegen, profile = (str(Path(path).resolve()) for path in sys.argv[1:])
    programs = {"liggghts": ("liggghts", liggghts), "lammps": ("lmp", lammps), "yade": ("yade", yade)}
    present = {name: use for name, (program, use) in programs.items() if shutil.which(program)}
    if not present:
        print("none of liggghts, lmp and yade is installed: .ci/install-packages validation")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run([shapegen, profile, "--clump-spheres", "60", "--resolution", "30", "-q", "-o", "clump.tpl"], folder)
        shape = json.loads(run([shapegen, "inspect", "clump.tpl", "--json"], folder))["shapes"][0]
        body = {
            "spheres": shape["counts"]["spheres"],
            "mass": DENSITY * shape["volume"],
            "moments": [DENSITY * m for m in shape["principal_moments_per_density"]],
            "size": shape["bounding_radius"],
            "tolerance": shape["certificate"]["mass_tolerance"],
        }
        for code, use in present.items():
            run([shapegen, "export", "clump.tpl", "-o", f"clump.{code}", "--format", code, "--density", f"{DENSITY} kg/m^3"], folder)
            use(folder, body)
    missing = [name for name in programs if name not in present]
    print("all as promised" + (f"; not installed: {', '.join(missing)}" if missing else ""))


main()
