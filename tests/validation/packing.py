# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the packing cases: a case of data/cases run with several seeds, its fill heights."""
import argparse
import concurrent.futures
import csv
import os

import numpy as np

from validation import ROOT, Page, Run, plt

MEASURES = {"highest point": "height_highest", "mean of the ten highest": "height_top_ten",
            "mean surface seen from above": "height_surface"}
# What grains and vessel of [GC] are, in the run that makes a bed and in one that looks at it.
GRAINS = """
[material.grain]
density = 2500
youngs_modulus = 50 MPa
poissons_ratio = 0.3
[wall.vessel]
shape = cylinder
point = 0 0 0
radius = {radius} mm
material = grain
"""
# Grains that fall into the vessel, with the contact parameters of [GC] Table 7.
FALL = GRAINS + """
[run]
end_time = {end} s
stop = at_rest
time_step_divisor = {divisor}
seed = {seed}
[contact]
model = linear
normal_stiffness = 1e4
restitution = 0.8
tangential_restitution = 0.6
friction = 0.1
[measure.height]
kind = fill_height
every = 20 ms
[particles.rain]
template = {template}
material = grain
count = {count}
region = cylinder 0 0 {low} mm  0 0 {high} mm  {inner} mm
"""
# In batches, all free to move to the end.
RAIN = FALL + """
insert = batches
batch = {batch}
every = {every} ms
[output]
frames_every = {frames} ms
history_every = 5 ms
"""
# One batch that falls onto what has come to rest before.
BATCH = FALL + """
{bed}
[output]
frames_every = 50 ms
history_every = 5 ms
picture = {picture}
"""
BED = """
[particles.bed_{number}]
template = {template}
material = grain
insert = file
file = {file}
fixed = yes
overlaps = allow
"""
AUTO = ("run.time_step=auto",)


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=3, help="runs with the automatic time step, minutes each")
    parser.add_argument("--paper-seeds", type=int, default=2, help="runs with the paper's time step, up to an hour each")
    parser.add_argument("--variant-seeds", type=int, default=3, help="runs of every other way of filling")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--reuse", action="store_true", help="take runs that are finished as they are")
    return parser.parse_args()


def pack(name, template, options, seeds, variant="", settings=(), kind=None):
    """Runs data/cases/NAME.ini with seeds 1 to `seeds`, one core each, with `settings` (section.key=value) in place of its own;
    `kind` is the section of the particles, where its name is not the template's."""
    text = (ROOT / f"data/cases/{name}.ini").read_text()
    sets = [f"particles.{kind or template.stem}.template={template}", *settings]

    def one(seed):
        return Run(f"{name}{variant}_{seed}", text, "--threads", "1",
                   *(word for s in [f"run.seed={seed}", *sets] for word in ("--set", s)), reuse=options.reuse)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        return list(pool.map(one, range(1, seeds + 1)))


def bed(number, template, run):
    """Section of a case: the bodies that `run` let fall, frozen where they came to rest."""
    return BED.format(number=number, template=template, file=frozen(run))


def frozen(run):
    """A table of the bodies that a run let fall, without their velocities."""
    path = run.directory / "frozen.csv"
    columns = "template x y z qw qx qy qz".split()
    with open(run.directory / "final.csv", newline="") as source, open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows([row[c] for c in columns] for row in csv.DictReader(source) if row["group"] == "rain")
    return path


def deposit(name, templates, batch, fall, seed, reuse, **case):
    """The packing of [GC] Sec. 7.1: batch after batch falls onto the bed and is frozen there once it lies still. `templates`: one per batch;
    `fall`: height of the room above the bed that a batch starts in [mm]. Returns the runs, one per batch, and the sections of a case that
    hold the bed; so does the final.csv of the last run."""
    runs, sections, top = [], "", 0.0
    for k, template in enumerate(templates):
        text = BATCH.format(template=template, count=batch, seed=1000 * seed + k, low=top + 2, high=top + 2 + fall, bed=sections,
                            picture="yes" if k + 1 == len(templates) else "no", **case)
        runs.append(Run(f"{name}_{k}", text, "--threads", "1", reuse=reuse))
        sections += bed(k, template, runs[-1])
        top = 1e3 * runs[-1].history["height_highest"][-1]
    return runs, sections


def heights(runs):
    """Final fill heights in mm, one row per run, one column per measure."""
    return np.array([[1e3 * run.history[column][-1] for column in MEASURES.values()] for run in runs])


def spread(runs):
    """Mean and, of several runs, standard deviation of every measure, as cells of a table."""
    table = heights(runs)
    if len(runs) == 1:
        return [f"{m:.2f}" for m in table[0]]
    return [f"{m:.2f} +- {s:.2f}" for m, s in zip(table.mean(axis=0), table.std(axis=0, ddof=1))]


def report(page: Page, runs, experiment, tolerance, total):
    """Table and plot of the fill heights (mm) beside the experiment. `runs`: a list of runs per name of their time step."""
    rows = []
    for label, group in runs.items():
        for k, (run, row) in enumerate(zip(group, heights(group))):
            rows.append([label, k + 1, *(f"{h:.2f}" for h in row), f"{run.summary['time']:.2f}",
                         run.summary["end"].replace("_", " "), f"{run.history['largest_relative_overlap'].max():.4f}"])
        if len(group) > 1:
            rows.append([label, "mean", *spread(group), "", "", ""])
    page.table(["time step", "seed", *(f"{m} [mm]" for m in MEASURES), "simulated [s]", "ended by", "largest overlap / radius"], rows)
    everything = [run for group in runs.values() for run in group]
    placed = min(len(run.final["x"]) for run in everything)
    page.claim(f"all {total} particles inside, in each of {len(everything)} runs ({placed})", placed == total)
    figure, axes = plt.subplots()
    axes.axhspan(experiment - tolerance, experiment + tolerance, color="0.85", label="experiment")
    for label, group in runs.items():
        for k, row in enumerate(heights(group)):
            axes.plot(row, marker="o", lw=0.7, ls=":", label=f"{label}, seed {k + 1}")
    axes.set(xticks=range(len(MEASURES)), xticklabels=MEASURES, ylabel="fill height [mm]")
    axes.legend()
    page.plot(figure, "", "Three ways to say how high the bed is")
