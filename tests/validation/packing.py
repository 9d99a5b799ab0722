# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the packing cases: a case of data/cases run with several seeds, its fill heights."""
import argparse
import concurrent.futures
import os

import numpy as np

from validation import ROOT, Page, Run, plt

MEASURES = {"highest point": "height_highest", "mean of the ten highest": "height_top_ten",
            "mean surface seen from above": "height_surface"}


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--reuse", action="store_true", help="take runs that are finished as they are")
    return parser.parse_args()


def pack(name, template, options, variant="", settings=(), kind=None):
    """Runs data/cases/NAME.ini once per seed, one core each, with `settings` (section.key=value) in place of its own;
    `kind` is the section of the particles, where its name is not the template's."""
    text = (ROOT / f"data/cases/{name}.ini").read_text()
    sets = [f"particles.{kind or template.stem}.template={template}", *settings]

    def one(seed):
        return Run(f"{name}{variant}_{seed}", text, "--threads", "1",
                   *(word for s in [f"run.seed={seed}", *sets] for word in ("--set", s)), reuse=options.reuse)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        return list(pool.map(one, range(1, options.seeds + 1)))


def heights(runs):
    """Final fill heights in mm, one row per run, one column per measure."""
    return np.array([[1e3 * run.history[column][-1] for column in MEASURES.values()] for run in runs])


def report(page: Page, runs, experiment, tolerance, total):
    """Table and plot of the fill heights beside the experiment (mm)."""
    table = heights(runs)
    rows = [[k + 1, *(f"{h:.2f}" for h in table[k]), f"{run.summary['time']:.2f}", run.summary["end"].replace("_", " "),
             f"{run.history['largest_relative_overlap'].max():.4f}"] for k, run in enumerate(runs)]
    rows.append(["mean", *(f"{h:.2f}" for h in table.mean(axis=0)), "", "", ""])
    page.table(["seed", *(f"{m} [mm]" for m in MEASURES), "simulated [s]", "ended by", "largest overlap / radius"], rows)
    placed = min(len(run.final["x"]) for run in runs)
    page.claim(f"all {total} particles inside ({placed})", placed == total)
    figure, axes = plt.subplots()
    axes.axhspan(experiment - tolerance, experiment + tolerance, color="0.85", label="experiment")
    for k, run in enumerate(runs):
        axes.plot(run.history["time"], 1e3 * run.history["height_highest"], lw=1, label=f"seed {k + 1}")
    axes.set(xlabel="time [s]", ylabel="highest point [mm]")
    axes.legend()
    page.plot(figure, "", "Highest point while the vessel is filled")
