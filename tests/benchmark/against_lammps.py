#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speed of demrun and LAMMPS on one settled bed of spheres, like with like: the same bodies, walls, Hertz-Mindlin law and time step, one
thread each, in turn. Prints a csv line per run (wall time per particle and step) and what both made of the bed. Needs the package lammps.

usage: tests/benchmark/against_lammps.py [SPHERES [STEPS]]
"""
import csv
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEMRUN = ROOT / "build/release/bin/demrun"
RADIUS = 2e-3  # m
DENSITY = 2500.0  # kg/m^3
MODULUS = 1e7  # Pa
POISSON = 0.3
RESTITUTION = 0.5
FRICTION = 0.5
STEP = 1e-5  # s, a seventieth of the shortest contact at 1 m/s
WIDTH = 0.08  # m, of the square floor: 8000 spheres are some 70 mm deep
ROUNDS = 3


def case(spheres, insertion, end_time):
    walls = "".join(f"""
[wall.{name}]
shape    = plane
point    = {point}
normal   = {normal}
material = glass
""" for name, point, normal in (("floor", "0 0 0", "0 0 1"), ("left", "0 0 0", "1 0 0"), ("right", f"{WIDTH} 0 0", "-1 0 0"),
                                ("front", "0 0 0", "0 1 0"), ("back", f"0 {WIDTH} 0", "0 -1 0")))
    return f"""
[run]
end_time  = {end_time}
time_step = {STEP}
gravity   = 0 0 -9.81
domain    = box -0.01 -0.01 -0.01  {WIDTH + 0.01} {WIDTH + 0.01} 0.5

[material.glass]
density        = {DENSITY}
youngs_modulus = {MODULUS}
poissons_ratio = {POISSON}

[contact]
restitution = {RESTITUTION}
friction    = {FRICTION}
tangential  = mindlin

[particles.beads]
radius   = {RADIUS}
material = glass
{insertion.format(spheres=spheres)}
{walls}
[measure.touching]
kind  = contacts
every = {end_time}
"""


def demrun(folder, name, text):
    """Runs a case on one thread; returns its summary and its final bodies."""
    (folder / f"{name}.ini").write_text(text)
    subprocess.run([DEMRUN, folder / f"{name}.ini", "--threads", "1", "--quiet", "--force", "--out", folder / name], check=True)
    with open(folder / name / "final.csv", newline="") as file:
        return json.loads((folder / name / "summary.json").read_text()), list(csv.DictReader(file))


def write_lammps(folder, bodies, steps):
    mass = DENSITY * 4 / 3 * 3.141592653589793 * RADIUS**3
    atoms = "".join(f"{k + 1} 1 {2 * RADIUS} {DENSITY} {b['x']} {b['y']} {b['z']}\n" for k, b in enumerate(bodies))
    velocities = "".join(f"{k + 1} {b['vx']} {b['vy']} {b['vz']} {b['wx']} {b['wy']} {b['wz']}\n" for k, b in enumerate(bodies))
    (folder / "bed.data").write_text(f"""beads

{len(bodies)} atoms
1 atom types
{-0.01} {WIDTH + 0.01} xlo xhi
{-0.01} {WIDTH + 0.01} ylo yhi
{-0.01} 0.5 zlo zhi

Atoms # sphere

{atoms}
Velocities

{velocities}""")
    law = f"hertz/material {MODULUS} {RESTITUTION} {POISSON} tangential mindlin NULL 1.0 {FRICTION} damping tsuji"
    (folder / "in.lammps").write_text(f"""
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
read_data bed.data
neighbor {0.1 * RADIUS} bin
neigh_modify delay 0 every 1 check yes
pair_style granular
pair_coeff * * {law}
fix motion all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
fix floor all wall/gran granular {law} zplane 0 NULL
fix left all wall/gran granular {law} xplane 0 {WIDTH}
fix front all wall/gran granular {law} yplane 0 {WIDTH}
compute neighbors all contact/atom
compute contacts all reduce ave c_neighbors
compute energy all ke
compute highest all reduce ave z
timestep {STEP}
thermo_style custom step c_energy c_contacts c_highest
thermo {steps}
run {steps}
""")
    return mass


def lammps(folder):
    """Seconds of LAMMPS' loop, and the last row of its table."""
    output = subprocess.run(["lmp", "-in", "in.lammps"], cwd=folder, check=True, capture_output=True, text=True,
                            env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"}).stdout
    before, rest = output.split("Loop time of ")
    return float(rest.split()[0]), before.strip().splitlines()[-1].split(), int(re.search(r"builds\s*=\s*(\d+)", rest)[1])


def main(spheres=8000, steps=4000):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        fill = f"count = {{spheres}}\ninsert = fill\nregion = box 0 0 0  {WIDTH} {WIDTH} 0.3"
        _, bed = demrun(folder, "settle", case(spheres, fill, 0.4))
        with open(folder / "bed.csv", "w", newline="") as file:
            columns = "x y z qw qx qy qz vx vy vz wx wy wz".split()
            writer = csv.DictWriter(file, columns, extrasaction="ignore")
            writer.writeheader()
            writer.writerows(bed)
        write_lammps(folder, bed, steps)
        times = {"demrun": [], "lammps": []}
        print("program,spheres,steps,us_per_particle_step")
        for _ in range(ROUNDS):
            summary, final = demrun(folder, "run", case(spheres, "insert = file\nfile = bed.csv\noverlaps = allow", steps * STEP))
            seconds, row, builds = lammps(folder)
            for program, value in (("demrun", summary["microseconds_per_particle_step"]), ("lammps", 1e6 * seconds / spheres / steps)):
                times[program].append(value)
                print(f"{program},{spheres},{steps},{value:.4f}", flush=True)
        ours, theirs = (statistics.median(times[p]) for p in ("demrun", "lammps"))
        height = sum(float(b["z"]) for b in final) / spheres
        print(f"median: demrun {ours:.3f} us, LAMMPS {theirs:.3f} us, ratio {ours / theirs:.2f}; at the end: mean height {1e3 * height:.3f} mm and "
              f"{1e3 * float(row[3]):.3f} mm, LAMMPS counts {float(row[2]):.2f} contacts per sphere and made {builds} neighbor lists")


if __name__ == "__main__":
    main(*(int(a) for a in sys.argv[1:]))
